"""What the Search page shows, as plain values: the query's pieces, hits, explanations, and what the Stage plays."""

from __future__ import annotations

import io
from collections.abc import Mapping, Sequence
from itertools import pairwise
from typing import Any

import numpy as np

from core.mocap.clip import Segment
from core.mocap.dataset import Dataset
from core.poses.body_parts import CHILDREN, LEAVES
from core.retrieval.hits import Explanation, Hit
from core.retrieval.queries import Query, QueryPart
from core.spreadsheets import SheetWriter
from webapp.features.search.names import Strip
from webapp.features.search.queries import nodes_of, write_hit
from webapp.ui.tables import clock, strip_address

COLUMNS = 64  # of the strip that shows which parts match when
SOURCE_COLOURS = ("#4a7cd8", "#d2762b", "#a45fc0", "#c2486a", "#7f8a2e", "#2f95b0")  # none is the hit's
HIT_COLOUR = "#3a9b7a"
_LIMBS = {
    "whole_body": "Whole body",
    "upper_body": "Upper body",
    "lower_body": "Lower body",
    "head_torso": "Head and torso",
    "left_arm_hand": "Left arm and hand",
    "right_arm_hand": "Right arm and hand",
    "left_leg_foot": "Left leg and foot",
    "right_leg_foot": "Right leg and foot",
}


def part_words(node: str) -> str:
    """The everyday name of a node of the body's hierarchy: ``Left arm and hand``."""
    return _LIMBS.get(node) or node.replace("_", " ").capitalize()


def parts_words(leaves: Sequence[str]) -> str:
    """The everyday name of several leaves together: ``Upper body, left leg``."""
    words = ", ".join(part_words(node) for node in nodes_of(leaves))
    return words[:1] + words[1:].lower()


def body() -> dict[str, Any]:
    """The hierarchy and its words, for the body diagram: ``leaves``, ``words``, ``nodes`` (node -> its leaves)."""
    nodes = {node: [leaf for leaf in LEAVES if _below(leaf, node)] for node in CHILDREN}
    return {"leaves": list(LEAVES), "words": {node: part_words(node) for node in CHILDREN}, "nodes": nodes}


def piece_row(source: Dataset, part: QueryPart, number: int, dataset: Dataset) -> dict[str, Any]:
    """One piece of the query: its source, and the parts of the body that it gives."""
    labels = [[label.start, label.end, label.action] for label in source.labels if label.clip == part.clip.name]
    return {
        "clip": part.clip.name,
        "dataset": "" if source.name == dataset.name else source.name,
        "source": source.name,
        "version": source.fingerprint,
        "start": part.start,
        "end": part.end,
        "frames": part.clip.n_frames,
        "fps": part.clip.fps,
        "leaves": list(part.leaves),
        "gives": parts_words(part.leaves),
        "colour": SOURCE_COLOURS[number % len(SOURCE_COLOURS)],
        "labels": labels[:200],
    }


def hit_row(dataset: Dataset, hit: Hit, rank: int, label: str) -> dict[str, Any]:
    """One hit as the list shows it; ``name`` is what the link calls it."""
    segment, clip = hit.segment, dataset.clip(hit.segment.clip)
    whole = segment.start == 0 and segment.end == clip.n_frames
    span = f"{clock(segment.start / clip.fps)} to {clock(segment.end / clip.fps)}"
    return {
        "name": write_hit(segment),
        "rank": rank,
        "clip": segment.clip,
        "start": int(segment.start),
        "end": int(segment.end),
        "when": f"{segment.n_frames / clip.fps:.1f} s" if whole else span,
        "score": round(float(hit.score), 4),
        "label": label,
        "strip": strip_address(dataset.name, segment, 5, dataset.fingerprint),
    }


def strip_of(explanation: Explanation) -> Strip:
    """How well each part of the body matches over the query's time, in at most COLUMNS columns."""
    similarity = np.asarray(explanation.similarity, float)
    n = similarity.shape[1]
    columns = min(n, COLUMNS)
    edges = np.linspace(0, n, columns + 1).astype(int)
    rows: list[list[int]] = []
    means: list[float | None] = []
    for row in similarity:
        cells = [row[a:b][np.isfinite(row[a:b])] for a, b in pairwise(edges)]
        rows.append([round(100 * float(np.clip(cell.mean(), 0, 1))) if cell.size else -1 for cell in cells])
        known = row[np.isfinite(row)]
        means.append(round(float(np.clip(known.mean(), 0, 1)), 3) if known.size else None)
    return {"rows": rows, "means": means}


