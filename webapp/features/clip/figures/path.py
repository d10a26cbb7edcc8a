"""The path of a clip seen from above: the path of the pelvis, its direction, and the footprints."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from core.editing.contacts import runs
from core.editing.curves import ClipCurves
from core.mocap.anatomy import SIDES
from webapp.features.clip.figures.curves import SIDE_COLOURS, Document
from webapp.shell import theme

MOST_POINTS = 2400
ARROWS = 14  # arrows of direction, evenly along the path
HEIGHT = 470


def path_chart(curves: ClipCurves, selection: Mapping[str, Any], scheme: str) -> Document:
    """X to the right and Z down, as seen from above, metres; the selected frames drawn thicker."""
    clip, colours = curves.clip, theme.CANVAS[scheme]
    ground = curves.place("pelvis")[:, [0, 2]].astype(np.float64)
    drawn = np.unique(np.linspace(0, clip.n_frames - 1, min(clip.n_frames, MOST_POINTS)).round().astype(int))
    data = [
        _line(ground, drawn, {"color": colours["muted"], "width": 1.6}, clip.fps),
        selected_part(curves, selection, scheme),
        *_footprints(curves, scheme),
        _arrows(ground, colours),
        _ends(ground, colours),
    ]
    axis = {"gridcolor": colours["soft"], "zeroline": False, "linecolor": colours["line"], "ticks": ""}
    axis |= {"tickfont": {"color": colours["muted"], "size": 11}, "automargin": True}
    (left, right), (near, far) = (_around(ground[:, k]) for k in (0, 1))
    title = {"standoff": 6, "font": {"size": 12}}
    layout = {
        "height": HEIGHT,
        "margin": {"l": 52, "r": 12, "t": 10, "b": 42},
        "paper_bgcolor": "rgba(0,0,0,0)",
        "plot_bgcolor": "rgba(0,0,0,0)",
        "font": {"color": colours["text"], "size": 12, "family": "inherit"},
        "xaxis": axis | {"title": {"text": "X (m)", **title}, "range": [left, right]},
        "yaxis": axis | {"title": {"text": "Z (m)", **title}, "range": [far, near], "scaleanchor": "x"},
        "hovermode": "closest",
        "dragmode": "pan",
        "showlegend": True,
        "legend": {
            "orientation": "h",
            "y": 1,
            "yanchor": "top",
            "x": 1,
            "xanchor": "right",
            "bgcolor": colours["surface"],
        },
        "hoverlabel": {
            "bgcolor": colours["surface"],
            "bordercolor": colours["line"],
            "font": {"color": colours["text"]},
        },
        "meta": {"kind": "path", "clip": clip.name, "fps": clip.fps, "frames": clip.n_frames},
    }
    return {"data": data, "layout": layout}


def selected_part(curves: ClipCurves, selection: Mapping[str, Any], scheme: str) -> Document:
    """The selected frames of the path as a trace of its own; empty where all or nothing is selected."""
    clip = curves.clip
    start, end = (selection.get(key) for key in ("start", "end"))
    frames = np.arange(0)
    if selection.get("clip") == clip.name and isinstance(start, int) and isinstance(end, int) and 0 <= start < end:
        end = min(end, clip.n_frames)
        frames = np.unique(np.linspace(start, end - 1, min(end - start, MOST_POINTS)).round().astype(int))
    ground = curves.place("pelvis")[:, [0, 2]]
    line = _line(ground, frames, {"color": theme.CANVAS[scheme]["accent"], "width": 4}, clip.fps)
    return line | {"name": "selected", "hoverinfo": "skip"}


def _line(ground: np.ndarray, frames: np.ndarray, look: Document, fps: float) -> Document:
    return {
        "type": "scatter",
        "mode": "lines",
        "name": "pelvis",
        "x": _numbers(ground[frames, 0]),
        "y": _numbers(ground[frames, 1]),
        "customdata": frames.tolist(),
        "text": [f"{frame / fps:.2f} s" for frame in frames],
        "hovertemplate": "%{text}<br>%{x:.2f}, %{y:.2f} m<extra></extra>",
        "line": look,
        "showlegend": False,
    }


def _footprints(curves: ClipCurves, scheme: str) -> list[Document]:
    """A dot where the ankle is, on average, while a foot stands."""
    traces = []
    for k, side in enumerate(SIDES):
        if f"{side}_ankle" not in curves.joints:
            continue
        ankle = curves.place(f"{side}_ankle")[:, [0, 2]]
        stances = runs(curves.contacts[:, k])
        at = np.array([ankle[start:end].mean(0) for start, end in stances]).reshape(-1, 2)
        traces.append(
            {
                "type": "scatter",
                "mode": "markers",
                "name": f"{side} foot stands",
                "x": _numbers(at[:, 0]),
                "y": _numbers(at[:, 1]),
                "customdata": [int(start) for start, _ in stances],
                "text": [f"frames {start} to {end}" for start, end in stances],
                "hovertemplate": f"{side} foot<br>%{{text}}<extra></extra>",
                "marker": {"size": 8, "color": SIDE_COLOURS[scheme][side], "opacity": 0.75},
            }
        )
    return traces


def _arrows(ground: np.ndarray, colours: dict[str, str]) -> Document:
    """Arrow heads along the path, none where the body stands still."""
    way = np.r_[0, np.cumsum(np.linalg.norm(np.diff(ground, axis=0), axis=1))]
    at = np.searchsorted(way, (np.arange(ARROWS) + 0.5) / ARROWS * way[-1]) if way[-1] > 0.4 else np.arange(0)
    at = np.unique(np.clip(at, 1, len(ground) - 1)) if len(ground) > 1 else np.arange(0)
    half = max(1, len(ground) // 200)
    ahead = ground[np.minimum(at + half, len(ground) - 1)] - ground[np.maximum(at - half, 0)]
    return {
        "type": "scatter",
        "mode": "markers",
        "x": _numbers(ground[at, 0]),
        "y": _numbers(ground[at, 1]),
        "marker": {
            "symbol": "arrow",
            "size": 11,
            "color": colours["text"],
            "angle": np.degrees(np.arctan2(ahead[:, 0], -ahead[:, 1])).round(1).tolist(),
            "angleref": "up",
        },
        "hoverinfo": "skip",
        "showlegend": False,
    }


def _ends(ground: np.ndarray, colours: dict[str, str]) -> Document:
    return {
        "type": "scatter",
        "mode": "markers+text",
        "x": _numbers(ground[[0, -1], 0]),
        "y": _numbers(ground[[0, -1], 1]),
        "text": ["start", "end"],
        "textposition": ["top center", "bottom center"],
        "marker": {
            "symbol": ["circle", "square"],
            "size": 11,
            "color": [colours["surface"], colours["text"]],
            "line": {"color": colours["text"], "width": 2},
        },
        "hoverinfo": "skip",
        "showlegend": False,
    }


def _around(values: np.ndarray) -> tuple[float, float]:
    """A range with a margin on both sides, at least a stride wide."""
    low, high = float(values.min()), float(values.max())
    room = max(0.12 * (high - low), 0.35, 0.75 - (high - low) / 2)
    return low - room, high + room


def _numbers(values: np.ndarray) -> list[float]:
    return np.asarray(values, np.float64).round(4).tolist()
