"""The index of one node of the body: its axes, pattern library and pattern index lists (PCR section 3.3)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, NamedTuple

import numpy as np

from core.poses.body_parts import LEVEL, leaves_of
from core.poses.features import principal_directions
from core.retrieval.descriptors import BLOCKS, N_COLUMNS, smoothed
from core.retrieval.frames import UNITS
from core.retrieval.patterns import FIRST_K, PatternLibrary, build_library
from core.retrieval.segmentation import cuts_at, median_surprise, normalise_segments

THRESHOLDS: Mapping[int, float] = {4: 0.5, 3: 0.3, 2: 0.2, 1: 0.1}
"""R for levels 4 (leaves) to 1 (whole body), in the part's own median surprise (see core.retrieval.segmentation)."""

TRAVELLING = ("lower_body", "whole_body")
"""Nodes that may see the root's velocity and turning as well: the legs carry it."""

USUAL, SMALL = 0.4, 0.15
"""Sizes of motions (distance of frames from their mean): of a usual one, and below which there is mostly noise."""

_TRAVEL = np.arange(N_COLUMNS, N_COLUMNS + 4)
_FASTEST = 3.0  # m/s and rad/s: how fast hardly matters beyond
_AXES = 8  # principal axes of a node: more make patterns no better and segmentation slower
_FOR_AXES = 60_000  # frames they are taken from
_FOR_PATTERNS = 40_000  # segments that the patterns are learned from; all others take the nearest


@dataclass(frozen=True)
class PatternSettings:
    """How lists of patterns are made.

    centring: share of the average posture of the ``around`` seconds before and after a frame that is taken off it, and
    arms: that of the arms. evenness: power of the size of the motion in that time by which it is divided.
    max_error: of adaptive k-means, see core.retrieval.patterns; most: patterns of a node; first_k: its first k.
    travel: whether the nodes of TRAVELLING also see how the root travels. smooth: whether frames are averaged with
    their neighbours first, so that jitter makes no segments. fps: of the frames. r: factor on R, see THRESHOLDS. shape:
    how much the course of a segment counts against its mean posture when patterns are compared, 1 as printed.
    """

    centring: float
    max_error: float
    arms: float = 0.0
    evenness: float = 0.0
    seed: int = 0
    around: float = 4.0
    travel: bool = False
    smooth: bool = False
    most: int = 1400
    first_k: int = FIRST_K
    fps: float = 30.0
    r: float = 1.0
    shape: float = 1.0


class NodeReport(NamedTuple):
    """A row of the paper's Tables 1 and 2: frames of a segment (mean, standard deviation), segments and patterns."""

    node: str
    level: int
    mean_frames: float
    deviation: float
    segments: int
    patterns: int


@dataclass(frozen=True, eq=False)
class SymbolList:
    """Pattern index list of a motion: symbols ``(m,)`` int32; cuts ``(m + 1,)``: where its segments begin and end."""

    symbols: np.ndarray
    cuts: np.ndarray


