"""Ids of the frame around all pages, and of the stores that pages share, each with the shape of its content."""

from typing import Annotated, Any, Literal, NotRequired, TypedDict

from webapp.shell.identifiers import Group, Id, Pattern, Prefix, Store
from webapp.shell.shapes import Most

Name = Annotated[str, Most(1000)]
"""Name of a data set, a clip or another thing that people name."""

View = dict[Name, str]
"""What a page shows beside the selection, and the settings, text by key of the link; each page's keys stand in its own
``View``."""

ViewChange = dict[Name, str | float | bool | None]
"""Keys of the view that change; ``None`` or ``""`` takes a key out."""

Selection = TypedDict(
    "Selection",
    {
        "motif": int,
        "motion": int,  # of the motif
        "motifs": str,  # several marked together: "3-7-9"
        "edge": str,  # "SOURCE-TARGET"
        "transition": int,  # of the edge
        "action": int,
        "segment": int,  # of the action
        "clip": Name,
        "start": int,  # frames of the clip's own rate
        "end": int,  # exclusive
        "as": str,  # how the clip is coloured
        "at": float,  # when it was chosen
    },
    total=False,
)
"""What is selected, and so plays on the Stage."""


class DatasetChoice(TypedDict):
    """Someone chose another data set."""

    dataset: Name | None
    at: NotRequired[float]


class Colour(TypedDict):
    """Frames of a motion that have a colour of their own."""

    start: int
    end: int
    colour: str
    label: str


class Figure(TypedDict):
    """One figure on the Stage: frames ``[start, end)`` of a clip."""

    clip: str
    label: str
    start: NotRequired[int]
    end: NotRequired[int]
    dataset: NotRequired[str]  # its own instead of the request's
    version: NotRequired[str]
    colour: NotRequired[str]
    warp: NotRequired[list[float] | None]  # its frame beside each frame of the medoid
    frame: NotRequired[float]  # shown in the layout "pose"
    colours: NotRequired[list[Colour]]


class StageRequest(TypedDict):
    """What the Stage plays; docs/reference/stage.md describes it."""

    dataset: str | None
    items: list[Figure]
    version: NotRequired[str]
    title: NotRequired[str]
    layout: NotRequired[Literal["overlay", "side", "pose"]]
    sync: NotRequired[Literal["warp", "start"]]
    replace: NotRequired[bool]  # in place of what is shown, at the same share of time
    at: NotRequired[Any]  # the moment to begin with


class MethodNames(Group):
    """Ids of the settings, the button and the status of the page ``page`` in the link."""

    def __init__(self, page: str):
        self.run = Id(f"{page}-run")
        self.estimate = Id(f"{page}-estimate")
        self.left_out = Id(f"{page}-left-out")
        self.fold = Id(f"{page}-fold")
        self.summary = Id(f"{page}-summary")
        self.form = Id(f"{page}-form")
        self.control = Pattern(f"{page}-setting", "name")
        self.status = Id(f"{page}-status")
        self.settings = Store(f"{page}-settings", View)  # those keys of the view that are settings of the page
        self.result_key = Store(f"{page}-result-key", Name)  # empty where the result has not been computed
        self.status_of = Store(f"{page}-status-of", list[Any])  # what the status was last drawn for
        self.again = Store(f"{page}-again", dict[str, bool | float])


# what comes with the page itself, see loading.py
LOADING = Id("loading")
FIRST_LAYOUT = Id("first-layout")
FIRST_PICTURE = Id("first-picture")
FIRST_DEPENDENCIES = Id("first-dependencies")

MOTIF_METHOD = MethodNames("motifs")  # here, because other pages show the motif graph as well

MANTINE = Id("mantine")
PERSON = Id("person")
SHELL = Id("shell")
PAGE = Id("page")
SPLITTER = Id("splitter")
NAV = Prefix("nav-")
DATASET_PICKER = Id("dataset-picker")
NOTICES = Id("notices")
SHARE = Id("share")
SCHEME_TOGGLE = Id("scheme-toggle")
URL = Id("url")

# what is shown; all of it is in the address
DATASET = Store("dataset", Name)
SELECTION = Store("selection", Selection)
VIEW = Store("view", View)
VIEW_CHANGE = Store("view-change", ViewChange)  # merged into the view
VIEW_KEYS = Store("view-keys", dict[str, list[str]])  # page -> its keys in the link
SETTINGS_KEYS = Store("settings-keys", dict[str, list[str]])  # name of settings, see shell/settings.py -> their keys
VIEW_OF_DATASET = Store("view-of-dataset", list[str])  # keys that mean nothing with another data set
ADDRESS = Store("address", str)

DATASET_CHOICE = Store("dataset-choice", DatasetChoice)
AWAITED = Store("awaited", Name)  # the data set that an import started here will bring
STAGE_RESTORE = Store("stage-restore", dict[str, str])  # moment and camera that a link asks for
STAGE_REQUEST = Store("stage-request", StageRequest)
THEME = Store("theme", Literal["light", "dark"])

# they change when the server has something new, and pages then update
REVISION = Store("revision", Name)  # of the list of data sets
JOB_STARTED = Store("job-started", int)
JOB_ENDED = Store("job-ended", str)
