"""Ids of the Motifs page, what its stores hold, and the keys of its links."""

from typing import Annotated, Any, Literal, NotRequired, TypedDict

from webapp.shell.feature import LinkKey
from webapp.shell.identifiers import Family, Group, Id, Store
from webapp.shell.names import Colour, Name, Selection, StageRequest

_OF_DATASET = LinkKey(of_dataset=True)


class View(TypedDict, total=False):
    """The views below and beside the graph, and what is chosen in them."""

    view: str
    side: str
    walk: Annotated[str, _OF_DATASET]
    weights: Annotated[str, _OF_DATASET]
    other: Annotated[str, _OF_DATASET]
    gained: Annotated[str, _OF_DATASET]
    extra: str
    gaps: str
    ends: str
    feet: str
    stability: str
    step: str


class MotionRow(TypedDict):
    """A motion of the selected motif, or a transition of the selected edge."""

    clip: str
    brief: str
    when: str
    strip: str
    selection: Selection
    chosen: bool


class Motions(TypedDict, total=False):
    """The motions of what is selected; empty where nothing is."""

    name: str
    rows: list[MotionRow]
    more: int  # that are not among the rows


class GraphTool(TypedDict):
    """How the view of the graph is to change: "in", "out" or "fit"."""

    graph: str
    at: NotRequired[float]


class GraphPart(TypedDict):
    """What is drawn of a large graph: a part of it, and around which motif."""

    part: str
    centre: int | None


class TimelineRow(TypedDict):
    """A clip, in seconds."""

    clip: str
    brief: str
    fps: float
    seconds: float
    share: float  # of its frames in motifs
    motions: list[tuple[float, float, int, int]]  # start, end, motif, number
    labels: list[tuple[float, float, int]]  # start, end, number of the action


class TimelineMotif(TypedDict):
    """A motif in the timeline."""

    name: str
    colour: str
    motions: int


class Timeline(TypedDict):
    """Every clip with its labels and motifs."""

    dataset: str
    rows: list[TimelineRow]
    motifs: dict[str, TimelineMotif]
    actions: list[str]
    colours: list[str]  # of the actions
    drawing: str  # its address


class BlendMotion(TypedDict):
    """A motion that can be mixed, and its seconds at moments of the reference."""

    motion: int
    clip: str
    brief: str
    start: int
    end: int
    fps: float
    when: str
    seconds: list[float]


class BlendBody(TypedDict):
    """Motions of one body."""

    motions: list[BlendMotion]
    chosen: list[int]
    reference: int


class BlendData(TypedDict):
    """What can be mixed of a motif; only the first two where nothing can."""

    key: Name
    motif: int | None
    title: NotRequired[str]
    total: NotRequired[int]
    dataset: NotRequired[str]
    version: NotRequired[str]
    most: NotRequired[int]
    bodies: NotRequired[list[BlendBody]]
    middles: NotRequired[StageRequest]
    together: NotRequired[StageRequest | None]


class WalkMotif(TypedDict):
    """A motif that a walk can pass."""

    id: int
    name: str


class WalkData(TypedDict):
    """The ways of the graph, and the walk of the link or why there is none."""

    key: Name
    inputs: dict[str, str]  # the keys of the link that say which walk it is
    dataset: NotRequired[str]
    motifs: NotRequired[list[WalkMotif]]
    error: NotRequired[str]
    dead: NotRequired[list[int]]
    parts: NotRequired[list[int]]
    further: NotRequired[list[tuple[int, int]]]
    gap: NotRequired[tuple[int, int]]
    detour: NotRequired[list[int]]
    name: NotRequired[str]  # of the made-up data set
    path: NotRequired[list[int]]
    kinds: NotRequired[list[str]]
    visits: NotRequired[list[tuple[int, int]]]
    frames: NotRequired[int]
    seconds: NotRequired[float]
    blends: NotRequired[int]
    # metres a second: sliding of standing feet in the recordings, after blending alone, and in the walk
    skate: NotRequired[tuple[float, float, float]]
    speeds: NotRequired[tuple[float, float]]  # of the fastest joint, in the blends and in the recordings
    jump: NotRequired[bool]  # a blend is faster than anything in the recordings
    warnings: NotRequired[list[str]]
    bands: NotRequired[list[Colour]]
    unseen: NotRequired[int]
    recipes: NotRequired[dict[str, str]]


