"""Walking and running of any length: two recorded cycles, blended in step with one another, along a curved path."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np
from scipy.interpolate import CubicSpline
from scipy.ndimage import gaussian_filter1d

from core.demo.motions import FPS, JOINTS, Motion, curve, sample, to_clip
from core.demo.performers import Performer
from core.editing.blending import turn_about_y
from core.editing.contacts import foot_contacts, runs
from core.editing.legs import place_ankles, smooth_step
from core.mocap import quaternions as quat
from core.mocap.clip import Clip
from core.mocap.kinematics import forward_kinematics

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


def gait(
    stages: list[tuple[str, float]], turn: float, performer: Performer, rng: np.random.Generator
) -> tuple[Clip, list[int]]:
    """Walk and run: ``stages`` of (``"walk"`` or ``"run"``, seconds), turning by ``turn`` radians over all.

    Returns the clip, facing Z at its start, and the first frame of each stage.
    """
    ends = np.cumsum([seconds for _, seconds in stages])
    n = round(ends[-1] * FPS)
    t = np.arange(n) / FPS
    run = _share_of_running(stages, ends, t)
    walking, running = _cycle("walk"), _cycle("run")
    tempo = performer.tempo * (1 + 0.04 * smooth_noise(rng, n, 1, 1.0)[:, 0])
    rate = tempo * ((1 - run) / walking.seconds + run / running.seconds)
    phase = rng.uniform() + np.cumsum(rate) / FPS
    a, b = (_read(cycle, phase) for cycle in (walking, running))
    pelvis = a.pelvis * (1 - run[:, None]) + b.pelvis * run[:, None]
    pelvis[:, 1] += (performer.bounce - 1) * (pelvis[:, 1] - gaussian_filter1d(pelvis[:, 1], 30, mode="nearest"))
    speed = rate * ((1 - run) * walking.stride + run * running.stride)
    pelvis[:, 2] += np.cumsum(speed) / FPS
    straight = to_clip(Motion(pelvis, quat.slerp(a.rotations, b.rotations, run[:, None])), performer, "gait")
    heading = turn * smooth_step((t - 0.1 * ends[-1]) / (0.8 * ends[-1]))
    starts = [0, *(round(end * FPS) for end in ends[:-1])]
    return _bend(straight, speed * performer.measure("legs"), heading), starts


def smooth_noise(rng: np.random.Generator, n: int, columns: int, seconds: float) -> np.ndarray:
    """Smooth random curves ``(n, columns)`` of unit variance that wander within about ``seconds``."""
    sigma = seconds * FPS / 2
    pad = int(4 * sigma)
    noise = gaussian_filter1d(rng.standard_normal((n + 2 * pad, columns)), sigma, axis=0)[pad : pad + n]
    scaled: np.ndarray = noise * np.sqrt(2 * sigma * np.sqrt(np.pi))
    return scaled


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


def _bend(straight: Clip, speed: np.ndarray, heading: np.ndarray) -> Clip:
    """A straight gait bent along a path: the body follows it evenly, a foot only while it is in the air.

    speed (n,), metres a second, along Z; heading (n,), radians.
    """
    along = np.cumsum(speed) / FPS
    forward = turn_about_y(heading, np.array([0.0, 0, 1]))
    path = np.cumsum(forward * speed[:, None], axis=0) / FPS
    frames = np.arange(len(speed))

    def bent(points: np.ndarray, at: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Points of the straight gait carried to where the path is at frames ``at``, and the heading there."""
        where = np.stack([np.interp(at, frames, column) for column in path.T], axis=1)
        angle = np.interp(at, frames, heading)
        return where + turn_about_y(angle, points - np.interp(at, frames, along)[:, None] * [0, 0, 1]), angle

    # lean into the turn, about the line the feet follow
    bank = np.clip(-np.gradient(heading) * FPS * speed / 9.81 * _BANK, -0.3, 0.3)
    lean = quat.from_rotvec(forward * bank[:, None])
    root, _ = bent(straight.root_positions, frames)
    rotations = straight.rotations.astype(np.float64)
    rotations[:, 0] = quat.multiply(lean, quat.multiply(quat.from_yaw(heading), rotations[:, 0]))
    body = replace(
        straight,
        root_positions=(path + quat.rotate(lean, root - path)).astype(np.float32),
        rotations=rotations.astype(np.float32),
    )
    positions, world = forward_kinematics(straight)
    contacts = foot_contacts(straight, 0.0, positions)
    ankles = [straight.skeleton.index(f"{side}Foot") for side in ("Left", "Right")]
    feet = [bent(positions[:, j].astype(np.float64), _held(contacts[:, k])) for k, j in enumerate(ankles)]
    turned = [quat.multiply(quat.from_yaw(angle), world[:, j]) for (_, angle), j in zip(feet, ankles, strict=True)]
    return place_ankles(body, np.stack([place for place, _ in feet], axis=1), np.stack(turned, axis=1))


def _held(contact: np.ndarray) -> np.ndarray:
    """Frame numbers (n,) that stand still while the foot stands and catch up while it swings."""
    held = np.arange(len(contact), dtype=np.float64)
    spans = runs(contact)
    middles = spans.mean(1)
    for (start, end), middle in zip(spans, middles, strict=True):
        held[start:end] = middle
    for (_, start), (end, _), a, b in zip(spans, spans[1:], middles, middles[1:], strict=False):
        held[start:end] = a + (b - a) * smooth_step(np.arange(1, end - start + 1) / (end - start + 1))
    return held
