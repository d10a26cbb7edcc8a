"""A folder of recordings as a laboratory may have it: people and animals, Y and Z up, metres, decimetres, inches."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from tests.core.mocap.dialects import DIALECTS, bvh_of
from tests.core.mocap.odd_clips import dog, in_other_axes, spider, walking, written
from tests.core.mocap.test_reading import FROM_Y

PEOPLE = {  # name of the clip -> dialect, and how fast the person walks
    "centimetres": ("MotionBuilder", 1.0),
    "metres": ("Mixamo, read by Blender", 1.3),
    "decimetres": ("MakeHuman", 1.1),
    "inches": ("Biped of 3ds Max", 0.9),
}
ANIMALS = ("rex", "rover", "web")


def mixed_folder(folder: Path) -> Path:
    """The folder, filled: four people of four programs, a walk and its copy with Z up, two dogs, a spider."""
    written(
        folder,
        walking("walk", seconds=4.0),
        replace(in_other_axes(walking("walk", seconds=4.0), FROM_Y["z"]), name="walk with Z up"),
        dog("rex", seconds=4.0, seed=1),
        dog("rover", seconds=4.0, seed=2),
        spider("web", seconds=4.0),
    )
    for name, (dialect, speed) in PEOPLE.items():
        text = bvh_of(DIALECTS[dialect], seconds=4.0, speed=speed, height=1.6 + speed / 10)
        (folder / f"{name}.bvh").write_text(text, encoding="utf-8")
    (folder / "readme.fbx").write_bytes(b"Kaydara FBX Binary  \x00")
    return folder
