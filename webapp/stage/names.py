"""Ids of the Stage."""

from typing import Any

from webapp.shell.identifiers import Id, Store

STAGE = Id("stage")
STAGE_CANVAS = Id("stage-canvas")
STAGE_SHOWN = Store("stage-shown", Any)
