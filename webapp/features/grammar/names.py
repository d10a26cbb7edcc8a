"""Ids of the Grammar page, what its stores hold, and the keys of its links."""

from typing import Annotated, Any, NotRequired, TypedDict

from webapp.shell.feature import LinkKey
from webapp.shell.identifiers import Family, Id, Prefix, Store
from webapp.shell.names import Colour, MethodNames, Name
from webapp.shell.shapes import Most

_NUMBER = LinkKey(of_dataset=True, pattern=r"\d{1,6}")


class View(TypedDict, total=False):
    """The view below the recordings, and what is chosen in it."""

    show: str
    routine: Annotated[str, _NUMBER]
    sentence: Annotated[str, LinkKey(of_dataset=True)]
    pick: Annotated[str, _NUMBER]
    up: Annotated[str, _NUMBER]
    alt: Annotated[str, _NUMBER]
    counts: str


class Action(TypedDict):
    """An action of the recordings."""

    id: int
    name: str
    short: str
    named: bool
    hint: str  # the label of most of it
    colour: str
    ink: str
    count: int
    seconds: float  # the mean
    clips: int
    label: str
    strip: str
    icon: str


class Row(TypedDict):
    """A recording as a string of actions, in seconds."""

    clip: str
    brief: str
    fps: float
    seconds: float
    pieces: list[tuple[float, float, int, int]]  # start, end, action, number among the action's segments
    cuts: list[float]  # where routines begin
    labels: list[tuple[float, float, str]]


class Way(TypedDict):
    """What may stand for a phrase: actions as numbers, phrases as their ids."""

    parts: list[int | str]
    count: int


class Phrase(TypedDict):
    """A phrase and all that may stand for it."""

    id: str
    name: str
    seen: int
    cyclic: bool  # it can occur inside itself
    ways: list[Way]


class Routine(TypedDict):
    """A stretch of a recording that obeys the rules as a whole."""

    clip: str
    seconds: tuple[float, float]
    actions: list[int]
    leaves: list[tuple[int, int]]  # frames of the clip's own rate


class GrammarData(TypedDict):
    """What is drawn of a result, except trees and new routines."""

    key: Name
    dataset: Name
    version: str
    names: str  # changes whenever an action gets another name
    actions: list[Action]
    rows: list[Row]
    rules: list[Phrase]
    routines: list[Routine]


class RoutineData(TypedDict):
    """The routine that is shown, with its tree as a drawing."""

    key: Name
    number: int
    svg: Annotated[str, Most(10_000_000)]


class Part(TypedDict):
    """The part of a new routine that is chosen: its path in the tree, and its actions ``[first, end)``."""

    at: list[int]
    path: str
    first: int
    end: int
    name: str
    ways: int  # rules for it
    varies: bool  # there is another way for it or for a part of it
    larger: bool
    smaller: bool


class Composed(TypedDict, total=False):
    """The new routine of the link and its motion, or why there is none."""

    key: str
    inputs: dict[str, str]  # the keys of the link that say which routine it is, and its chosen part
    error: str
    name: str  # of the made-up data set
    clip: str
    actions: list[int]
    spans: list[tuple[int, int]]  # frames of each action
    frames: int
    seconds: float
    # metres a second: sliding of standing feet in the recordings, after blending alone, and in the routine
    skate: tuple[float, float, float]
    speeds: tuple[float, float]  # of the fastest joint, in the blends and in the recordings
    jump: bool  # a blend is faster than anything in the recordings
    warnings: list[str]
    bands: list[Colour]
    novel: bool
    recipes: dict[str, str]
    code: str
    svg: Annotated[str, Most(10_000_000)]
    chosen: Part | None
    parents: list[str]  # of every action: path of the smallest phrase around it


class Other(TypedDict):
    """Another way for the chosen part of a new routine."""

    code: str
    name: str
    clip: str
    actions: list[int]
    first: int
    end: int
    start: int
    stop: int
    seconds: float
    bands: list[Colour]


class Others(TypedDict):
    """Other ways for the chosen part, or why there are none."""

    inputs: dict[str, str]
    error: NotRequired[str]
    part: NotRequired[str]
    others: NotRequired[list[Other]]


