"""Compression of a motif on a basis of its own motions (MMG section 5.4), and by PCA, with every number counted.

The paper says: "a PCA-like scheme that directly uses motion instances to define compact non-orthogonal motion bases",
without "large PCA reconstruction matrices"; the details are in a thesis. Our reading: a few motions of the motif are
kept as they are; every other one is a weighted sum (weights of sum 1, some may be negative) of these, moment by moment
of the motif's common time, and is played by its own time warp. So a compressed motion *is* a blend of the kept ones.
Which are kept: the medoid, then always the motion that takes most of the squared distance that is left.

Rivals at equal size: PCA of whole motions (mean motion and principal motions in place of kept ones), PCA of postures
(mean posture and principal postures; what most people mean by PCA of motion), and ours: kept motions that are
themselves stored by a PCA of postures. All work on the same matrices (:mod:`core.motifs.channels`), store the same
16-bit floating-point numbers, and count kept motions, bases, means, weights, time warps, the place of each motion and
the mean rotations the matrices are about.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

import numpy as np

from core.errors import ParameterError
from core.mocap.clip import Clip
from core.motifs.channels import Channels
from core.motifs.motion_matrices import Motions, stored

BYTES = 2  # of a stored number
OWN, OWN_PCA, MOTION_PCA, POSE_PCA = "own", "own-pca", "motion-pca", "pose-pca"
METHODS = {
    OWN: "Own motions",
    OWN_PCA: "Own motions + PCA",
    MOTION_PCA: "PCA of motions",
    POSE_PCA: "PCA of postures",
}
_PLACE = 3  # numbers that place a motion on the ground: turn and shift
_CHUNK = 16_384  # frames looked at together
_MOTIONS = (1, 2, 3, 4, 6, 8, 10, 12, 16, 20, 24, 32, 48)
_COMPONENTS = (*range(1, 13), 14, 16, 18, 20, 24, 28, 32, 40, 48, 64, 96)
# a coarser choice where both numbers vary
_FEWER_MOTIONS, _FEWER_COMPONENTS = (1, 2, 4, 8, 12, 16, 24, 32, 48), (2, 4, 8, 12, 16, 24, 32, 48)


@dataclass(frozen=True)
class Step:
    """One way to store a motif. ``motions``: kept or principal motions (0: none); ``components``: principal postures
    (0: none)."""

    motions: int = 0
    components: int = 0

    def __str__(self) -> str:
        named = (("motion", self.motions), ("component", self.components))
        return ", ".join(f"{n} {name}{'s' * (n != 1)}" for name, n in named if n) or "nothing"


@dataclass(frozen=True)
class Point:
    """The size and the error of a step. numbers: stored; cm: mean distance of root and posture joints from where they
    were; pose: mean distance in pose space, as MMG measures it."""

    step: Step
    numbers: int
    cm: float
    pose: float


@dataclass(frozen=True)
class Curves:
    """Size against error of some motions. frames: at the rate they were looked at; raw: numbers they have uncompressed;
    points: by method (:data:`METHODS`), larger sizes later."""

    motions: int
    frames: int
    raw: int
    points: dict[str, tuple[Point, ...]]


def rebuild(motions: Motions, method: str, step: Step) -> tuple[np.ndarray, int]:
    """The motions after storage, ``(n_frames, width)``, and how many numbers that takes.
    Raises ValueError for an unknown method or a step it does not have."""
    if method == POSE_PCA and step.components > 0:
        if 0 not in motions.postures:
            motions.postures[0] = principal_postures(motions.values)
        values, numbers = through_postures(motions.values, step.components, motions.postures[0])
        return values, numbers + _PLACE * motions.n + motions.channels.rest.size
    if method == MOTION_PCA and step.motions > 0:
        return _principal_motions(motions, step.motions)
    if 0 < step.motions <= len(motions.order) and method == (OWN_PCA if step.components else OWN):
        return _own_motions(motions, step)
    raise ParameterError(f"motions are not stored by {method!r} with {step}")


def principal_postures(values: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """PCA of postures ``(n_frames, width)``: their mean ``(width,)`` and principal directions ``(width, width)``, as
    columns, most important first."""
    mean = stored(values.mean(0))
    about = values - mean
    return mean, stored(np.linalg.eigh(about.T @ about)[1][:, ::-1])


def through_postures(
    values: np.ndarray, components: int, principal: tuple[np.ndarray, np.ndarray] | None = None
) -> tuple[np.ndarray, int]:
    """Values ``(n_frames, width)`` as they come back from ``components`` principal directions, and the numbers that
    takes: mean, directions, coefficients. principal: from :func:`principal_postures`, if it is at hand."""
    mean, directions = principal or principal_postures(values)
    basis = directions[:, :components]
    numbers = len(mean) + basis.size + len(values) * basis.shape[1]
    return mean + stored((values - mean) @ basis) @ basis.T, numbers


def _own_motions(motions: Motions, step: Step) -> tuple[np.ndarray, int]:
    """Kept motions at their own frames, perhaps through postures; all others as their weighted sums."""
    kept = list(motions.order[: step.motions])
    frames = np.concatenate([motions.values[motions.part(k)] for k in kept])
    if step.components:
        if step.motions not in motions.postures:
            motions.postures[step.motions] = principal_postures(frames)
        frames, numbers = through_postures(frames, step.components, motions.postures[step.motions])
    else:
        frames, numbers = stored(frames - motions.mean) + motions.mean, motions.channels.width + frames.size
    numbers += _PLACE * motions.n + motions.channels.rest.size
    back = np.split(frames, np.cumsum(np.diff(motions.starts)[kept])[:-1])
    values = np.empty_like(motions.values)
    if len(kept) < motions.n:
        bases = np.stack([motions.on_grid(k, part) for k, part in zip(kept, back, strict=True)])
        flat = bases.reshape(len(kept), -1)
        mixed = flat[0] + stored(motions.weights(len(kept))[:, 1:]) @ (flat[1:] - flat[0])
        values[:] = motions.off_grid(mixed.reshape(motions.n, *bases.shape[1:]))
        numbers += (motions.n - len(kept)) * (len(kept) - 1) + (motions.n - 1) * motions.knots.shape[1]
    for k, part in zip(kept, back, strict=True):
        values[motions.part(k)] = part
    return values, numbers


def _principal_motions(motions: Motions, n: int) -> tuple[np.ndarray, int]:
    """PCA of whole motions: the mean motion and n - 1 principal ones in place of kept motions."""
    mean, basis = motions.principal[0], motions.principal[1][: n - 1]
    flat = motions.moved.reshape(motions.n, -1)
    back = mean + stored((flat - mean) @ basis.T) @ basis
    numbers = motions.channels.width + (1 + len(basis)) * len(mean) + motions.n * len(basis)
    numbers += (motions.n - 1) * motions.knots.shape[1] + _PLACE * motions.n + motions.channels.rest.size
    return motions.off_grid(back.reshape(motions.moved.shape)), numbers


def curves(motions: Motions, methods: Iterable[str] = tuple(METHODS)) -> Curves:
    """Size against error of each method, for growing numbers of motions and components."""
    points = {method: _curve(motions, method) for method in methods}
    return Curves(motions.n, len(motions.values), motions.raw, points)


def posture_curves(channels: Channels, values: np.ndarray, pieces: int) -> Curves:
    """Size against error of PCA of postures alone, for ``(n_frames, width)`` values of so many ``pieces`` of motion."""
    principal, points = principal_postures(values), []
    for k in _components(channels, len(values)):
        back, numbers = through_postures(values, k, principal)
        numbers += _PLACE * pieces + channels.rest.size
        points.append(Point(Step(components=k), numbers, *errors(channels, values, back)))
    return Curves(pieces, len(values), values.size, {POSE_PCA: tuple(points)})


def errors(channels: Channels, before: np.ndarray, after: np.ndarray) -> tuple[float, float]:
    """Mean distance of joints in centimetres, and of poses as MMG measures it, between ``(n_frames, width)`` values."""
    joints = pose = 0.0
    for i in range(0, len(before), _CHUNK):
        a, b = before[i : i + _CHUNK], after[i : i + _CHUNK]
        way = np.linalg.norm(channels.positions(a) - channels.positions(b), axis=-1)
        joints += 100 * float(way.mean(1, dtype=np.float64).sum())
        pose += float(channels.pose_distance(a, b).sum())
    return joints / len(before), pose / len(before)


def _curve(motions: Motions, method: str) -> tuple[Point, ...]:
    rebuilt = [(step, *rebuild(motions, method, step)) for step in _steps(motions, method)]
    if method != OWN_PCA:
        return tuple(Point(step, n, *errors(motions.channels, motions.values, v)) for step, v, n in rebuilt)
    best: list[Point] = []  # two ways to grow: only the steps that no smaller one beats
    least = np.inf
    for step, values, n in sorted(rebuilt, key=lambda entry: entry[2]):
        left = float(((values - motions.values) ** 2).sum())
        if left < 0.98 * least:
            point = Point(step, n, *errors(motions.channels, motions.values, values))
            least = left
            if not best or point.cm < best[-1].cm:
                best.append(point)
    return tuple(best)


def _steps(motions: Motions, method: str) -> Iterator[Step]:
    components = _components(motions.channels, len(motions.values))
    if method == POSE_PCA:
        return (Step(components=k) for k in components)
    most = len(motions.order)
    kept = sorted({n for n in (_FEWER_MOTIONS if method == OWN_PCA else _MOTIONS) if n < most} | {most})
    if method == OWN_PCA:
        return (Step(n, k) for n in kept for k in components if k in _FEWER_COMPONENTS)
    return (Step(n) for n in kept)


def _components(channels: Channels, frames: int) -> list[int]:
    return [n for n in _COMPONENTS if n < min(channels.width, frames)]


def motion_errors(motions: Motions, method: str, step: Step) -> dict[int, float]:
    """Mean error of each motion's joints, centimetres, by its index in the motif. Raises as :func:`rebuild`."""
    values, _ = rebuild(motions, method, step)
    parts = {name: motions.part(k) for k, name in enumerate(motions.names)}
    return {name: errors(motions.channels, motions.values[at], values[at])[0] for name, at in parts.items()}


def rebuilt_clips(motions: Motions, method: str, step: Step) -> Iterator[tuple[int, Clip, Clip]]:
    """Each motion of the motif as recorded and after compression, both aligned with the reference."""
    values, _ = rebuild(motions, method, step)
    for k, name in enumerate(motions.names):
        at, fps = motions.part(k), motions.rates[k]
        before, after = (motions.channels.decode(v[at], fps=fps) for v in (motions.values, values))
        yield name, before, after
