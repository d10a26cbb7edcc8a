"""The study's tables and chart: Table 4 (means), Table 5 (rank correlations), Figure 6 (rank against rank) of PCR."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

import plotly.graph_objects as go
from dash import html
from dash.development.base_component import Component

from core.evaluation.agreement import Agreement, Correlation, Share, WinRates
from core.mocap.clip import Segment
from webapp.ui.charts import SERIES, themed

ALL = "All queries"


def means_table(result: Agreement, engines: Mapping[str, str]) -> Component:
    """Mean rating and standard deviation of each engine by query (Table 4); engines: name -> its everyday name."""
    names = _order(result.overall, engines)
    queries = list(dict.fromkeys(query for _, query in result.by_query))
    rows = [[query_words(query), *(_spread(result.by_query.get((name, query))) for name in names)] for query in queries]
    rows.append([ALL, *(_spread(result.overall.get(name)) for name in names)])
    return table("Mean rating ± standard deviation", ["Query", *(engines.get(n, n) for n in names)], rows)


def correlations_table(result: Agreement, engines: Mapping[str, str]) -> Component:
    """Rank correlations with number of pairs and 95 % interval (Table 5)."""
    names = _order(result.overall, engines)
    queries = list(dict.fromkeys(query for _, query in result.by_query))
    rows = []
    for query in queries:
        cells = (_correlation(result.query_correlations.get((name, query))) for name in names)
        rows.append([query_words(query), *cells])
    rows.append([ALL, *(_correlation(result.correlations.get(name), True) for name in names)])
    return table("The engine's rank against people's", ["Query", *(engines.get(n, n) for n in names)], rows)


def votes_table(result: WinRates, engines: Mapping[str, str]) -> Component:
    """Share of votes that each engine's hits won, and how often people prefer the hit that it ranks higher."""
    names = [name for name in engines if name in result.engines or name in result.higher_ranked]
    rows = [[engines[name], _share(result.engines.get(name)), _share(result.higher_ranked.get(name))] for name in names]
    head = ["Engine", "Won against other engines", "Its higher rank was preferred"]
    return table("Which is more alike?", head, rows)


def rank_chart(result: Agreement, engines: Mapping[str, str], scheme: str | None) -> go.Figure:
    """The computer's rank against people's (Figure 6); circles grow with the variance of the ratings."""
    figure = go.Figure()
    names = _order(result.overall, engines)
    most = max((point.computer_rank for point in result.points), default=6)
    figure.add_scatter(
        x=[1, most], y=[1, most], mode="lines", line={"dash": "dot", "color": "#8793a3", "width": 1}, showlegend=False,
        hoverinfo="skip", name="equal ranks",
    )  # fmt: skip
    for number, name in enumerate(names):
        points = [point for point in result.points if point.engine == name]
        shift = 0.12 * (number - (len(names) - 1) / 2)  # engines beside one another where their ranks are equal
        figure.add_scatter(
            x=[point.computer_rank + shift for point in points],
            y=[point.human_rank for point in points],
            mode="markers",
            name=engines.get(name, name),
            marker={
                "color": SERIES[number % len(SERIES)],
                "opacity": 0.75,
                "size": [9 + 5 * math.sqrt(max(point.variance, 0)) for point in points],
                "line": {"width": 1},
            },
            customdata=[
                [query_words(p.query), query_words(p.hit), p.mean_rating, p.variance, p.ratings] for p in points
            ],
            hovertemplate="%{customdata[1]}<br>query %{customdata[0]}<br>mean rating %{customdata[2]:.2f}, "
            "variance %{customdata[3]:.2f}, %{customdata[4]} ratings<extra></extra>",
        )
    themed(figure, scheme, height=340)
    figure.update_xaxes(title_text="Rank by the engine", dtick=1)
    figure.update_yaxes(title_text="Rank by people", dtick=1)
    return figure


def query_words(segment: Segment) -> str:
    """An interval as text for a table."""
    return f"{segment.clip}, {segment.start} to {segment.end}"


def table(caption: str, head: Sequence[str], rows: Sequence[Sequence[str | Component]]) -> Component:
    """A small table with a caption; the first column names the rows, that of all queries stands out."""
    columns = html.Tr([html.Th(name, scope="col") for name in head])
    body = [
        html.Tr(
            [html.Th(row[0], scope="row"), *(html.Td(cell, className="number") for cell in row[1:])],
            className="whole" if row[0] == ALL else "",
        )
        for row in rows
    ]
    return html.Div(
        html.Table([html.Caption(caption), html.Thead(columns), html.Tbody(body)], className="figures-table"),
        className="figures-table-box",
    )


def _order(present: Mapping[str, object], engines: Mapping[str, str]) -> list[str]:
    return [*(name for name in engines if name in present), *(name for name in present if name not in engines)]


def _spread(spread) -> str:
    return "–" if spread is None else f"{spread.mean:.2f} ± {spread.deviation:.2f} ({spread.ratings})"


def _correlation(result: Correlation | None, whole: bool = False) -> str:
    if result is None or not math.isfinite(result.spearman):
        pairs = 0 if result is None else result.pairs
        return f"– ({pairs} pairs)" if pairs else "–"
    low, high = result.spearman_interval
    text = f"ρ {result.spearman:.2f} [{low:.2f}, {high:.2f}], τ {result.kendall:.2f}"
    if whole:
        text += f" [{result.kendall_interval[0]:.2f}, {result.kendall_interval[1]:.2f}]"
    return f"{text} ({result.pairs} pairs)"


def _share(result: Share | None) -> str:
    if result is None or not result.votes:
        return "–"
    low, high = 100 * result.low, 100 * result.high
    return f"{100 * result.share:.0f} % [{low:.0f}, {high:.0f}] ({result.votes} votes)"