@dataclass(frozen=True, eq=False)
class NodeIndex:
    """One node of all clips.

    mean ``(c,)``, basis ``(c, d)``: principal axes of the node's columns. length: the reference frame number. fps: of
    the frames; threshold: rise of the surprise that ends a segment, learned from the first clips as the patterns were.
    shape: see PatternSettings.
    symbols ``(n_segments,)`` int32: patterns of the segments; begins, ends ``(n_segments,)`` int32: their frames, of
    all clips one after another; starts ``(n_clips + 1,)``: offsets of the clips among the segments.
    """

    node: str
    mean: np.ndarray
    basis: np.ndarray
    length: int
    fps: float
    threshold: float
    shape: float
    library: PatternLibrary
    symbols: np.ndarray
    begins: np.ndarray
    ends: np.ndarray
    starts: np.ndarray

    @property
    def middles(self) -> np.ndarray:
        """Middle of each segment in frames ``(n_segments,)``, ascending."""
        middles: np.ndarray = (self.begins + self.ends) / 2
        return middles

    def windows(self, first: np.ndarray, last: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Ranges of segments, ``(n,)`` each, whose middles lie in frames ``[first, last)``, ``(n,)`` each."""
        return np.searchsorted(self.middles, first), np.searchsorted(self.middles, last)

    def listed(self, columns: np.ndarray) -> SymbolList:
        """The pattern index list of a motion whose centred node columns are ``(n, c)``."""
        track = self._track(columns)
        cuts = cuts_at(track, self.fps, self.threshold)
        rows = comparable(track, cuts[:-1], cuts[1:], self.length, self.shape)
        return SymbolList(self.library.nearest(rows), cuts)

    def extended(self, tracks: Iterator[np.ndarray], first_frame: int) -> NodeIndex:
        """With more clips, given by their centred node columns ``(n, c)``: nearest patterns, nothing learned anew."""
        offset, symbols, begins, ends, counts = first_frame, [], [], [], []
        for columns in tracks:
            if columns.shape[1] == 0:
                counts.append(0)
            else:
                found = self.listed(columns)
                symbols.append(found.symbols)
                begins.append(found.cuts[:-1] + offset)
                ends.append(found.cuts[1:] + offset)
                counts.append(len(found.symbols))
            offset += len(columns)
        return replace(
            self,
            symbols=np.concatenate([self.symbols, *symbols]).astype(np.int32),
            begins=np.concatenate([self.begins, *begins]).astype(np.int32),
            ends=np.concatenate([self.ends, *ends]).astype(np.int32),
            starts=np.concatenate([self.starts, self.starts[-1] + np.cumsum(counts)]).astype(np.int64),
        )

    def report(self) -> NodeReport:
        """The node's row of the paper's Tables 1 and 2."""
        frames = self.ends - self.begins
        spread = (float(frames.mean()), float(frames.std())) if len(frames) else (0.0, 0.0)
        return NodeReport(self.node, LEVEL[self.node], *spread, len(frames), len(self.library.patterns))

    def pack(self) -> tuple[dict[str, Any], dict[str, np.ndarray]]:
        """As a JSON document and arrays (n, ...)."""
        names = ("mean", "basis", "symbols", "begins", "ends", "starts")
        arrays = {name: getattr(self, name) for name in names}
        arrays |= {"patterns": self.library.patterns, "scale": self.library.scale}
        numbers = {"length": self.length, "fps": self.fps, "threshold": self.threshold, "shape": self.shape}
        return {"node": self.node, **numbers}, arrays

    @classmethod
    def unpack(cls, document: Mapping[str, Any], arrays: Mapping[str, np.ndarray]) -> NodeIndex:
        """Back from :meth:`pack` (n, ...)."""
        given = dict(arrays)
        library = PatternLibrary(given.pop("patterns"), given.pop("scale"))
        return cls(
            str(document["node"]),
            given.pop("mean"),
            given.pop("basis"),
            length=document["length"],
            fps=document["fps"],
            threshold=document["threshold"],
            shape=document["shape"],
            library=library,
            **given,
        )

    def _track(self, columns: np.ndarray) -> np.ndarray:
        return np.ascontiguousarray((columns - self.mean) @ self.basis, np.float32)


def build_node(node: str, tracks: Sequence[np.ndarray], settings: PatternSettings) -> NodeIndex | None:
    """The index of one node of all clips, given by their centred node columns ``(n, c)`` (c = 0: the clip lacks it).

    None where no clip has the node.
    """
    there = [track for track in tracks if track.shape[1]]
    if not there:
        return None
    step = max(1, sum(map(len, there)) // _FOR_AXES)
    mean, basis, _ = principal_directions(np.concatenate([track[::step] for track in there]), 0.999)
    mean, basis = mean.astype(np.float32), basis[:, :_AXES].astype(np.float32)
    values = [np.ascontiguousarray((track - mean) @ basis, np.float32) if track.shape[1] else None for track in tracks]
    unit = median_surprise((value for value in values if value is not None), settings.fps)
    threshold = settings.r * THRESHOLDS[LEVEL[node]] * unit
    offset, begins, ends, counts = 0, [], [], []
    for track, value in zip(tracks, values, strict=True):
        cuts = np.zeros(1, np.int64) if value is None else cuts_at(value, settings.fps, threshold)
        begins.append(cuts[:-1] + offset)
        ends.append(cuts[1:] + offset)
        counts.append(len(cuts) - 1)
        offset += len(track)
    begin, end = np.concatenate(begins), np.concatenate(ends)
    length = max(2, round(float((end - begin).mean())))
    whole = [
        np.zeros((len(track), basis.shape[1]), np.float32) if value is None else value
        for track, value in zip(tracks, values, strict=True)
    ]
    rows = comparable(np.concatenate(whole), begin, end, length, settings.shape)
    library, labels = _learned(rows, settings)
    starts = np.concatenate([[0], np.cumsum(counts)]).astype(np.int64)
    frames = begin.astype(np.int32), end.astype(np.int32)
    learned = settings.fps, threshold, settings.shape
    return NodeIndex(node, mean, basis, length, *learned, library, labels, *frames, starts)


def comparable(values: np.ndarray, starts: np.ndarray, ends: np.ndarray, length: int, shape: float) -> np.ndarray:
    """Segments ``[starts, ends)`` of ``values`` (n, d) as they are compared: ``(n_segments, length * d)`` float32.

    Each is brought to ``length`` frames; what differs from its mean posture counts ``shape``.
    """
    rows = normalise_segments(values, starts, ends, length)
    mean = rows.mean(1, keepdims=True)
    compared: np.ndarray = (mean + np.float32(shape) * (rows - mean)) if shape != 1 else rows
    return compared.reshape(len(rows), -1)


def _learned(rows: np.ndarray, settings: PatternSettings) -> tuple[PatternLibrary, np.ndarray]:
    """Library of segments ``(n, ...)`` and all their patterns; of very many a seeded sample is learned from."""
    chosen = np.arange(len(rows))
    if len(rows) > _FOR_PATTERNS:
        chosen = np.sort(np.random.default_rng(settings.seed).permutation(len(rows))[:_FOR_PATTERNS])
    library, labels = build_library(
        rows[chosen],
        max_error=settings.max_error,
        most=settings.most,
        seed=settings.seed,
        first_k=settings.first_k,
    )
    return library, labels if len(chosen) == len(rows) else library.assign(rows)


def node_columns(node: str, codes: np.ndarray, has: Sequence[str], settings: PatternSettings, fps: float) -> np.ndarray:
    """The centred columns ``(n, c)`` float32 of a node, from a clip's codes ``(n, ...)`` (core.retrieval.frames).

    has: leaves of the clip's skeleton; c = 0 where it lacks one of the node's.
    """
    leaves = leaves_of(node)
    if any(leaf not in has for leaf in leaves):
        return np.zeros((len(codes), 0), np.float32)
    columns = np.concatenate([np.arange(BLOCKS[leaf].start, BLOCKS[leaf].stop) for leaf in leaves])
    values: np.ndarray = codes[:, columns] * UNITS[columns]
    if settings.smooth:
        values = smoothed(values, fps)
    if settings.centring > 0:
        shares = [settings.arms if leaf.endswith("arm") else settings.centring for leaf in leaves]
        sizes = [BLOCKS[leaf].stop - BLOCKS[leaf].start for leaf in leaves]
        values = centred(values, np.repeat(shares, sizes), round(settings.around * fps), settings.evenness, len(leaves))
    if settings.travel and node in TRAVELLING:
        values = np.concatenate([values, np.clip(codes[:, _TRAVEL] * UNITS[_TRAVEL], -_FASTEST, _FASTEST)], axis=1)
    return values


def centred(
    values: np.ndarray, shares: np.ndarray | float, around: int, evenness: float = 0.0, leaves: int = 1
) -> np.ndarray:
    """``values`` (n, c) less ``shares`` (c,) of their mean over the ``around`` frames either side: ``(n, c)`` float32.

    What is left is divided by the size of the motion in those frames (a leaf's, where there are ``leaves``), in USUAL,
    to the power ``evenness``.
    """
    mean = _moving_mean(values, around)
    rest: np.ndarray = values - shares * mean
    if evenness > 0:
        size = np.sqrt(_moving_mean((values - mean) ** 2, around).sum(1) / leaves + SMALL**2) / USUAL
        rest /= size[:, None] ** evenness
    return rest.astype(np.float32)


def _moving_mean(values: np.ndarray, around: int) -> np.ndarray:
    sums = np.concatenate([np.zeros((1, values.shape[1])), np.cumsum(values, axis=0, dtype=np.float64)])
    at = np.arange(len(values))
    first, last = np.maximum(at - around, 0), np.minimum(at + around + 1, len(values))
    mean: np.ndarray = (sums[last] - sums[first]) / (last - first)[:, None]
    return mean
