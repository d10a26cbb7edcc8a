"""Ids of the Search page, what its stores hold, and the keys of its links."""

from typing import Annotated, Any, NotRequired, TypedDict

from webapp.shell.feature import LinkKey
from webapp.shell.identifiers import Id, Store
from webapp.shell.names import MethodNames, Name, StageRequest
from webapp.shell.shapes import Most

_TEXT = LinkKey(of_dataset=True, free_text=True)


class View(TypedDict, total=False):
    """What is searched for (see searching.py), the hit that is chosen, and the view."""

    query: Annotated[str, _TEXT]
    parts: str
    level: str
    route: str
    label: Annotated[str, _TEXT]
    named: Annotated[str, _TEXT]
    lasting: str
    top: str
    hit: Annotated[str, _TEXT]
    look: str
    study: str
    asks: Annotated[str, _TEXT]
    measure: str
    words: Annotated[str, _TEXT]
    seen: str


class Choice(TypedDict):
    """A choice of a menu."""

    value: str
    label: str


class Body(TypedDict):
    """The hierarchy of the body and its words."""

    leaves: list[str]
    words: dict[str, str]
    nodes: dict[str, list[str]]  # node -> its leaves


class Clips(TypedDict):
    """The clips and actions there are to choose from."""

    dataset: Name
    version: str
    clips: list[tuple[str, int]]  # name, frames; of thousands those that have what was typed
    actions: list[str]


class MotifChoice(TypedDict):
    """A motif that can be looked for."""

    name: str
    motions: int
    query: str


class PieceRow(TypedDict):
    """One piece of the query."""

    clip: str
    dataset: str  # "" where it is the one that is searched
    source: str
    version: str
    start: int
    end: int
    frames: int
    fps: float
    leaves: list[str]
    gives: str
    colour: str
    labels: list[tuple[int, int, str]]


class HitRow(TypedDict):
    """One hit."""

    name: str
    rank: int
    clip: str
    start: int
    end: int
    when: str
    score: float
    label: str
    strip: str


class Strip(TypedDict):
    """How alike the parts of the body are over the query's time: a row for each leaf."""

    rows: list[list[int]]  # percent, -1 where it is not known
    means: list[float | None]  # of the rows, 0 to 1


class Reason(TypedDict):
    """Why a hit is one, and the request that plays it beside the query."""

    strip: Strip
    request: StageRequest


class Found(TypedDict):
    """The query and its hits, or why there are none."""

    inputs: dict[str, str | None]  # the keys of the link that say what is searched for, and where
    pieces: NotRequired[list[PieceRow]]
    level: NotRequired[str]
    request: NotRequired[StageRequest]
    hits: NotRequired[list[HitRow]]
    total: NotRequired[int]
    unlike: NotRequired[int]  # clips left out because they are too unlike
    chances: NotRequired[bool]  # whether scores are chances
    milliseconds: NotRequired[float]
    doubt: NotRequired[str]
    error: NotRequired[str]


class Upload(TypedDict):
    """A recording that has arrived."""

    token: Name
    name: Name


class Reading(TypedDict):
    """The job that reads a recording."""

    job: int


class ListChoice(TypedDict):
    """A setting that is a list of names: its key in the view, the names there are, and what is usual."""

    key: str
    names: list[str]
    usual: str


class Person(TypedDict, total=False):
    """Who answers in this browser."""

    id: Name
    name: Name


class Answer(TypedDict):
    """A rating of a hit, or a choice between two."""

    kind: str
    query: Name
    hit: NotRequired[Name]
    left: NotRequired[Name]
    right: NotRequired[Name]
    value: NotRequired[int]
    choice: NotRequired[str]
    person: NotRequired[Name | None]
    id: NotRequired[Name]


class Answers(TypedDict):
    """Answers that the server has not confirmed."""

    answers: Annotated[list[Answer], Most(2000)]
    at: NotRequired[float]


class ReceivedAnswers(TypedDict, total=False):
    """Ids of answers that the server has received."""

    received: list[str | None]
    at: float | None


class Wish(TypedDict, total=False):
    """A task for the server, one of these."""

    build: str  # the index of an engine
    draw: int  # queries, with this seed
    clear: bool  # all answers
    at: float


class Engine(TypedDict):
    """An engine of the study."""

    method: str
    label: str
    ready: bool


class StudyQuery(TypedDict):
    """A query of the study."""

    name: str
    clip: str
    when: str
    strip: str


