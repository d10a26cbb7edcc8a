"""Ids of the Map page, what its stores hold, and the keys of its links."""

from typing import Annotated, Any, NotRequired, TypedDict

from webapp.shell.feature import LinkKey
from webapp.shell.identifiers import Family, Id, Store
from webapp.shell.names import MethodNames, Name


class View(TypedDict, total=False):
    """The keys and the path that are searched for, and how the map is drawn."""

    keys: Annotated[str, LinkKey(of_dataset=True, pattern=r"\d{1,4}-\d{1,4}(,\d{1,4}-\d{1,4})*")]
    drawn: Annotated[str, LinkKey(of_dataset=True, pattern=r"[\d.]{1,8}-[\d.]{1,8}(,[\d.]{1,8}-[\d.]{1,8})+")]
    within: str
    pace: str
    way: str
    colour: str
    click: str
    below: str
    region: Annotated[str, LinkKey(of_dataset=True, pattern=r"\d{1,6}")]


class Facts(TypedDict):
    """What the page tells of each node beside its posture."""

    names: list[str]  # of labels
    labels: list[list[tuple[int, float]]]  # per node: number of the label and seconds, most first


class KnownMap(TypedDict):
    """The map that is shown."""

    key: Name
    dataset: Name
    version: str
    facts: Facts


class MapClip(TypedDict):
    """A clip that a map was made of."""

    name: str
    frames: int
    fps: float
    fit: float  # mean distance of its postures to the map, as a multiple of what is usual


class MapHeader(TypedDict):
    """The part of a map's file that is JSON (see routes.py); nodes are numbered along the second axis of the grid."""

    grid: tuple[int, int]
    joints: list[str]
    roles: list[str]
    sides: list[str]  # "left", "right" or "centre"
    parents: list[int]
    lengths: list[float]  # of the bones, in metres
    clips: list[MapClip]
    fps: float  # frames a second at which the clips were laid on the map
    regions: list[int]  # of the nodes
    icons: list[tuple[int, int]]  # the node of each region whose posture is drawn
    usual: float  # mean distance of a posture to its node
    runs: int  # stretches of frames at one node


class Look(TypedDict, total=False):
    """Those parts of the view that the server draws by."""

    colour: str
    below: str
    region: str


class Lit(TypedDict):
    """Nodes that the selected motifs pass."""

    nodes: list[int]


class Extend(TypedDict):
    """The earlier map that these clips are to be laid on: key of its result."""

    model: Name
    at: NotRequired[float]


METHOD = MethodNames("map")

MAP_MENUS = Id("map-menus")
MAP_MORE = Id("map-more")
MAP_RESULT = Id("map-result")
MAP_PLOT = Id("map-plot")
MAP_GRAPH = Id("map-graph")
MAP_PAINTED = Store("map-painted", list[str | None])  # what the map was last drawn for
MAP_LEGEND = Id("map-legend")
MAP_EXPLANATION = Id("map-explanation")
MAP_CONTROLS = Family("map-{}", ("colour", "click", "pace", "way"))
MAP_BELOW = Id("map-below")

MAP_PREVIEW = Id("map-preview")
MAP_KEYS = Id("map-keys")
MAP_REACH = Id("map-reach")  # made in the browser
MAP_REACH_LABEL = Id("map-reach-label")
MAP_REACH_BOX = Id("map-reach-box")
MAP_REACH_VALUE = Id("map-reach-value")
MAP_COUNT = Id("map-count")
MAP_PLAY_ALL = Id("map-play-all")
MAP_HITS = Id("map-hits")

MAP_EDITOR = Id("map-editor")  # made in the browser
MAP_EDITOR_TITLE = Id("map-editor-title")

MAP_MULTIPLES = Id("map-multiples")
MAP_MULTIPLES_GRAPH = Id("map-multiples-graph")
MAP_CLIPS_PLACE = Id("map-clips-place")
MAP_CLIPS = Id("map-clips")
MAP_REGION = Id("map-region")

MAP_KNOWN = Store("map-known", KnownMap)
MAP_LOOK = Store("map-look", Look)
MAP_LIT = Store("map-lit", Lit)
MAP_EXTEND = Store("map-extend", Extend)
MAP_LOADED = Store("map-loaded", Any)
MAP_SHOWN = Store("map-shown", Any)
MAP_DRAWN = Store("map-drawn", Any)
MAP_MARKED = Store("map-marked", Any)
