"""Combines the parts of a query, which may come from several clips, into one motion."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from core.errors import AnalysisError
from core.poses.body_parts import LEAVES
from core.retrieval.descriptors import BLOCKS, N_COLUMNS, ROOT, smoothed
from core.retrieval.frames import JITTER, FrameStore, column_weights, jitter
from core.retrieval.path_length import at_shares, path_lengths
from core.retrieval.queries import Query, QueryPart


@dataclass(frozen=True, eq=False)
class Composed:
    """A query: codes ``(n, ...)`` as in FrameStore, at its rate; weights: of the leaves that both it and the user have.

    leading: the part whose time it keeps; frames: ``(q,)`` for each own-rate frame of that part its frame here.
    """

    codes: np.ndarray
    weights: Mapping[str, float]
    leading: QueryPart
    frames: np.ndarray


def compose(store: FrameStore, query: Query, weights: Mapping[str, float]) -> Composed:
    """The query as one motion, in the time of its leading part.

    Parts of the same recording keep their time, so two halves of one stretch are that stretch. Parts of another one are
    laid along the leading part by share of their path. Parts without weight are left out, so that they have no
    influence. Raises AnalysisError where the skeletons of the query lack every part that has a weight.
    """
    parts = [part for part in query.parts if any(weights[leaf] > 0 for leaf in part.leaves)]
    coded = [(part, *_encoded(store, part, weights)) for part in parts]
    kept = dict.fromkeys(LEAVES, 0.0)
    for part, _, has in coded:
        kept |= {leaf: weights[leaf] for leaf in part.leaves if leaf in has}
    total = sum(kept.values())
    if not total > 0:
        raise AnalysisError(f"{query.name}: no body with the parts that have a weight is recognised in its skeleton")
    kept = {leaf: weight / total for leaf, weight in kept.items()}
    leading, codes, _ = max(coded, key=lambda entry: _leads(entry[0], kept))
    composed = codes.copy()
    for part, other, _ in coded:
        if part is leading:
            continue
        if part.same_recording(leading):  # both keep their time
            shares = np.linspace(0, 1, len(codes))
            times = np.arange(len(other), dtype=np.float64)
        else:
            shares = _share(codes, leading, kept)
            times = path_lengths(_weighted(other, part, kept))
        composed[:, :N_COLUMNS] = _laid_along(composed, shares, other, times, part)
    rate = store.fps / leading.clip.fps
    at = np.rint(np.arange(leading.end - leading.start) * rate).astype(np.int64)
    return Composed(composed, kept, leading, np.minimum(at, len(composed) - 1))


def _encoded(store: FrameStore, part: QueryPart, weights: Mapping[str, float]) -> tuple[np.ndarray, tuple[str, ...]]:
    """The part's codes, smoothed where it jitters and the recordings do not, because jitter looks like effort.

    What has no weight may jitter as it likes.
    """
    codes, has = store.encode(part.clip, part.start, part.end)
    counted = np.flatnonzero(column_weights({leaf: weights[leaf] for leaf in part.leaves}))
    if jitter(codes[:, counted]) >= JITTER and store.steady:
        codes = np.rint(smoothed(codes.astype(np.float32), store.fps)).astype(np.int8)
    return codes, has


def root_factor(weights: Mapping[str, float]) -> float:
    """How much the root's travel counts, 0 to 1.6: the legs carry it, so as much as they; 1 for equal weights."""
    legs = [leaf for leaf in LEAVES if "leg" in leaf or "foot" in leaf]
    return float(np.sqrt(sum(weights[leaf] for leaf in legs) / (len(legs) / len(LEAVES))))


def active_columns(weights: Mapping[str, float]) -> tuple[np.ndarray, np.ndarray, int]:
    """Columns with influence, their factors, and how many of them are of the parts: ``(d,)``, ``(d,)``, way.

    The velocities of the root are among them, last, where the legs have a weight.
    """
    factors = column_weights(weights)
    every = np.concatenate([factors, np.full(len(ROOT), root_factor(weights), np.float32)])
    columns = np.flatnonzero(every > 0)
    return columns, every[columns], int((factors > 0).sum())


def _leads(part: QueryPart, weights: Mapping[str, float]) -> tuple[float, float]:
    legs = sum(weights[leaf] for leaf in part.leaves if "leg" in leaf or "foot" in leaf)
    return legs, sum(weights[leaf] for leaf in part.leaves)


def _share(codes: np.ndarray, part: QueryPart, weights: Mapping[str, float]) -> np.ndarray:
    lengths = path_lengths(_weighted(codes, part, weights))
    return lengths / lengths[-1] if lengths[-1] > 0 else np.zeros(len(lengths))


def _weighted(codes: np.ndarray, part: QueryPart, weights: Mapping[str, float]) -> np.ndarray:
    factors = column_weights({leaf: weights[leaf] for leaf in part.leaves})
    return codes[:, :N_COLUMNS] * (factors / 127)


def _laid_along(
    found: np.ndarray, shares: np.ndarray, other: np.ndarray, times: np.ndarray, part: QueryPart
) -> np.ndarray:
    taken = at_shares(other[:, :N_COLUMNS].astype(np.float32), times, shares)
    values = found[:, :N_COLUMNS].copy()
    for leaf in part.leaves:
        values[:, BLOCKS[leaf]] = np.rint(taken[:, BLOCKS[leaf]])
    return values