class Question(TypedDict):
    """A pair to be rated, or a duel to be decided, and the answer that was given."""

    query: str
    request: StageRequest
    value: int | str | None
    hit: NotRequired[str]
    left: NotRequired[str]
    right: NotRequired[str]


class StudyInputs(TypedDict):
    """What a study was gathered from."""

    dataset: Name
    link: dict[str, str]  # keys of the link that matter, with their values
    person: Name
    finished: str  # which jobs had ended


class Study(TypedDict):
    """What the browser shows of the study, or why there is nothing to show."""

    inputs: StudyInputs
    error: NotRequired[str]
    engines: NotRequired[list[Engine]]
    queries: NotRequired[list[StudyQuery]]
    pairs: NotRequired[list[Question]]
    duels: NotRequired[list[Question]]


METHOD = MethodNames("search")

SEARCH_MENUS = Id("search-menus")
SEARCH_LOOK = Id("search-look")
SEARCH_ERROR = Id("search-error")
SEARCH_HITS_HEAD = Id("search-hits-head")
SEARCH_HITS = Id("search-hits")
SEARCH_SOURCES = Id("search-sources")
SEARCH_CLIP_NAMES = Id("search-clip-names")
SEARCH_MOTIF = Id("search-motif")
SEARCH_WARNING = Id("search-warning")
SEARCH_COUNTS = Id("search-counts")
SEARCH_COUNTS_SAYS = Id("search-counts-says")
SEARCH_WANTED = Id("search-wanted")
SEARCH_BODY = Id("search-body")
SEARCH_OPTIONS = Id("search-options")
# made in the browser
SEARCH_PRESET = Id("search-preset")
SEARCH_ENGINE = Id("search-engine")
SEARCH_LEVEL = Id("search-level")
SEARCH_ROUTE = Id("search-route")
SEARCH_LABEL = Id("search-label")
SEARCH_NAMED = Id("search-named")
SEARCH_SHORTEST = Id("search-shortest")
SEARCH_LONGEST = Id("search-longest")

SEARCH_ENGINES = Store("search-engines", list[Choice])
SEARCH_PRESETS = Store("search-presets", dict[str, dict[str, float]])
SEARCH_PARTS = Store("search-parts", Body)
SEARCH_CLIPS = Store("search-clips", Clips)
SEARCH_TYPED = Store("search-typed", str)  # a part of the name of a clip that is looked for
SEARCH_MOTIFS = Store("search-motifs", list[MotifChoice])
SEARCH_FOUND = Store("search-found", Found)
SEARCH_DRAWN = Store("search-drawn", Any)
SEARCH_LISTED = Store("search-listed", Any)

SEARCH_UPLOAD = Store("search-upload", Upload)
SEARCH_UPLOAD_JOB = Store("search-upload-job", Reading)
SEARCH_UPLOAD_DONE = Store("search-upload-done", Any)
SEARCH_UPLOAD_STATUS = Id("search-upload-status")

SEARCH_STORAGE = Id("search-storage")

SEARCH_WORDS = Id("search-words")
SEARCH_WORDS_LEVEL = Id("search-words-level")
SEARCH_WORDS_FOUND = Id("search-words-found")

SEARCH_STUDY = Id("search-study")
STUDY_SETUP = Id("study-setup")
STUDY_RATE = Id("study-rate")
STUDY_VOTE = Id("study-vote")
STUDY_RESULTS = Id("study-results")
STUDY_NAME = Id("study-name")  # made in the browser
STUDY_CHART = Id("study-chart")
STUDY_DATA = Store("study-data", Study)
STUDY_DRAWN = Store("study-drawn", Any)
STUDY_ANSWER = Store("study-answer", Answers)
STUDY_RECEIVED = Store("study-received", ReceivedAnswers)
STUDY_WISH = Store("study-wish", Wish)
STUDY_PERSON = Store("study-person", Person)

RANKING = MethodNames("ranking")
RANKING_ENGINES = Id("ranking-engines")
RANKING_ENGINES_OF = Store("ranking-engines-of", ListChoice)
RANKING_RESULT = Id("ranking-result")
RANKING_REGIME = Id("ranking-regime")
RANKING_CONFUSED = Id("ranking-confused")
RANKING_CURVES = Id("ranking-curves")
RANKING_CONFUSION = Id("ranking-confusion")
