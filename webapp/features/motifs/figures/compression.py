"""Size against error of a motif and of a whole data set, as charts and in sentences."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import plotly.graph_objects as go

from core.motifs.compressed_dataset import WAYS, Compression, Total
from core.motifs.compression import BYTES, METHODS, MOTION_PCA, OWN, OWN_PCA, POSE_PCA, Curves, Point
from webapp.ui.charts import SERIES, themed

MEASURES = {"cm": ("Centimetres", "Mean error of joints (cm)"), "pose": ("Pose distance", "Mean pose distance")}
_COLOURS = {OWN: SERIES[0], OWN_PCA: SERIES[2], MOTION_PCA: SERIES[3], POSE_PCA: SERIES[1]}
_WAY_COLOURS = dict(zip(WAYS, (SERIES[0], SERIES[4], SERIES[2], SERIES[5], SERIES[1], SERIES[3]), strict=True))
HEIGHT = 360  # pixels
_SHARES = (0.05, 0.1, 0.2, 0.3, 0.5)
_TICKS = (0.5, 1, 2, 3, 5, 10, 20, 30, 50, 70, 100)
_ERRORS = (0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100)
_LEAST = 0.02  # smaller errors are those of 16-bit numbers and would only stretch the axis


def motif_chart(curves: Curves, measure: str, scheme: str | None) -> go.Figure:
    """Error against share of the uncompressed size, a line for each method; points: (method, motions, components)."""
    measure = measure if measure in MEASURES else "cm"
    figure = go.Figure()
    for method, name in METHODS.items():
        points = curves.points.get(method, ())
        figure.add_scatter(
            x=[100 * p.numbers / curves.raw for p in points],
            y=[max(getattr(p, measure), _LEAST) for p in points],
            customdata=[[method, p.step.motions, p.step.components, _told(curves, p)] for p in points],
            name=name,
            mode="lines+markers",
            line={"width": 2, "color": _COLOURS[method]},
            marker={"size": 7},
            hovertemplate=f"<b>{name}</b><br>%{{customdata[3]}}<extra></extra>",
        )
    return _log_axes(themed(figure, scheme, height=HEIGHT, hovermode="closest"), MEASURES[measure][1])


def dataset_chart(result: Compression, scheme: str | None) -> go.Figure:
    """Error against size of the whole data set, a line for each way to store it, a point for each tolerance."""
    figure = go.Figure()
    for way, name in WAYS.items():
        totals = result.totals(way)
        figure.add_scatter(
            x=[100 * t.numbers / t.raw for t in totals],
            y=[max(t.cm, _LEAST) for t in totals],
            customdata=[[t.tolerance, _size(t.numbers)] for t in totals],
            name=name,
            mode="lines+markers",
            line={"width": 2, "color": _WAY_COLOURS[way], "dash": "solid" if way.startswith("own") else "dot"},
            marker={"size": 7},
            hovertemplate=f"<b>{name}</b><br>each part within %{{customdata[0]}} cm<br>%{{x:.1f}} % of the size, "
            "%{customdata[1]}<br>%{y:.2f} cm on average<extra></extra>",
        )
    return _log_axes(themed(figure, scheme, height=HEIGHT, hovermode="closest"), MEASURES["cm"][1])


def motif_sentence(curves: Curves) -> str:
    """The error of each method at the smallest round size that all of them reach."""
    best: Mapping[str, Point] = {}
    share = _SHARES[-1]
    for share in _SHARES:
        best = {m: p for m in METHODS if (p := _best_within(curves, m, share)) is not None}
        if len(best) == len(METHODS):
            break
    if not best:
        return "None of the methods makes these motions smaller."
    ranked = sorted(best, key=lambda method: best[method].cm)
    phrases = [f"{best[method].cm:.1f} cm ({_lower(METHODS[method])})" for method in ranked]
    return f"In {100 * share:.0f} % of the size joints are off by {_listed(phrases)}."


def dataset_sentence(result: Compression, tolerance: float = 1.0) -> str:
    """What each way takes within a tolerance in centimetres, the smallest first."""
    totals: dict[str, Total] = {way: result.totals(way, (tolerance,))[0] for way in WAYS}
    ranked: Sequence[str] = sorted(totals, key=lambda way: totals[way].numbers)
    phrases = [f"{100 * totals[way].numbers / totals[way].raw:.0f} % ({_lower(WAYS[way])})" for way in ranked]
    return (
        f"With a mean error of at most {tolerance:g} cm in every part the dataset takes {_listed(phrases)} of its size."
    )


def _listed(parts: Sequence[str]) -> str:
    return parts[0] if len(parts) == 1 else f"{', '.join(parts[:-1])} and {parts[-1]}"


def _best_within(curves: Curves, method: str, share: float) -> Point | None:
    """The point of least error that takes at most this share of the size."""
    points = [p for p in curves.points.get(method, ()) if p.numbers <= share * curves.raw]
    return min(points, key=lambda p: p.cm, default=None)


def _told(curves: Curves, point: Point) -> str:
    share = 100 * point.numbers / curves.raw
    return (
        f"{point.step}<br>{share:.1f} % of the size, {_size(point.numbers)}<br>"
        f"{point.cm:.2f} cm, {point.pose:.1f} in pose space"
    )


def _size(numbers: int) -> str:
    size = BYTES * numbers / 1024
    return f"{size:.1f} kB" if size < 100 else f"{size:.0f} kB" if size < 1024 else f"{size / 1024:.1f} MB"


def _lower(name: str) -> str:
    return name if name.startswith("PCA") else name[:1].lower() + name[1:]


def _log_axes(figure: go.Figure, error: str) -> go.Figure:
    figure.update_xaxes(title={"text": "Size (% of uncompressed)", "font": {"size": 13}}, type="log", tickvals=_TICKS)
    figure.update_yaxes(title={"text": error, "font": {"size": 13}}, type="log", tickvals=_ERRORS)
    figure.update_layout(legend={"font": {"size": 11.5}})
    return figure
