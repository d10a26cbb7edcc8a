"""How well rankings agree with labels: a table of measures, precision-recall curves, a confusion matrix."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
import plotly.graph_objects as go
from dash import html
from dash.development.base_component import Component

from core.evaluation.ranking import Measure, RegimeScores
from webapp.features.search.figures.agreement import table
from webapp.shell import theme
from webapp.ui.charts import HEAT, SERIES, themed

REGIMES = {
    "ALL": "All other clips",
    "XSTYLE": "Without clips of the query's own content and style",
}
WORDS = {  # measure: what it is
    "P@20": "share of the first 20 hits that have the query's label",
    "nP@20": "the same, of as many as there are where fewer than 20 have it",
    "mAP": "mean precision at every relevant hit",
    "1-NN": "how often the very first hit has the label",
    "nDCG@20": "graded: content and style count most",
    "styleAUC": "how surely the same style comes before others",
}
MOST_NAMES = 40  # contents whose names fit beside a confusion

Scores = Mapping[str, Mapping[str, RegimeScores]]
"""Engine -> regime -> its scores."""


def measures_table(scores: Scores, regime: str, engines: Mapping[str, str]) -> Component:
    """A row for each engine: each measure's mean with its 95 % interval. engines: name -> its everyday name."""
    scores_by_engine = {name: by[regime] for name, by in scores.items() if regime in by}
    measures = list(dict.fromkeys(m for regime_scores in scores_by_engine.values() for m in regime_scores.measures))
    rows = [
        [engines.get(name, name), *(_cell(regime_scores.measures.get(measure)) for measure in measures)]
        for name, regime_scores in scores_by_engine.items()
    ]
    return table("Agreement with the labels", ["Engine", *measures], rows)


def explained(scores: Scores, regime: str) -> str:
    """The measures of the table explained in one line."""
    measures = dict.fromkeys(m for by in scores.values() if regime in by for m in by[regime].measures)
    return "; ".join(f"{measure}: {WORDS[measure]}" for measure in measures if measure in WORDS) + "."


def curves_chart(scores: Scores, regime: str, engines: Mapping[str, str], scheme: str | None) -> go.Figure:
    """Precision against recall, a line for each engine."""
    figure = go.Figure()
    for number, (name, by) in enumerate(scores.items()):
        if regime in by:
            figure.add_scatter(
                x=by[regime].recall,
                y=by[regime].precision,
                mode="lines",
                name=engines.get(name, name),
                line={"color": SERIES[number % len(SERIES)], "width": 2.2},
                hovertemplate="recall %{x:.0%}, precision %{y:.1%}<extra>%{fullData.name}</extra>",
            )
    themed(figure, scheme, height=320)
    figure.update_xaxes(title_text="Recall: share of the relevant clips found", range=[0, 1.01], tickformat=".0%")
    figure.update_yaxes(title_text="Precision", range=[0, 1.02], tickformat=".0%")
    return figure


def confusion_chart(regime_scores: RegimeScores, scheme: str | None) -> go.Figure:
    """Labels of the nearest hits (columns) for queries of each label (rows), in shares."""
    shares = np.asarray(regime_scores.confusion, float)
    named = len(regime_scores.contents) <= MOST_NAMES
    figure = go.Figure(
        go.Heatmap(
            z=shares,
            x=regime_scores.contents,
            y=regime_scores.contents,
            zmin=0,
            zmax=1,
            colorscale=HEAT[scheme if scheme in HEAT else "light"],
            colorbar={"tickformat": ".0%", "thickness": 12},
            hovertemplate="query: %{y}<br>hit: %{x}<br>%{z:.0%}<extra></extra>",
        )
    )
    side = max(300, min(26 * len(regime_scores.contents) + 120, 680))
    themed(figure, scheme, height=side)
    axis = {"showticklabels": named, "showgrid": False, "title_standoff": 10}
    figure.update_xaxes(title_text="Label of the hits", tickangle=-45, **axis)
    figure.update_yaxes(title_text="Label of the query", autorange="reversed", scaleanchor=None, **axis)
    if len(regime_scores.contents) <= 12:
        figure.update_traces(texttemplate="%{z:.0%}", textfont={"size": 11})
    figure.update_layout(font={"color": theme.CANVAS[scheme if scheme in theme.CANVAS else "light"]["text"]})
    return figure


def _cell(measure: Measure | None) -> str | Component:
    if measure is None or not np.isfinite(measure.mean):
        return "–"
    interval = html.Span(f"{measure.low:.2f} to {measure.high:.2f}", className="interval")
    return html.Span([f"{measure.mean:.3f} ", interval])
