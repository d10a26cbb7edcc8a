"""A comparison as the files groups.json and groups.csv."""

from __future__ import annotations

import csv
import io
import math
from collections.abc import Mapping
from dataclasses import asdict
from typing import Any

from core.groups.comparison import Comparison, CurveDifference, GroupComparison
from core.groups.examples import examples
from core.groups.words import sentences, words_of
from core.mocap.dataset import Dataset

FORMAT = "motionscape/groups/1"
COLUMNS = (
    *("kind", "id", "name", "measure", "unit", "group_a", "group_b", "mean_a", "mean_b", "n_a", "n_b"),
    *("difference", "low", "high", "effect", "p", "q", "significant", "test_unit"),
)


def to_json(found: GroupComparison, dataset: Dataset) -> dict[str, Any]:
    """The document groups.json. Numbers that are not there are null; an infinite effect is written as ±1e9."""
    design, alpha = found.design, found.parameters.alpha
    frames = {clip.name: clip.n_frames for clip in dataset.clips}
    rows = [_row(row, alpha) for row in (*found.rows, *found.transitions)]
    for document, row in zip(rows, (*found.rows, *found.transitions), strict=True):
        if row.q <= alpha:
            document["words"] = f"{row.groups[1]} {words_of(row)}"
            document["examples"] = examples(found, row, frames)
    return {
        "format": FORMAT,
        "dataset": {"name": dataset.name, "fingerprint": dataset.fingerprint},
        "clips": [{"name": clip.name, "frames": clip.n_frames, "fps": clip.fps} for clip in dataset.clips],
        "parameters": asdict(found.parameters) | {"by": design.column, "subject": design.subject},
        "seconds": {stage: round(t, 4) for stage, t in found.seconds.items()},
        "by": design.column,
        "unit": design.unit,
        "paired": design.paired,
        "test": "permutation of " + ("groups within subjects" if design.paired else f"{design.unit}s between groups"),
        "correction": "Benjamini-Hochberg, over items and measures, over figures, over transitions and over curves",
        "effect": "mean difference over its spread, corrected" if design.paired else "Hedges' g",
        "smallest_p": found.least_p,
        "groups": [
            {
                "name": group,
                "units": sum(unit.group == group for unit in design.units),
                "clips": sum(len(unit.clips) for unit in design.units if unit.group == group),
                "minutes": round(found.minutes[group], 3),
            }
            for group in design.groups
        ],
        "units": [{"name": unit.name, "group": unit.group, "clips": list(unit.clips)} for unit in design.units],
        "remarks": list(design.remarks),
        "words": [
            {"text": one.text}
            | ({"kind": one.row.kind, "id": one.row.id, "measure": one.row.measure} if one.row else {})
            for one in sentences(found)
        ],
        "comparisons": [document for document in rows if document["kind"] != "transition"],
        "transitions": [document for document in rows if document["kind"] == "transition"],
        "curves": [_curve(curve, alpha) for curve in found.curves],
    }


def to_csv(document: Mapping[str, Any]) -> str:
    """The rows of a document of :func:`to_json` as CSV, one comparison a line."""
    text = io.StringIO()
    writer = csv.DictWriter(text, COLUMNS, lineterminator="\n", extrasaction="ignore")
    writer.writeheader()
    for row in (*document["comparisons"], *document["transitions"]):
        flat = {
            f"{name}_{letter}": row[f"{key}"][k]
            for k, letter in enumerate("ab")
            for name, key in (("group", "groups"), ("mean", "means"), ("n", "n"))
        }
        low, high = row["interval"]
        writer.writerow({**row, **flat, "low": low, "high": high, "test_unit": document["unit"]})
    return text.getvalue()


def _row(row: Comparison, alpha: float) -> dict[str, Any]:
    return {
        "kind": row.kind,
        "id": row.id,
        "name": row.name,
        "measure": row.measure,
        "unit": row.unit,
        "groups": list(row.groups),
        "means": [_number(mean) for mean in row.means],
        "n": list(row.n),
        "difference": _number(row.difference),
        "interval": [_number(row.low), _number(row.high)],
        "effect": _number(row.effect),
        "p": _number(row.p),
        "q": _number(row.q),
        "p_all": _number(row.p_all),
        "significant": bool(row.q <= alpha),
    }


def _curve(curve: CurveDifference, alpha: float) -> dict[str, Any]:
    return {
        "item": curve.item,
        "curve": curve.curve,
        "unit": curve.unit,
        "groups": list(curve.groups),
        "n": list(curve.n),
        "means": [[round(float(x), 3) for x in mean] for mean in curve.means],
        "spreads": [[round(float(x), 3) for x in spread] for spread in curve.spreads],
        "clusters": [{"start": start, "end": end, "sign": sign, "p": p} for start, end, sign, p in curve.clusters],
        "q": curve.q,
        "significant": bool(curve.q <= alpha),
    }


def _number(value: float) -> float | None:
    if math.isnan(value):
        return None
    return math.copysign(1e9, value) if math.isinf(value) else float(f"{value:.6g}")
