"""Strings of letters: runs of equal letters removed."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from core.arrays import FloatArray, IntArray


class Runs(NamedTuple):
    """A frame-by-frame labelling with its consecutive repetitions removed (MMG section 3.2), all arrays ``(m,)`` int32.

    letters: one letter a run; starts, ends: its frames F(j), half-open; firsts, stops: for each run the first run of
    its clip and the one past its last, so that nothing reaches across a clip's end (the paper's partition flags).
    """

    letters: np.ndarray
    starts: np.ndarray
    ends: np.ndarray
    firsts: np.ndarray
    stops: np.ndarray

    @property
    def middles(self) -> np.ndarray:
        """Mean frame of each run, ``(m,)`` float32."""
        middles: FloatArray = (self.starts + self.ends - 1) * 0.5
        return middles.astype(np.float32)

    @property
    def lengths(self) -> np.ndarray:
        """Frames of each run, ``(m,)`` float32."""
        lengths: IntArray = self.ends - self.starts
        return lengths.astype(np.float32)


def remove_runs(labels: np.ndarray, clip_starts: np.ndarray) -> Runs:
    """Collapse repeated labels ``(n,)`` into runs; a clip's end also ends a run.

    clip_starts: ``(n_clips + 1,)`` offsets of the clips in ``labels``, the last one n.
    """
    labels, clip_starts = np.asarray(labels), np.asarray(clip_starts)
    new = np.ones(len(labels), bool)
    new[1:] = labels[1:] != labels[:-1]
    new[clip_starts[:-1][np.diff(clip_starts) > 0]] = True
    starts = np.flatnonzero(new)
    bounds = np.searchsorted(starts, clip_starts)
    per_clip = np.diff(bounds)
    columns = (
        labels[starts],
        starts,
        np.append(starts, len(labels))[1:],
        np.repeat(bounds[:-1], per_clip),
        np.repeat(bounds[1:], per_clip),
    )
    return Runs(*(column.astype(np.int32) for column in columns))