class FlowBar(TypedDict):
    """A motif of one of two results that are compared, as high as the motion in it."""

    side: Literal["a", "b"]
    motif: int | None  # None: in no motif
    label: str
    y: float
    h: float
    change: str | None
    title: str


class FlowRibbon(TypedDict):
    """Motion that a motif of each result shares."""

    a: int | None
    b: int | None
    ya: float
    yb: float
    h: float
    kind: Literal["kept", "linked", "rest"]
    title: str


class Flow(TypedDict):
    """How the motion of one result is found again in another, in pixels."""

    height: float
    bars: list[FlowBar]
    ribbons: list[FlowRibbon]


class OtherResult(TypedDict):
    """Settings of the other result, as the link has them, that is to be computed."""

    other: str
    at: NotRequired[float]


class MotifStability(TypedDict):
    """How often a motif was found again: its mean share over the kinds of repeat, in how many, and each kind."""

    overall: float
    kept: int
    noise: NotRequired[float]
    seed: NotRequired[float]
    parameters: NotRequired[float]


class StabilityData(TypedDict):
    """How often the motifs were found again, by motif."""

    repeats: int
    motifs: dict[str, MotifStability]


class OnDemandNames(Group):
    """Ids of a part that is computed on demand; ``name`` is its view."""

    def __init__(self, name: str, place: str):
        self.place = Id(place)  # what it fills
        self.find = Store(f"{name}-find", dict[str, bool | float])
        self.job = Store(f"{name}-job", int)  # the job that computes it
        self.shown = Store(f"{name}-shown", list[Any])  # what the place was last drawn for


MOTIF_MENUS = Id("motif-menus")
MOTIF_RESULT = Id("motif-result")
MOTIFS_DRAWN = Store("motifs-drawn", Name)  # key of the result that is drawn
MOTIF_GRAPH = Id("motif-graph")
EDGE_FILTER_LABEL = Id("edge-filter-label")
GRAPH_PART = Id("graph-part")
GRAPH_PART_WORDS = Id("graph-part-words")
GRAPH_SOUGHT = Store("graph-sought", dict[str, float])  # something was chosen that is not drawn; {"at": when}
GRAPH_PART_SHOWN = Store("graph-part-shown", GraphPart)
EDGE_THRESHOLD = Id("edge-threshold")
GRAPH_TOOL = Store("graph-tool", GraphTool)
GRAPH_TAPPED = Store("graph-tapped", Any)
GRAPH_MARKED = Store("graph-marked", Any)
SWITCHES = Family("motif-{}", ("view", "side"))

MOTIF_SEARCH = Id("motif-search")
MOTIF_TABLE = Id("motif-table")
MOTIF_TABLE_PLACE = Id("motif-table-place")
MOTIFS_MARKED = Store("motifs-marked", Any)
MOTIFS_SEARCHED = Store("motifs-searched", Any)
MOTIF_SELECTION = Id("motif-selection")
MOTION_LIST = Id("motion-list")
MOTIONS = Store("motions", Motions)

TIMELINE_ORDER = Id("timeline-order")
TIMELINE_SCALE = Id("timeline-scale")
TIMELINE_LEGEND = Id("timeline-legend")
TIMELINE_ROWS = Id("timeline-rows")
TIMELINE_DATA = Store("timeline-data", Timeline)
TIMELINE_DRAWN = Store("timeline-drawn", Any)
TIMELINE_MARKED = Store("timeline-marked", Any)

REPORT = OnDemandNames("report", "report-body")
REPORT_CHART = Id("report-chart")