def pair_request(
    dataset: Dataset, sources: Sequence[Dataset], query: Query, hit: Segment, explanation: Explanation
) -> dict[str, Any]:
    """The query and a hit side by side, in step: the hit along the warp, other pieces of a hybrid stretched evenly.

    sources: the data set of each part of the query.
    """
    length = len(explanation.warp)
    fitting = [part for part in query.parts if part.end - part.start == length]
    leading = query.leading if query.leading in fitting or not fitting else fitting[0]
    items = []
    for number, (part, source) in enumerate(zip(query.parts, sources, strict=True)):
        query_frames = np.arange(length) if part is leading else np.linspace(0, part.end - part.start - 1, length)
        name = "Query" if len(query.parts) == 1 else f"Query: {parts_words(part.leaves).lower()}"
        items.append(_item(source, part, name, SOURCE_COLOURS[number % len(SOURCE_COLOURS)], query_frames))
    warp = np.clip(np.asarray(explanation.warp, float) - hit.start, 0, hit.n_frames - 1)
    shown = {"clip": hit.clip, "start": int(hit.start), "end": int(hit.end), "label": f"Hit: {hit.clip}"}
    whose = {"dataset": dataset.name, "version": dataset.fingerprint}
    hit_item = shown | whose | {"colour": HIT_COLOUR, "warp": _rounded(warp)}
    content = {**whose, "title": f"Query and {hit.clip}", "items": [*items, hit_item]}
    return {**content, "layout": "side", "sync": "warp"}


def query_request(dataset: Dataset, sources: Sequence[Dataset], query: Query) -> dict[str, Any]:
    """The query alone: one figure, or one a piece of a hybrid, each stretched to the leading one's time."""
    leading = query.leading
    length = leading.end - leading.start
    items = []
    for number, (part, source) in enumerate(zip(query.parts, sources, strict=True)):
        name = part.clip.name if len(query.parts) == 1 else parts_words(part.leaves)
        query_frames = np.linspace(0, part.end - part.start - 1, length) if len(query.parts) > 1 else None
        items.append(_item(source, part, name, SOURCE_COLOURS[number % len(SOURCE_COLOURS)], query_frames))
    content = {"dataset": dataset.name, "version": dataset.fingerprint, "title": f"Query: {query.name}", "items": items}
    return {**content, "layout": "overlay" if len(items) == 1 else "side", "sync": "warp"}


def hits_csv(dataset: Dataset, rows: Sequence[tuple[Hit, str]]) -> str:
    """Hits as CSV: rank, clip, frames, seconds, score and label."""
    out = io.StringIO()
    table = SheetWriter(out)
    table.writerow(("rank", "clip", "start_frame", "end_frame", "start_seconds", "end_seconds", "score", "label"))
    for rank, (hit, label) in enumerate(rows, 1):
        segment, fps = hit.segment, dataset.clip(hit.segment.clip).fps
        seconds = (round(segment.start / fps, 4), round(segment.end / fps, 4))
        table.writerow((rank, segment.clip, segment.start, segment.end, *seconds, round(float(hit.score), 6), label))
    return out.getvalue()


def hits_json(
    dataset: Dataset,
    query: Query,
    hits: Sequence[Hit],
    parameters: Mapping[str, Any],
    seconds: Mapping[str, float],
    milliseconds: float,
) -> dict[str, Any]:
    """Hits as hits.json of the command ``search``; seconds: what building the index took, milliseconds: the search."""
    listed = [
        {"clip": h.segment.clip, "start": int(h.segment.start), "end": int(h.segment.end), "score": float(h.score)}
        for h in hits
    ]
    return {
        "format": "motionscape/hits/1",
        "dataset": {"name": dataset.name, "fingerprint": dataset.fingerprint},
        "clips": [{"name": clip.name, "frames": clip.n_frames, "fps": clip.fps} for clip in dataset.clips],
        "parameters": dict(parameters),
        "seconds": dict(seconds),
        "queries": {query.name: {"milliseconds": round(milliseconds, 3), "hits": listed}},
    }


def _item(source: Dataset, part: QueryPart, label: str, colour: str, warp: np.ndarray | None) -> dict[str, Any]:
    item = {"clip": part.clip.name, "start": int(part.start), "end": int(part.end), "label": label, "colour": colour}
    item |= {"dataset": source.name, "version": source.fingerprint}
    return item if warp is None else item | {"warp": _rounded(warp)}


def _rounded(frames: np.ndarray) -> list[float]:
    return [round(float(frame), 2) for frame in frames]


def _below(leaf: str, node: str) -> bool:
    return leaf == node or any(_below(leaf, child) for child in CHILDREN[node])
