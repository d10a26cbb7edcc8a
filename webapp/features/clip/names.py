"""Ids of the Clip page, what its stores hold, and the keys of its links."""

from typing import Annotated, Any, Literal, NotRequired, TypedDict

from webapp.shell.feature import LinkKey
from webapp.shell.identifiers import Id, Store
from webapp.shell.names import Name


class View(TypedDict, total=False):
    """What the chart shows."""

    chart: str
    angles: str
    joints: Annotated[str, LinkKey(of_dataset=True)]
    rig: str
    channels: str
    span: str


class ClipShown(TypedDict):
    """The clip that the page shows."""

    dataset: Name
    version: str
    clip: Name
    fps: float
    frames: int


class ClipChoice(TypedDict):
    """The joints and channels that the chart shows."""

    joints: list[str]
    channels: list[str]


class Bout(TypedDict):
    """A stretch of walking or running: frames ``[start, end)`` and its measures."""

    title: str
    facts: str
    start: int
    end: int
    rows: list[list[str]]  # name, unit, left, right, both, spread, asymmetry


class GaitTable(TypedDict):
    """The gait of a clip; ``why`` where there is none."""

    clip: str
    why: str
    head: list[str]
    bouts: list[Bout]
    events: list[tuple[int, str, str, str]]  # frame, seconds, side, name


class Moment(TypedDict):
    """A frame of a clip that someone chose in a list."""

    clip: Name
    frame: int
    at: NotRequired[float]


class ClipEdit(TypedDict):
    """An edit that is to be made."""

    action: Literal["trim", "mirror", "rate", "split", "labels"]
    frame: NotRequired[float]  # at the cursor
    at: NotRequired[float]


class ClipRepair(TypedDict):
    """A repair that is to be made of a clip of the dataset with this fingerprint."""

    dataset: Name
    version: str
    clip: Name
    action: Literal["fill", "smooth", "cut", "turn", "rescale", "mirror"]
    start: int
    end: int
    value: str
    at: NotRequired[float]


CLIP_PICKER = Id("clip-picker")
CLIP_PREVIOUS = Id("clip-previous")
CLIP_NEXT = Id("clip-next")
CLIP_NOTHING = Id("clip-nothing")
CLIP_BODY = Id("clip-body")
CLIP_FACTS = Id("clip-facts")
CLIP_SHOWN = Store("clip-shown", ClipShown)

CLIP_CHART = Id("clip-chart")
CLIP_KIND = Id("clip-kind")
CLIP_KIND_BOX = Id("clip-kind-box")
CLIP_CHANNELS = Id("clip-channels")
CLIP_CHANNELS_BOX = Id("clip-channels-box")
CLIP_JOINTS = Id("clip-joints")
CLIP_JOINTS_BOX = Id("clip-joints-box")
CLIP_CHOICE = Store("clip-choice", ClipChoice)

CLIP_LEGEND = Id("clip-legend")
CLIP_BOX = Id("clip-box")
CLIP_GRAPH = Id("clip-graph")
CLIP_RANGE = Id("clip-range")
CLIP_DRAWN = Store("clip-drawn", str)  # kind of the chart that is drawn
CLIP_MARKED = Store("clip-marked", Any)
CLIP_SOUGHT = Store("clip-sought", Any)
CLIP_SEEK = Store("clip-seek", Moment)

CLIP_DOUBTS = Id("clip-doubts")
CLIP_REPAIR = Store("clip-repair", ClipRepair)
CLIP_GAIT = Id("clip-gait")
CLIP_GAIT_TABLE = Store("clip-gait-table", GaitTable)
CLIP_GAIT_DRAWN = Store("clip-gait-drawn", Any)

CLIP_EDIT = Store("clip-edit", ClipEdit)
CLIP_EDIT_AT_FRAME = Store("clip-edit-at-frame", ClipEdit)
CLIP_EDIT_MENU = Id("clip-edit-menu")
CLIP_EDIT_DIALOG = Id("clip-edit-dialog")
CLIP_EDIT_SAYS = Id("clip-edit-says")
CLIP_EDIT_WHERE = Id("clip-edit-where")
CLIP_EDIT_FPS = Id("clip-edit-fps")
CLIP_EDIT_FRAME = Id("clip-edit-frame")
CLIP_EDIT_NAME = Id("clip-edit-name")
CLIP_EDIT_EFFECT = Id("clip-edit-effect")
CLIP_EDIT_PROBLEM = Id("clip-edit-problem")
CLIP_EDIT_DO = Id("clip-edit-do")

CLIP_TABLE_OPEN = Id("clip-table-open")
CLIP_TABLE_DIALOG = Id("clip-table-dialog")
CLIP_TABLE_COLUMNS = Id("clip-table-columns")
CLIP_TABLE_JOINTS = Id("clip-table-joints")
CLIP_TABLE_FRAMES = Id("clip-table-frames")
CLIP_TABLE_WHAT = Id("clip-table-what")
CLIP_TABLE_LINK = Id("clip-table-link")
