"""Ids of the Stage, and the header of the motions that are sent to it."""

from typing import Any, TypedDict

from webapp.shell.identifiers import Id, Store


class MotionHeader(TypedDict):
    """What the Stage needs to know besides positions. Lengths in metres; joints by their place among the drawn ones."""

    clip: str
    start: int
    end: int
    fps: float
    step: int
    frames: int
    joints: list[str]
    parents: list[int]
    sides: list[str]  # "left", "right" or "centre"
    roles: list[str]  # "left_knee", ...; "" where the anatomy is not known
    root: int
    head: int
    nose: int
    hands: list[int]
    feet: list[int]
    height: float
    head_radius: float
    floor: float


STAGE = Id("stage")
STAGE_CANVAS = Id("stage-canvas")
STAGE_SHOWN = Store("stage-shown", Any)
