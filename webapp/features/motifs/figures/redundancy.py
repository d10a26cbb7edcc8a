"""The coverage report as a chart and as table rows."""

from __future__ import annotations

from itertools import accumulate
from typing import Any
from urllib.parse import quote, urlencode

import plotly.graph_objects as go

from core.mocap.dataset import Dataset
from core.motifs.graph import MotifGraph
from core.motifs.redundancy import Redundancy
from webapp.ui.charts import SERIES, themed
from webapp.ui.tables import Row, clock, strip_address

SHORT = 0.75  # seconds around a rare posture that are played


def kept_chart(report: Redundancy, scheme: str | None) -> go.Figure:
    """Share of the distinct content against seconds of clips, clip after clip; a line ends the clips to keep."""
    seconds = [0.0, *accumulate(clip.seconds for clip in report.clips)]
    shares = [0.0, *(100 * clip.total for clip in report.clips)]
    names = ["nothing", *(clip.clip for clip in report.clips)]
    figure = go.Figure(
        go.Scatter(
            x=seconds,
            y=shares,
            customdata=names,
            mode="lines+markers" if len(names) < 120 else "lines",
            line={"shape": "linear", "width": 2},
            marker={"size": 5},
            name="Distinct content",
            hovertemplate="with %{customdata}<br>%{x:.0f} s hold %{y:.0f} % of what is distinct<extra></extra>",
        )
    )
    kept, clips = report.metrics["kept_seconds"], report.metrics["kept_clips"]
    figure.add_vline(x=kept, line={"color": SERIES[1], "dash": "dot", "width": 1.5})
    mark = {"text": f"keep-list: {clips:.0f} clips", "showarrow": False, "xanchor": "right", "xshift": -6}
    figure.add_annotation(x=kept, y=4, **mark)
    figure = themed(figure, scheme, height=260)
    figure.update_xaxes(title="Seconds of clips kept", rangemode="tozero")
    return figure.update_yaxes(title="Distinct content held (%)", range=[0, 103])


CLIP_COLUMNS: list[dict[str, Any]] = [
    {"field": "keep", "headerName": "Keep", "width": 74},
    {"field": "clip", "headerName": "Clip", "flex": 1, "minWidth": 120, "tooltipField": "clip"},
    {"field": "seconds", "headerName": "Seconds", "width": 90, "type": "rightAligned"},
    {"field": "share", "headerName": "In motifs (%)", "width": 116, "type": "rightAligned"},
    {
        "field": "gain",
        "headerName": "New (s)",
        "width": 88,
        "type": "rightAligned",
        "headerTooltip": "Seconds that no clip above it on the keep-list has",
    },
    {"field": "kind", "headerName": "What it is", "width": 150},
]


def clip_rows(report: Redundancy) -> list[Row]:
    """A row for each clip, the one that adds most first."""
    return [
        {
            "key": str(number),
            "keep": "yes" if clip.keep else "–",
            "clip": clip.clip,
            "seconds": round(clip.seconds, 1),
            "share": round(100 * clip.share),
            "gain": round(clip.gain, 1),
            "kind": _kind(clip.share, clip.gain / max(clip.seconds, 1e-9)),
            "selection": {"clip": clip.clip},
        }
        for number, clip in enumerate(report.clips)
    ]


def _kind(share: float, fresh: float) -> str:
    if share < 0.25:
        return "mostly unique"
    return "nothing new" if fresh < 0.05 else "mostly repeated" if fresh < 0.35 else ""


def copy_entries(report: Redundancy, graph: MotifGraph, dataset: Dataset) -> list[dict[str, Any]]:
    """Groups of near-duplicates, the largest first: motif, strip of the motion to keep, and what to select for each."""
    motifs = {motif.id: motif for motif in graph.motifs}
    groups = [group for group in report.copies if group.motif in motifs]
    entries = []
    for group in sorted(groups, key=lambda group: (-len(group.motions), group.motif)):
        segments = [motifs[group.motif].segments[i] for i in group.motions]
        entries.append(
            {
                "motif": group.motif,
                "strip": strip_address(dataset.name, segments[0], 6, dataset.fingerprint),
                "motions": [
                    (f"{s.clip} {clock(s.start / dataset.clip(s.clip).fps)}", {"motif": group.motif, "motion": int(i)})
                    for s, i in zip(segments, group.motions, strict=True)
                ],
            }
        )
    return entries


def rare_entries(report: Redundancy, dataset: Dataset) -> list[dict[str, Any]]:
    """Rare postures: icon address, where, and the moment around it to select."""
    entries = []
    for posture in report.rare:
        clip = dataset.clip(posture.clip)
        around = round(SHORT * clip.fps)
        start, end = max(posture.frame - around, 0), min(posture.frame + around + 1, clip.n_frames)
        frame = {"start": posture.frame, "end": posture.frame + 1, "v": dataset.fingerprint[:12]}
        place = f"/api/icon/{quote(dataset.name, safe='')}/{quote(posture.clip, safe='')}"
        entries.append(
            {
                "icons": {scheme: f"{place}?{urlencode(frame | {'scheme': scheme})}" for scheme in ("light", "dark")},
                "where": f"{posture.clip}, {clock(posture.frame / clip.fps)}",
                "times": f"{posture.distance:.1f}×",
                "selection": {"clip": posture.clip, "start": start, "end": end},
            }
        )
    return entries
