"""Ids of the Library page, what its stores hold, and the keys of its links."""

from typing import Any, Literal, NotRequired, TypedDict

from webapp.shell.identifiers import Id, Pattern, Store
from webapp.shell.names import Name


class View(TypedDict, total=False):
    """The tab that is open, and the files of the report that are listed."""

    tab: str
    files: str


class DatasetAction(TypedDict):
    """What is to be done with a data set, or with the trash."""

    action: Literal["rename", "trash", "empty", "analyse"]
    dataset: NotRequired[Name]
    at: NotRequired[float]


class ClipsAction(TypedDict):
    """What is to be done with the clips that are chosen in the table."""

    action: Literal["remove", "clear", "reread", "repair", "properties", "all"]
    at: NotRequired[float]


class ClipsAll(TypedDict):
    """All clips of a data set are chosen that the filters of their table, AG Grid's own, leave."""

    dataset: Name
    filter: dict[str, Any]


class UploadInto(TypedDict):
    """The data set that the dialog is opened for."""

    dataset: Name
    at: NotRequired[float]


class ClipsOf(TypedDict):
    """Clips of a data set that a dialog is about; all of them where none is named."""

    dataset: Name
    clips: NotRequired[list[str]]
    at: NotRequired[float]


class BodyOf(TypedDict):
    """The data set whose bodies are to be edited."""

    dataset: Name
    at: NotRequired[float]


class BodyRig(TypedDict):
    """Clips whose joints have the same names: which part of the body each joint is, and what someone said about it."""

    names: list[str]
    parents: list[int]
    ends: list[bool]
    joints: dict[str, str]
    said: dict[str, str | None]
    suggested: dict[str, str]
    body: str
    said_body: str | None
    words: str


class BodyRigs(TypedDict):
    """The rigs of a data set, the parts of a body, and the format of corrections in files."""

    dataset: Name
    parts: list[str]
    format: str
    rigs: list[BodyRig]
    at: float | None


class BodyPosture(TypedDict):
    """Places of all joints in two drawings; frame -1 is the rest pose."""

    rig: int
    clip: Name
    frame: int
    front: list[list[float]]
    side: list[list[float]]


class BodySaid(TypedDict):
    """What is to be said of a rig."""

    changed: bool
    joints: dict[str, str | None]
    body: str | None


class BodyDraft(TypedDict):
    """What is to be said of all rigs of a data set."""

    dataset: Name
    rigs: list[BodySaid]


class BodyFile(TypedDict):
    """A file of corrections that someone chose."""

    text: str
    at: float


class BodyFileSaid(TypedDict):
    """What a file says of a rig."""

    joints: dict[str, str | None]
    body: str | None


class BodyFilled(TypedDict):
    """What a file of corrections says of each rig; null where it says nothing."""

    rigs: list[BodyFileSaid | None]
    at: float | None


class Upload(TypedDict, total=False):
    """What has arrived of the files of an upload, and of which kinds they are."""

    token: Name | None
    received: int
    total: int
    done: bool
    name: Name
    recordings: int
    labels: int
    amc: int
    archives: int


class ReportRow(TypedDict):
    """A file of the import report."""

    key: str
    verdict: Literal["ok", "warning", "error"]
    added: bool  # with the newest addition
    name: str
    path: str
    messages: str
    selection: NotRequired[dict[str, str]]


class FeaturesChoice(TypedDict):
    """Features of a data set that someone waits for."""

    dataset: Name
    suffix: Literal[".npz", ".parquet"]
    job: NotRequired[int]
    at: NotRequired[float]


class Download(TypedDict):
    """Where a file that is ready is downloaded from."""

    address: str
    at: float | None


DATASET_CARDS = Id("dataset-cards")
DATASET_DETAIL = Id("dataset-detail")
DETAIL_SHOWN = Store("detail-shown", Name)  # the data set of the detail
DATASET_TABS = Id("dataset-tabs")
DATASET_ACTION = Store("dataset-action", DatasetAction)
DEMO = Pattern("demo", "at")
CARD = Pattern("dataset-card", "dataset")
CARD_OPEN = Pattern("dataset-open", "dataset")
ADD = Pattern("add", "at")

