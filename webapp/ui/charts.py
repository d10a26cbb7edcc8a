"""The look of every chart: the theme's colours, a light grid, no toolbar (ui/downloads.py saves charts)."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import plotly.graph_objects as go
from dash import dcc

from webapp.shell import theme

SERIES = ("#3b6abf", "#d2762b", "#3a9b7a", "#a45fc0", "#c2486a", "#7f8a2e", "#2f95b0", "#8c6d53")
FONT = "system-ui, -apple-system, Segoe UI, Roboto, Noto Sans, sans-serif"
CONFIG: dcc.Graph.Config = {"displayModeBar": False, "responsive": True}
HEAT = {"light": "Blues", "dark": "Viridis"}


def themed(figure: go.Figure, scheme: str | None, *, height: int | None = 320, **layout: Any) -> go.Figure:
    """The figure in the colours of ``scheme`` ("light" or "dark"); ``layout`` goes to its layout."""
    c = theme.CANVAS[scheme if scheme in theme.CANVAS else "light"]
    axis = {
        "gridcolor": c["soft"],
        "zerolinecolor": c["line"],
        "linecolor": c["line"],
        "automargin": True,
        "title": {"font": {"size": 12.5}},
    }
    figure.update_layout(
        template="none",
        height=height,
        colorway=list(SERIES),
        paper_bgcolor="rgba(0,0,0,0)",
        plot_bgcolor="rgba(0,0,0,0)",
        font={
            "family": "system-ui, -apple-system, Segoe UI, Roboto, Noto Sans, sans-serif",
            "size": 12.5,
            "color": c["text"],
        },
        margin={"l": 56, "r": 16, "t": 16, "b": 44},
        hoverlabel={"bgcolor": c["surface"], "bordercolor": c["line"], "font": {"color": c["text"]}},
        legend={"orientation": "h", "y": 1.02, "yanchor": "bottom", "x": 0, "bgcolor": "rgba(0,0,0,0)"},
    )
    figure.update_xaxes(**axis)
    figure.update_yaxes(**axis)
    return figure.update_layout(**layout)


def empty() -> go.Figure:
    """An empty chart without axes, for before there is anything to show."""
    bare = {"visible": False}
    clear = {"template": "none", "paper_bgcolor": "rgba(0,0,0,0)", "plot_bgcolor": "rgba(0,0,0,0)"}
    return go.Figure(layout={"xaxis": bare, "yaxis": bare, **clear})


def tall(figure: go.Figure | Mapping[str, Any]) -> dict[str, str]:
    """A style that fixes the container at the chart's height: Plotly loses it when resized while it draws."""
    return {"height": f"{figure['layout']['height']}px"}
