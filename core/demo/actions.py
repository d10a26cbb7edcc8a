"""Actions of the demo: each recorded motion retimed, mirrored and widened a little, with a lead-in and a lead-out."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from core.demo.gaits import smooth_noise
from core.demo.motions import FPS, JOINTS, Motion, curve, sample, standing_pose, to_clip
from core.demo.performers import Performer
from core.editing.blending import join
from core.editing.legs import place_ankles, smooth_step
from core.mocap import quaternions as quat
from core.mocap.clip import Clip
from core.mocap.kinematics import joint_positions

_LOOP = 0.3  # seconds of the cross-fade between two passes of a loop
RUN_ON, _DECAY = 0.6, 0.09  # seconds: how long a motion runs on at its ends, and how fast it comes to rest there
_UPPER = [JOINTS.index(j) for j in ("Chest", "Neck", "RightArm", "RightForeArm", "LeftArm", "LeftForeArm")]
_SWAYING = [JOINTS.index(j) for j in ("Chest", "Neck", "RightArm", "LeftArm")]


@dataclass(frozen=True)
class Action:
    """How an action is made: recorded motion, whether it may be mirrored, read backwards, or widened.

    fade: seconds of the cross-fades into and out of it. pad: whether it runs on at its ends (a loop need not).
    """

    source: str
    mirror: bool = True
    reverse: bool = False
    widen: bool = True
    fade: float = 0.3
    repeats: tuple[int, int] = (1, 1)


# idle, walk, run and squat are made below and in core.demo.gaits
RECORDED: dict[str, Action] = {
    "jump": Action("jump"),
    "punch": Action("punch"),
    "kick": Action("kick"),
    "spin kick": Action("spinkick", fade=0.45),
    "cartwheel": Action("cartwheel", widen=False, fade=0.45),
    "backflip": Action("backflip", widen=False),
    "roll": Action("roll", widen=False),
    "lie down": Action("getup_facedown", reverse=True, widen=False),
    "crawl": Action("crawl", widen=False, fade=0.45, repeats=(1, 2)),
    "get up": Action("getup_facedown", widen=False),
    "dance": Action("dance_b", repeats=(2, 3)),
    "twirl": Action("spin", widen=False, fade=0.45),
}
MADE = ("idle", "walk", "run", "squat")


def perform(name: str, performer: Performer, rng: np.random.Generator) -> Clip:
    """A random performance of the recorded action ``name``, at any place and in any direction."""
    action = RECORDED[name]
    mirrored = action.mirror and rng.uniform() < 0.5
    amplitude = performer.amplitude * rng.uniform(0.9, 1.1)
    clip: Clip | None = None
    for _ in range(int(rng.integers(action.repeats[0], action.repeats[1] + 1))):
        motion = sample(action.source, _times(action, performer, rng))
        motion = motion.mirrored() if mirrored else motion
        motion = _lean(_widen(motion, amplitude) if action.widen else motion, performer)
        # a loop does not close by itself: its passes are cross-faded like any two actions
        again = to_clip(_run_on(motion), performer, name)
        clip = again if clip is None else join(_inner(clip, tail=True), _inner(again, head=True), _LOOP, steps=False)[0]
    assert clip is not None  # every action is repeated at least once
    return clip


def idle(seconds: float, performer: Performer, rng: np.random.Generator) -> Clip:
    """Standing: the weight shifts slowly, the chest breathes, head and arms drift, the feet stay."""
    n = round(seconds * FPS)
    stance = standing_pose() if rng.uniform() < 0.5 else standing_pose().mirrored()
    motion = Motion(np.repeat(stance.pelvis, n, 0), np.repeat(stance.rotations, n, 0))
    planted = _ankles(to_clip(motion, performer, "idle"))
    drift = smooth_noise(rng, n, 12, 0.8).reshape(n, 4, 3) * np.radians([[1.5], [2.5], [2.5], [2.5]])
    breath = np.sin(2 * np.pi * (0.27 * np.arange(n) / FPS * performer.tempo + rng.uniform()))
    drift[:, 0, 0] += np.radians(1.0) * breath
    motion.rotations[:, _SWAYING] = quat.multiply(motion.rotations[:, _SWAYING], quat.from_rotvec(drift))
    sway = smooth_noise(rng, n, 2, 1.1) * [0.018, 0.008]
    motion.pelvis[:, [0, 2]] += sway
    motion.pelvis[:, 1] -= 0.008
    return place_ankles(to_clip(_lean(motion, performer), performer, "idle"), planted)


def squat(performer: Performer, rng: np.random.Generator) -> Clip:
    """Two to four knee bends with the arms held out in front; feet planted."""
    depth = _knee_bends(int(rng.integers(2, 5)), 2.1 / performer.tempo, rng)
    n = len(depth)
    stance = standing_pose()
    motion = Motion(np.repeat(stance.pelvis, n, 0), np.repeat(stance.rotations, n, 0))
    planted = _ankles(to_clip(motion, performer, "squat"))
    late = np.r_[np.zeros(4), depth[:-4]]  # arms and head follow the hips
    noise = smooth_noise(rng, n, 4, 0.8)

    def pitch(joint: str, degrees: np.ndarray, before: bool = False) -> None:
        k = JOINTS.index(joint)
        turn = quat.from_rotvec(np.radians(degrees)[:, None] * [1.0, 0, 0])
        now = motion.rotations[:, k]
        motion.rotations[:, k] = quat.multiply(turn, now) if before else quat.multiply(now, turn)

    pitch("Hips", 38 * depth + 0.8 * noise[:, 0])
    pitch("Chest", -8 * late)
    pitch("Neck", -25 * late + 0.8 * noise[:, 1])
    for side, column in (("Left", 2), ("Right", 3)):
        pitch(f"{side}Arm", -95 * performer.amplitude * late + 2 * noise[:, column], before=True)
        pitch(f"{side}ForeArm", -10 * depth)
    motion.pelvis[:, 1] -= 0.4 * depth
    motion.pelvis[:, 2] -= 0.1 * depth
    return place_ankles(to_clip(motion, performer, "squat"), planted)


def _times(action: Action, performer: Performer, rng: np.random.Generator) -> np.ndarray:
    """When the recorded motion is read: faster or slower, unevenly, backwards."""
    seconds = curve(action.source)[1]
    pace = performer.tempo * rng.uniform(0.9, 1.12)
    u = np.arange(0, 1, 1 / max(2, round(seconds * FPS / pace)))
    times = seconds * (u + rng.uniform(-0.12, 0.12) * np.sin(2 * np.pi * u) / (2 * np.pi))
    return seconds - times if action.reverse else times


def _inner(clip: Clip, head: bool = False, tail: bool = False) -> Clip:
    """Without all but a short part of the run-on, where another pass of the same motion follows or precedes."""
    cut = round((RUN_ON - _LOOP / 2) * FPS)
    return clip.cut(cut if head else 0, clip.n_frames - (cut if tail else 0))


def _widen(motion: Motion, amplitude: float) -> Motion:
    """Chest, head and arms swing wider about their mean (the feet are not touched)."""
    rotations = motion.rotations.copy()
    upper = quat.continuous(rotations[:, _UPPER])
    mean = quat.normalise(upper.mean(0))
    swing = quat.to_rotvec(quat.multiply(quat.conjugate(mean), upper))
    rotations[:, _UPPER] = quat.multiply(mean, quat.from_rotvec(amplitude * swing))
    return Motion(motion.pelvis, rotations)


def _lean(motion: Motion, performer: Performer) -> Motion:
    turn = quat.from_rotvec(np.radians(performer.lean) * np.array([1.0, 0, 0]))
    rotations = motion.rotations.copy()
    chest = JOINTS.index("Chest")
    rotations[:, chest] = quat.multiply(rotations[:, chest], turn)
    return Motion(motion.pelvis, rotations)


def _run_on(motion: Motion) -> Motion:
    """Extends both ends with their last speed, which fades, so that cross-fades blend moving frames."""
    n = round(RUN_ON * FPS)
    after = _extension(motion.pelvis[-2:], motion.rotations[-2:], n)
    before = _extension(motion.pelvis[1::-1], motion.rotations[1::-1], n)
    return Motion(
        np.concatenate([before[0][::-1], motion.pelvis, after[0]]),
        quat.continuous(np.concatenate([before[1][::-1], motion.rotations, after[1]])),
    )


def _extension(pelvis: np.ndarray, rotations: np.ndarray, n: int) -> tuple[np.ndarray, np.ndarray]:
    way = _DECAY * FPS * (1 - np.exp(-np.arange(1, n + 1) / (_DECAY * FPS)))
    speed = (pelvis[1] - pelvis[0]) * [1, 0, 1]
    turn = quat.to_rotvec(quat.multiply(quat.conjugate(rotations[0]), rotations[1]))
    turned = quat.multiply(rotations[1], quat.from_rotvec(way[:, None, None] * turn))
    return pelvis[1] + way[:, None] * speed, turned


def _knee_bends(count: int, seconds: float, rng: np.random.Generator) -> np.ndarray:
    """Depth from 0 (standing) to about 1 over ``count`` bends: quicker down than up, with a short hold."""
    bends = []
    for _ in range(count):
        n = round(seconds * rng.uniform(0.92, 1.08) * FPS)
        u = np.arange(n) / n
        shape = np.where(u < 0.49, smooth_step(u / 0.49), np.where(u < 0.61, 1, 1 - smooth_step((u - 0.61) / 0.39)))
        bends.append(shape * rng.uniform(0.92, 1.04))
    rest = np.zeros(round(0.35 * FPS))
    return np.concatenate([rest, *bends, rest])


def _ankles(clip: Clip) -> np.ndarray:
    """Ankle positions (n_frames, 2, 3), left then right, metres."""
    skeleton = clip.skeleton
    return joint_positions(clip)[:, [skeleton.index("LeftFoot"), skeleton.index("RightFoot")]].astype(np.float64)