CLIPS_TABLE = Id("clips-table")
CLIPS_CHOSEN = Id("clips-chosen")
CLIPS_ALL = Store("clips-all", ClipsAll)
CLIPS_ACTION = Store("clips-action", ClipsAction)
CLIPS_MARKED = Store("clips-marked", Any)

REPORT_TABLE = Id("report-table")
REPORT_FILTER = Id("report-filter")
REPORT_ROWS = Store("report-rows", list[ReportRow])

RENAME_DIALOG = Id("rename-dialog")
RENAME_OLD = Store("rename-old", Name)
RENAME_NAME = Id("rename-name")
RENAME_PROBLEM = Id("rename-problem")
RENAME_SAVE = Id("rename-save")
TRASH_OPEN = Id("trash-open")
TRASH_DIALOG = Id("trash-dialog")
TRASH_LIST = Id("trash-list")

UPLOAD_OPEN = Id("upload-open")
UPLOAD_DIALOG = Id("upload-dialog")
DROP_ZONE = Id("drop-zone")
UPLOAD_BAR = Id("upload-bar")
UPLOAD_PROGRESS = Id("upload-progress")
UPLOAD_SUMMARY = Id("upload-summary")
UPLOAD_LIST = Id("upload-list")
UPLOAD_TARGET = Id("upload-target")
UPLOAD_NAME = Id("upload-name")
UPLOAD_LABELS = Id("upload-labels")
UPLOAD_LABELS_BOX = Id("upload-labels-box")
UPLOAD_LABELS_LABEL = Id("upload-labels-label")
UPLOAD_UNIT = Id("upload-unit")
UPLOAD_UP = Id("upload-up")
UPLOAD_FPS = Id("upload-fps")
UPLOAD_POINTS = Id("upload-points")
UPLOAD_SMOOTH = Id("upload-smooth")
UPLOAD_IMPORT = Id("upload-import")
UPLOAD_PROBLEM = Id("upload-problem")
UPLOAD = Store("upload", Upload)
UPLOAD_INTO = Store("upload-into", UploadInto)
UPLOAD_SUGGESTED = Store("upload-suggested", Name)  # a name for the upload; "" where there is none
UPLOADED = Store("uploaded", Name)  # the token whose import was started

REREAD_DIALOG = Id("reread-dialog")
REPAIR_OF = Store("repair-of", ClipsOf)
REPAIR_DIALOG = Id("repair-dialog")
REPAIR_WHAT = Id("repair-what")
REPAIR_KINDS = Id("repair-kinds")
REPAIR_PROBLEM = Id("repair-problem")
REPAIR_DO = Id("repair-do")

REREAD_OF = Store("reread-of", ClipsOf)
PROPERTIES_OF = Store("properties-of", ClipsOf)
REREAD_NOW = Id("reread-now")
REREAD_UNIT = Id("reread-unit")
REREAD_UP = Id("reread-up")
REREAD_FPS = Id("reread-fps")
REREAD_PROBLEM = Id("reread-problem")
REREAD_DO = Id("reread-do")

BODY_DIALOG = Id("body-dialog")
BODY_OF = Store("body-of", BodyOf)
BODY_RIGS = Store("body-rigs", BodyRigs)
BODY_POSTURE = Store("body-posture", BodyPosture)
BODY_DRAFT = Store("body-draft", BodyDraft)
BODY_FILE = Store("body-file", BodyFile)
BODY_FILLED = Store("body-filled", BodyFilled)
BODY_RIG = Id("body-rig")
BODY_CLIP = Id("body-clip")
BODY_FRAME = Id("body-frame")
BODY_FRAME_LABEL = Id("body-frame-label")
BODY_EDITOR = Id("body-editor")
BODY_PROBLEM = Id("body-problem")
BODY_SAVE = Id("body-save")

FEATURES_CHOICE = Store("features-choice", FeaturesChoice)
FEATURES_READY = Store("features-ready", Download)