COMPARE_OTHER = Id("compare-other")
COMPARE_STATUS = Id("compare-status")
COMPARE_RESULT = Id("compare-result")
COMPARE_SENTENCE = Id("compare-sentence")
COMPARE_FLOW = Id("compare-flow")
COMPARE_FILTER = Id("compare-filter")
COMPARE_AGAIN = Id("compare-again")
COMPARE_TABLE = Id("compare-table")
COMPARE_STATUS_OF = Store("compare-status-of", list[Any])  # what the status was last drawn for
COMPARE_KEYS = Store("compare-keys", tuple[Name, Name])  # of both results, where both are there
COMPARE_FLOW_DATA = Store("compare-flow-data", Flow)
COMPARE_REQUEST = Store("compare-request", StageRequest)
COMPARE_FIND = Store("compare-find", OtherResult)
COMPARE_STARTED = Store("compare-started", Any)
COMPARE_DRAWN = Store("compare-drawn", Any)
COMPARE_MARKED = Store("compare-marked", Any)
COMPARE_ROW_MARKED = Store("compare-row-marked", Any)

COMPRESSION = OnDemandNames("compression", "compression-whole")
COMPRESSION_TITLE = Id("compression-title")
COMPRESSION_MEASURE = Id("compression-measure")
COMPRESSION_SENTENCE = Id("compression-sentence")
COMPRESSION_MOTIF = Id("compression-motif")
COMPRESSION_CHART = Id("compression-chart")
COMPRESSION_STEP = Id("compression-step")
COMPRESSION_MOTION = Id("compression-motion")
COMPRESSION_ALL = Id("compression-all")
COMPRESSION_OF = Store("compression-of", list[Any])  # what the chart was last drawn for

BLEND_HINT = Id("blend-hint")
BLEND_PANEL = Id("blend-panel")
BLEND_TITLE = Id("blend-title")
BLEND_COUNT = Id("blend-count")
BLEND_CONTROLS = Id("blend-controls")
BLEND_BVH = Id("blend-bvh")
BLEND_NOTE = Id("blend-note")
BLEND_DATA = Store("blend-data", BlendData)
BLEND_DRAWN = Store("blend-drawn", Any)

WALK_TITLE = Id("walk-title")
WALK_LENGTH = Id("walk-length")
WALK_HINT = Id("walk-hint")
WALK_PATH = Id("walk-path")
WALK_ERROR = Id("walk-error")
WALK_METERS = Id("walk-meters")
WALK_BVH = Id("walk-bvh")
WALK_JSON = Id("walk-json")
WALK_NOTES = Id("walk-notes")
WALK_ADD = Id("walk-add")
WALK_FROM = Id("walk-from")
WALK_TO = Id("walk-to")
WALK_SECONDS = Id("walk-seconds")
WALK_SEED = Id("walk-seed")
WALK_EXTRA = Id("walk-extra")
WALK_BRIDGE = Id("walk-bridge")
WALK_STOP = Id("walk-stop")
WALK_FEET = Id("walk-feet")
WALK_WAYS = Id("walk-ways")
WALK_DATA = Store("walk-data", WalkData)
WALK_DRAWN = Store("walk-drawn", Any)

NOTES_HINT = Id("notes-hint")
NOTES_FORM = Id("notes-form")
NOTES_TITLE = Id("notes-title")
NOTES_NAME = Id("notes-name")
NOTES_TAGS = Id("notes-tags")
NOTES_TEXT = Id("notes-text")
NOTES_STATUS = Id("notes-status")
NOTES_MOTIF = Store("notes-motif", int)  # the motif of the form
NOTES_NAMES = Store("notes-names", dict[str, tuple[str, list[str], str]])  # motif -> name, tags, note
NOTES_DRAWN = Store("notes-drawn", Any)

STABILITY_BUTTON = Id("stability-button")
STABILITY_NUMBERS = Family("stability-{}", ("repetitions", "noise_degrees"))
STABILITY_STATUS = Id("stability-status")
STABILITY_SHOW = Id("stability-show")
STABILITY_HIDE = Id("stability-hide")
STABILITY_LEGEND = Id("stability-legend")
STABILITY_WORDS = Id("stability-words")
STABILITY_DATA = Store("stability-data", StabilityData)
STABILITY_OF = Store("stability-of", list[Any])  # what the status was last drawn for
STABILITY_DRAWN = Store("stability-drawn", Any)
STABILITY_LISTED = Store("stability-listed", Any)
