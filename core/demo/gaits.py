"""Walking and running of any length: two recorded cycles, blended in step with one another, along a curved path."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from scipy.interpolate import CubicSpline
from scipy.ndimage import gaussian_filter1d

from core.demo.motions import FPS, JOINTS, Motion, curve, sample
from core.demo.performers import Performer
from core.editing.blending import turn_about_y
from core.editing.legs import smooth_step
from core.mocap import quaternions as quat

_CHANGE = 1.5  # seconds from a walk into a run
_BANK = 0.7  # share of the lean a turn at speed would need on a bicycle


@dataclass(frozen=True, eq=False)
class Cycle:
    """One gait cycle on the spot, as a periodic spline over [0, 1); phase 0 is alike in all cycles.

    stride: metres of the source's person a cycle; seconds: duration of one.
    """

    spline: CubicSpline
    stride: float
    seconds: float


def gait(stages: list[tuple[str, float]], turn: float, performer: Performer, rng: np.random.Generator) -> tuple:
    """Walk and run: ``stages`` of (``"walk"`` or ``"run"``, seconds), turning by ``turn`` radians over all.

    Returns the motion, facing Z at its start, and the first frame of each stage.
    """
    seconds = np.array([s for _, s in stages])
    ends = np.cumsum(seconds)
    n = round(ends[-1] * FPS)
    t = np.arange(n) / FPS
    run = _share_of_running(stages, ends, t)
    walking, running = _cycle("walk"), _cycle("run")
    tempo = performer.tempo * (1 + 0.04 * smooth_noise(rng, n, 1, 1.0)[:, 0])
    rate = tempo * ((1 - run) / walking.seconds + run / running.seconds)
    phase = rng.uniform() + np.cumsum(rate) / FPS
    a, b = (_read(cycle, phase) for cycle in (walking, running))
    rotations = quat.slerp(a.rotations, b.rotations, run[:, None])
    pelvis = a.pelvis * (1 - run[:, None]) + b.pelvis * run[:, None]
    pelvis[:, 1] += (performer.bounce - 1) * (pelvis[:, 1] - gaussian_filter1d(pelvis[:, 1], 30, mode="nearest"))
    speed = rate * ((1 - run) * walking.stride + run * running.stride)
    heading = turn * smooth_step((t - 0.1 * ends[-1]) / (0.8 * ends[-1]))
    motion = _along_path(pelvis, rotations, speed, heading)
    starts = [0, *(round(e * FPS) for e in ends[:-1])]
    return motion, starts


def smooth_noise(rng: np.random.Generator, n: int, columns: int, seconds: float) -> np.ndarray:
    """Smooth random curves ``(n, columns)`` of unit variance that wander within about ``seconds``."""
    sigma = seconds * FPS / 2
    pad = int(4 * sigma)
    noise = gaussian_filter1d(rng.standard_normal((n + 2 * pad, columns)), sigma, axis=0)[pad : pad + n]
    return noise * np.sqrt(2 * sigma * np.sqrt(np.pi))


def _share_of_running(stages: list[tuple[str, float]], ends: np.ndarray, t: np.ndarray) -> np.ndarray:
    run = np.full(len(t), float(stages[0][0] == "run"))
    for (before, _), (after, _), at in zip(stages, stages[1:], ends, strict=False):
        step = float(after == "run") - float(before == "run")
        run += step * smooth_step((t - at) / _CHANGE + 0.5)
    return run


@lru_cache(maxsize=4)
def _cycle(name: str) -> Cycle:
    seconds = curve(name)[1]
    n = round(seconds * FPS * 2)
    motion = sample(name, np.linspace(0, seconds, n + 1))
    step = motion.pelvis[-1] - motion.pelvis[0]
    share = np.linspace(0, 1, n + 1)[:, None]
    pelvis = motion.pelvis - share * step
    pelvis[:, [0, 2]] -= pelvis[:-1, [0, 2]].mean(0)
    # what is left of the gap between the last and the first posture is spread over the cycle
    gap = quat.to_rotvec(quat.multiply(quat.conjugate(motion.rotations[-1]), motion.rotations[0]))
    spread = quat.from_rotvec((share**2 * (3 - 2 * share))[..., None] * gap)
    rotations = quat.continuous(quat.multiply(motion.rotations, spread))
    values = np.c_[pelvis, rotations.reshape(n + 1, -1)]
    values[-1] = values[0]
    swing = rotations[:-1, JOINTS.index("RightUpLeg"), 1] - rotations[:-1, JOINTS.index("LeftUpLeg"), 1]
    phase = np.angle(np.fft.rfft(swing)[1]) / (2 * np.pi)
    spline = CubicSpline(np.linspace(0, 1, n + 1) + phase, values, bc_type="periodic", extrapolate="periodic")
    return Cycle(spline, float(np.hypot(step[0], step[2])), seconds)


def _read(cycle: Cycle, phase: np.ndarray) -> Motion:
    values = cycle.spline(phase)
    return Motion(values[:, :3], quat.normalise(values[:, 3:].reshape(len(values), len(JOINTS), 4)))


def _along_path(pelvis: np.ndarray, rotations: np.ndarray, speed: np.ndarray, heading: np.ndarray) -> Motion:
    forward = turn_about_y(heading, np.array([0.0, 0, 1]))
    path = np.cumsum(forward * speed[:, None] / FPS, axis=0)
    # lean into the turn, about the line the feet follow
    bank = np.clip(-np.gradient(heading) * FPS * speed / 9.81 * _BANK, -0.3, 0.3)
    lean = quat.from_rotvec(forward * bank[:, None])
    local = quat.rotate(lean, turn_about_y(heading, pelvis))
    rotations = rotations.copy()
    rotations[:, 0] = quat.multiply(lean, quat.multiply(quat.from_yaw(heading), rotations[:, 0]))
    return Motion(path + local, rotations)
