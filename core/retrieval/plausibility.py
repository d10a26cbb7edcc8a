"""Checks whether a query combined from several stretches is a plausible motion (PCR section 6)."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from core.retrieval.compose import compose
from core.retrieval.descriptors import N_COLUMNS
from core.retrieval.frames import column_weights, evenly_spread
from core.retrieval.queries import Query
from core.retrieval.search import SearchIndex, weights_for

ODD = 1.5
"""Ratio from which a combination is called odd."""

_SAMPLE, _ASKED, _APART = 12_000, 48, 1.0  # frames compared with, frames of a query, seconds that make another moment


class Plausibility(NamedTuple):
    """ratio: how far the query's postures are from the nearest real ones, in distances that are usual between a real
    posture and the nearest one of another moment; message: a warning in plain words, or None."""

    ratio: float
    message: str | None


def plausibility(index: SearchIndex, query: Query) -> Plausibility:
    """How far a query's combined postures are from every real one of the index's recordings.

    Raises ValueError where no body is recognised in the query.
    """
    store = index.engine_for(query).store
    composed = compose(store, query, weights_for(query, None))
    scales = column_weights(composed.weights) / 127
    at, clips = evenly_spread(len(store.codes), _SAMPLE), np.repeat(np.arange(len(store.clips)), np.diff(store.starts))
    real = store.codes[at, :N_COLUMNS] * scales
    query_values = composed.codes[evenly_spread(len(composed.codes), _ASKED), :N_COLUMNS] * scales
    ours = np.median(_nearest(query_values, real, np.zeros((len(query_values), len(real)), bool)))
    some = evenly_spread(len(at), 256)
    same = (clips[at[some]][:, None] == clips[at][None]) & (np.abs(at[some][:, None] - at[None]) < _APART * store.fps)
    usual = np.median(_nearest(real[some], real, same))
    ratio = float(ours / max(usual, 0.05))
    if ratio < ODD or not query.hybrid:
        return Plausibility(ratio, None)
    return Plausibility(
        ratio,
        "No recording holds postures like this combination "
        f"(the nearest are {ratio:.1f} times as far as usual): hits may be few or odd.",
    )


def _nearest(some: np.ndarray, real: np.ndarray, left_out: np.ndarray) -> np.ndarray:
    """Distance of each of ``some`` (k, d) to the nearest of ``real`` (n, d) that is not left out: ``(k,)``."""
    squares = (some**2).sum(1)[:, None] + (real**2).sum(1)[None] - 2 * some @ real.T
    squares[left_out] = np.inf
    nearest = squares.min(1)
    return np.sqrt(np.maximum(nearest[np.isfinite(nearest)], 0)) if np.isfinite(nearest).any() else np.ones(1)
