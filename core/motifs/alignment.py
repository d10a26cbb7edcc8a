"""From string motifs to motions: entry and exit frames, then time alignment (MMG section 3.5)."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from core.arrays import Float32Array, Int32Array, Int64Array
from core.compiled import njit
from core.progress import Report, silent
from core.sequences.repeats import Runs
from core.sequences.warping import registration, warp_path

_COMPARED = 64  # poses of a group, evenly spread over it, that an entry or exit pose is compared with


class AlignedMotif(NamedTuple):
    """Motions of one motif, all in analysis frames of the whole data set.

    spans: ``(n_motions, 2)`` first frame and one past the last; medoid: the motion nearest the average; warps: per
    motion ``(n_medoid_frames,)`` its frame, from its start, that stands beside each frame of the medoid; error_sum,
    error_count: sum and number of the distances between registered frames and the average motion.
    """

    spans: np.ndarray
    medoid: int
    warps: tuple[np.ndarray, ...]
    error_sum: float
    error_count: int


def entry_frames(
    runs: Runs, motifs: list[np.ndarray], poses: np.ndarray, seed: int = 0, sweeps: int = 20
) -> np.ndarray:
    """The frame f(j), for every letter j of the string, at which motions enter or leave it: ``(m,)`` int64.

    Stochastic search: letters at ends of motions, in random order, each moves to the frame of its run that minimises
    the sum of distances of all entry and exit poses to the average ones of their motif (equation 3), until no letter
    moves. motifs: per motif ``(n_motions, 2)`` letters; poses: (n, d).
    """
    frames: np.ndarray = ((runs.starts.astype(np.int64) + runs.ends - 1) // 2).astype(np.int64)
    if not motifs:
        return frames
    groups = [ends for motif in motifs for ends in (motif[:, 0], motif[:, 1])]
    members = np.concatenate(groups).astype(np.int64)
    pointers = np.concatenate([[0], np.cumsum([len(g) for g in groups])]).astype(np.int64)
    group_of = np.full((len(frames), 2), -1, np.int64)  # a letter may end one motion and begin the next
    for g, ends in enumerate(groups):
        group_of[ends, g % 2] = g
    letters, rng = np.unique(members), np.random.default_rng(seed)
    for _ in range(sweeps):
        order = rng.permutation(letters)
        if not _sweep(order, frames, group_of, pointers, members, runs.starts, runs.ends, poses):
            break
    return frames


@njit(nogil=True)
def _sweep(
    order: Int64Array,
    frames: Int64Array,
    group_of: Int64Array,
    pointers: Int64Array,
    members: Int64Array,
    starts: Int32Array,
    ends: Int32Array,
    poses: Float32Array,
) -> int:
    moved = 0
    for j in order:
        before, best, best_score = frames[j], frames[j], np.inf
        for attempt in range(-1, ends[j] - starts[j]):  # the present frame first: a tie does not move it
            frames[j] = before if attempt < 0 else starts[j] + attempt
            score = 0.0
            for side in range(2):
                if group_of[j, side] >= 0:
                    score += _spread(group_of[j, side], j, pointers, members, frames, poses)
            if score < best_score * (1 - 1e-9):
                best, best_score = frames[j], score
        frames[j] = best
        moved += best != before
    return moved


@njit(nogil=True)
def _spread(
    group: int, own: int, pointers: Int64Array, members: Int64Array, frames: Int64Array, poses: Float32Array
) -> float:
    """Sum of distances of a group's poses to their average; of a large group, of some of them and letter ``own``."""
    low, size = pointers[group], pointers[group + 1] - pointers[group]
    n = min(size, _COMPARED)
    looked_at = np.empty(n + 1, np.int64)
    for k in range(n):
        looked_at[k] = frames[members[low + k * size // n]]
    if n < size:
        looked_at[n], n = frames[own], n + 1
    mean = np.zeros(poses.shape[1])
    for k in range(n):
        mean += poses[looked_at[k]]
    mean /= n
    total = 0.0
    for k in range(n):
        square = 0.0
        for d in range(len(mean)):
            square += (poses[looked_at[k], d] - mean[d]) ** 2
        total += np.sqrt(square)
    return total


def spans_of(runs: Runs, motifs: list[np.ndarray], frames: np.ndarray, hold: int = 0) -> list[np.ndarray]:
    """Frame spans of each motif's motions, ``(n_motions, 2)``, half-open and never overlapping.

    frames: ``(m,)`` from :func:`entry_frames`. Where a motion begins with the letter in which another ends, the frame
    of that letter belongs to the one that begins. Elsewhere a motion takes in up to ``hold`` more frames at either end
    that show its first or last letter: whichever of them the alignment preferred, they are part of the same pose.
    """
    begins, ends = np.zeros(len(frames), bool), np.zeros(len(frames), bool)
    for motif in motifs:
        begins[motif[:, 0]] = True
        ends[motif[:, 1]] = True
    first = np.where(ends, frames, np.maximum(frames - hold, runs.starts))
    stop = np.where(begins, frames, np.minimum(frames + hold + 1, runs.ends))
    return [np.column_stack([first[m[:, 0]], stop[m[:, 1]]]) for m in motifs]


def align_motifs(spans: list[np.ndarray], poses: np.ndarray, report: Report = silent) -> list[AlignedMotif]:
    """Register the motions of each motif with the motion nearest their average, by time warping; poses: ``(n, d)``."""
    aligned = []
    for k, span in enumerate(spans):
        aligned.append(_align(span, poses))
        report("alignment", (k + 1) / len(spans))
    return aligned


def _align(spans: np.ndarray, poses: np.ndarray) -> AlignedMotif:
    motions = [poses[start:end] for start, end in spans]
    medoid = nearest_to_average(motions)
    reference = motions[medoid]
    warps = tuple(registration(warp_path(reference, motion), len(reference)) for motion in motions)
    registered = np.stack([at_frames(motion, warp) for motion, warp in zip(motions, warps, strict=True)])
    errors = np.linalg.norm(registered - registered.mean(0), axis=2)
    return AlignedMotif(spans, medoid, warps, float(errors.sum()), errors.size)


def nearest_to_average(motions: list[np.ndarray]) -> int:
    """Index of the motion, each ``(n, d)``, nearest the average of all, stretched linearly to their mean length."""
    length = max(1, round(float(np.mean([len(motion) for motion in motions]))))
    stretched = np.stack([at_frames(motion, np.linspace(0, len(motion) - 1, length)) for motion in motions])
    return int(((stretched - stretched.mean(0)) ** 2).sum((1, 2)).argmin())


def at_frames(motion: np.ndarray, frames: np.ndarray) -> np.ndarray:
    """Poses ``(k, d)`` of a motion ``(n, d)`` at fractional frames ``(k,)``, linear."""
    i = np.clip(np.floor(frames).astype(np.int64), 0, len(motion) - 1)
    t = (frames - i)[:, None].astype(motion.dtype)
    poses: np.ndarray = motion[i] * (1 - t) + motion[np.minimum(i + 1, len(motion) - 1)] * t
    return poses
