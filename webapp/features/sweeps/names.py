"""Ids of the Sweeps page, what its stores hold, and the keys of its links."""

from typing import Any, TypedDict

from webapp.shell.identifiers import Family, Id, Pattern, Store
from webapp.shell.names import Name

_SIDES = ("x", "y")


class View(TypedDict, total=False):
    """The axes with their values, and how often each point is repeated."""

    x: str
    y: str
    seeds: str


SWEEP_MENU = Id("sweep-menu")
SWEEP_RUN = Id("sweep-run")
SWEEP_NAME = Family("sweep-{}-name", _SIDES)  # of the setting on an axis
SWEEP_VALUES = Family("sweep-{}-values", _SIDES)
SWEEP_BOX = Family("sweep-{}-box", _SIDES)
SWEEP_SEEDS = Id("sweep-seeds")
SWEEP_PLAN = Id("sweep-plan")
SWEEP_BASE = Id("sweep-base")
SWEEP_BASE_FOLD = Id("sweep-base-fold")
SWEEP_BASE_SUMMARY = Id("sweep-base-summary")
BASE_SETTING = Pattern("sweep-base", "name")
FORM = (SWEEP_NAME["x"], SWEEP_VALUES["x"], SWEEP_NAME["y"], SWEEP_VALUES["y"], SWEEP_SEEDS)

SWEEP_STATUS = Id("sweep-status")
SWEEP_STATUS_OF = Store("sweep-status-of", list[Any])  # what the status was last drawn for
SWEEP_SEEN = Store("sweep-seen", Name)  # the sweep that is shown, and how much of it is there
SWEEP_RESULT = Id("sweep-result")
SWEEP_SUGGESTION = Id("sweep-suggestion")
SWEEP_CARD = Family("sweep-card-{}", (*_SIDES, "heat"))
SWEEP_PAIR = Family("sweep-pair-{}", _SIDES)
SWEEP_AT = Family("sweep-at-{}", _SIDES)
SWEEP_AT_NAME = Family("sweep-at-name-{}", _SIDES)
SWEEP_AT_BOX = Family("sweep-at-box-{}", _SIDES)
SWEEP_LINES = Family("sweep-lines-{}", _SIDES)
SWEEP_HEAT = Id("sweep-heat")
SWEEP_MEASURE = Id("sweep-measure")
SWEEP_MEASURE_HELP = Id("sweep-measure-help")
SWEEP_TABLE = Id("sweep-table")
SWEEP_TABLE_PLACE = Id("sweep-table-place")
