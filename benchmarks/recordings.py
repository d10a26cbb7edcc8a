"""Where benchmarks take their recordings from: real ones beside the checkout, made-up ones where there are none."""

from __future__ import annotations

import os
from pathlib import Path

from core.mocap.dataset import Dataset, open_dataset

SHARED = Path(os.environ.get("MOTIONSCAPE_SHARED", Path(__file__).resolve().parents[2] / "shared"))
EXERCISES = ("13_29", "13_30", "13_31", "14_14", "14_20")


def asfamc() -> Path | None:
    """Folder of the ASF/AMC recordings, None where they are not here."""
    folder = SHARED / "data" / "cmu" / "asfamc"
    return folder if folder.is_dir() else None


def exercises() -> Dataset | None:
    """The five labelled exercise clips, None where they are not here."""
    folder = asfamc()
    return folder and open_dataset([folder / "13", folder / "14"], skeleton=folder / "86/86.asf", clips=EXERCISES)


def all_recordings() -> tuple[Dataset, str]:
    """All ASF/AMC recordings, or a made-up collection of similar size, and what it is."""
    folder = asfamc()
    if folder:
        return open_dataset(folder, skeleton=folder / "86/86.asf"), "CMU recordings, 120 Hz"
    from core.demo import make_demo

    return make_demo(minutes=15), "made-up recordings: the real ones are not here"
