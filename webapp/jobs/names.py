"""Ids of the job bar and of changes with their undo, and what their stores hold."""

from typing import Annotated, Literal, NotRequired, TypedDict

from webapp.shell.identifiers import Id, Store
from webapp.shell.shapes import Most


class JobRow(TypedDict):
    """A row of the bar; ``error`` is there where the job has failed."""

    id: int
    title: str
    stage: NotRequired[str]
    percent: NotRequired[int | None]  # None where the duration is unknown
    stopping: NotRequired[bool]
    held: NotRequired[bool]  # it starts when someone says so; ``stage`` says why
    expected: NotRequired[str]  # what it will take; "" where nobody knows
    error: NotRequired[str]


class JobAction(TypedDict):
    """What is to be done with a job."""

    action: Literal["start", "cancel", "retry", "dismiss"]
    job: int
    at: NotRequired[float]


class JobMarks(TypedDict, total=False):
    """Marks of what the bar showed last."""

    rows: str
    speed: int
    revision: str
    finished: str


class ChangeStarted(TypedDict):
    """A change of a data set that was started here."""

    job: int


class Undo(TypedDict, total=False):
    """What to undo: a version to go back to, or what goes to or comes from the trash."""

    revert: str
    restore: str
    trash: str
    at: float


JOB_LIST = Id("job-list")
JOB_TICK = Id("job-tick")
JOBS_SHOWN = Store("jobs-shown", list[JobRow])
JOB_POKE = Store("job-poke", float)  # a job was started or stopped: the bar updates immediately
JOB_ACTION = Store("job-action", JobAction)
JOBS_SEEN = Store("jobs-seen", JobMarks)
JOBS_DISMISSED = Store("jobs-dismissed", Annotated[list[int], Most(100)])
JOBS_FINISHED = Store("jobs-finished", str)  # changes when a job ends: results may have appeared

CHANGE_STARTED = Store("change-started", ChangeStarted)
CHANGES = Store("changes", Annotated[list[int], Most(1000)])  # jobs of changes whose end has not been announced
UNDO = Store("undo", Undo)