class BakeoffPlay(TypedDict, total=False):
    """The way of making motion that is to be played; all, where none is named."""

    only: str
    at: float


METHOD = MethodNames("grammar")

GRAMMAR_MENUS = Id("grammar-menus")
GRAMMAR_RESULT = Id("grammar-result")
GRAMMAR_STRING = Id("grammar-string")
GRAMMAR_SHOW = Id("grammar-show")
GRAMMAR_RULES = Id("grammar-rules")
PHRASE = Prefix("phrase-")  # made in the browser
GRAMMAR_DATA = Store("grammar-data", GrammarData)
GRAMMAR_NAMES = Store("grammar-names", Name)
GRAMMAR_DRAWN = Store("grammar-drawn", Any)

ACTION_ORDER = Id("action-order")
ACTION_CARDS = Id("action-cards")
ACTION_HINT = Id("action-hint")
ACTION_DETAIL = Id("action-detail")
ACTION_TITLE = Id("action-title")
ACTION_COUNT = Id("action-count")
ACTION_ALL = Id("action-all")
ACTION_NAME = Id("action-name")
ACTION_NAME_STATUS = Id("action-name-status")
ACTION_NAMED = Store("action-named", int)  # the action that the field names
OCCURRENCES = Id("occurrences")

ROUTINE_LIST = Id("routine-list")
ROUTINE_TITLE = Id("routine-title")
ROUTINE_COUNT = Id("routine-count")
ROUTINE_PLAY = Id("routine-play")
ROUTINE_SVG = Id("routine-svg")
ROUTINE_TREE = Id("routine-tree")
ROUTINE_DATA = Store("routine-data", RoutineData)
ROUTINE_DRAWN = Store("routine-drawn", Any)

COMPOSE_ERROR = Id("compose-error")
COMPOSE_STATUS = Id("compose-status")
COMPOSE_STRING = Id("compose-string")
COMPOSE_CHOSEN = Id("compose-chosen")
COMPOSE_OTHERS = Id("compose-others")
COMPOSE_TREE = Id("compose-tree")
COMPOSE_METERS = Id("compose-meters")
COMPOSE_WARNINGS = Id("compose-warnings")
COMPOSE_MOST = Id("compose-most")
COMPOSE_BVH = Id("compose-bvh")
COMPOSE_JSON = Id("compose-json")
COMPOSE_SVG = Id("compose-svg")
COMPOSE_NAME = Id("compose-name")
COMPOSE_SAVE = Id("compose-save")
COMPOSE_SAVE_STATUS = Id("compose-save-status")
COMPOSE_DATA = Store("compose-data", Composed)
COMPOSE_DRAWN = Store("compose-drawn", Any)
COMPOSE_OTHER_DATA = Store("compose-other-data", Others)
COMPOSE_OTHER_DRAWN = Store("compose-other-drawn", Any)

TUNE_ACTIONS = Id("tune-actions")
TUNE_WEIGHT = Id("tune-weight")
TUNE_LABELS = Family("{}-label", (TUNE_ACTIONS, TUNE_WEIGHT))
TUNE_LEARN = Id("tune-learn")
TUNE_COUNTS = Id("tune-counts")
TUNE_RUN = Id("tune-run")
TUNE_PLAN = Id("tune-plan")
TUNE_STATUS = Id("tune-status")
TUNE_STATUS_OF = Store("tune-status-of", list[Any])  # what the status was last drawn for
TUNE_SEEN = Store("tune-seen", list[str])  # keys of the results that are there
TUNE_RESULT = Id("tune-result")
TUNE_QUALITY = Id("tune-quality")
TUNE_RULES = Id("tune-rules")
TUNE_TABLE = Id("tune-table")
TUNE_TABLE_PLACE = Id("tune-table-place")

BAKEOFF_PLACE = Id("bakeoff-place")
BAKEOFF_CHART = Id("bakeoff-chart")
BAKEOFF_TABLE = Id("bakeoff-table")
BAKEOFF_RUN = Store("bakeoff-run", dict[str, bool | float])
BAKEOFF_JOB = Store("bakeoff-job", int)
BAKEOFF_SHOWN = Store("bakeoff-shown", list[Any])  # what the place was last drawn for
BAKEOFF_PLAY = Store("bakeoff-play", BakeoffPlay)
