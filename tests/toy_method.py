"""A method that takes its time, for tests of what happens around the computing; importing it registers it."""

from __future__ import annotations

import os
import time
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from core.analyses import METHODS, Method, Request
from core.mocap.clip import Clip, Label
from core.mocap.dataset import Dataset
from core.mocap.skeleton import Skeleton

REPOSITORY = Path(__file__).resolve().parents[1]


@dataclass(frozen=True)
class ToyParameters:
    """ "deaf" does not report; ``log``: a file that gets a line for every computation; ``gate``: a file, and no
    computation ends before it is there."""

    seconds: float = field(default=0.2, metadata={"min": 0, "max": 600})
    mode: str = field(default="count", metadata={"choices": ("count", "refuse", "break", "deaf", "die")})
    log: str = ""
    gate: str = ""


def compute(dataset: Dataset, asked: ToyParameters, report) -> dict:
    """Counts frames, slowly."""
    if asked.log:
        with Path(asked.log).open("a") as log:
            log.write(f"{os.getpid()}\n")
    if asked.mode == "die":
        os._exit(7)
    if asked.mode == "deaf":
        time.sleep(asked.seconds)
    until = time.monotonic() + asked.seconds
    while (left := until - time.monotonic()) > 0 or (asked.gate and not Path(asked.gate).exists()):
        report("counting", 1 - max(left, 0) / max(asked.seconds, 1e-9))
        time.sleep(0.02)
    if asked.mode == "refuse":
        raise fault_of_data()
    if asked.mode == "break":
        raise KeyError("secret detail")
    return {"frames": dataset.n_frames, "names": list(dataset.names)}


def fault_of_data() -> ValueError:
    """What core raises for a person to read."""
    from core.workspace import WorkspaceError

    return WorkspaceError("These clips are too short.")


def make_dataset(name: str = "toy", n_frames: int = 40, seed: int = 0) -> Dataset:
    """Two clips of a body of three joints, with a label."""
    random = np.random.default_rng(seed)
    skeleton = Skeleton(("hips", "chest", "head"), (-1, 0, 1), np.array([[0, 0, 0], [0, 0.4, 0], [0, 0.3, 0]]))
    clips = []
    for k in range(2):
        rotations = np.zeros((n_frames + k, 3, 4), np.float32)
        rotations[..., 0] = 1
        positions = random.normal(0, 0.001, (n_frames + k, 3)).cumsum(axis=0)
        positions[:, 1] += 0.9
        clips.append(Clip(f"walk_{k}", skeleton, 30.0, positions.astype(np.float32), rotations))
    return Dataset(name, tuple(clips), (Label("walk_0", 0, 10, "walk"),))


def request(**parameters) -> Request:
    """A request for the toy method on the data set "toy", quick where not said otherwise."""
    return Request("toy", "toy", {"seconds": 0} | parameters)


def environment() -> dict[str, str]:
    """Environment for worker processes that know the toy method (tests/with_toy/sitecustomize.py loads it)."""
    return os.environ | {"PYTHONPATH": os.pathsep.join([str(REPOSITORY / "tests" / "with_toy"), str(REPOSITORY)])}


METHODS["toy"] = Method("Toy", 1, lambda: ToyParameters, compute, lambda result, _: (result, {}), lambda text, _: text)
