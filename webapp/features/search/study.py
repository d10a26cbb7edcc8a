"""Do people agree? Pairs to be rated, hits to be compared, and the results (PCR section 5.3)."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any
from urllib.parse import urlencode

import dash_mantine_components as dmc
from dash import Dash, Input, Output, State, dcc, html, no_update, set_props
from dash.dependencies import ClientsideFunction
from dash.development.base_component import Component

from core import analyses
from core.errors import MotionscapeError, ParameterError
from core.evaluation.agreement import agreement, win_rates
from core.mocap.dataset import Dataset
from core.workspace import Workspace, WorkspaceError
from webapp import jobs
from webapp.features.search import names, searching, study_rounds
from webapp.features.search.engines import ENGINES
from webapp.features.search.figures import agreement as figures
from webapp.features.search.queries import write_hit
from webapp.jobs.names import JOBS_FINISHED
from webapp.shell import settings
from webapp.shell.attributes import attributes
from webapp.shell.errors import sentence
from webapp.shell.icons import icon
from webapp.shell.messages import empty_state, notice
from webapp.shell.names import DATASET, JOB_STARTED, NOTICES, THEME, VIEW, VIEW_CHANGE
from webapp.ui.charts import CONFIG, tall
from webapp.ui.downloads import chart_menu
from webapp.ui.tables import clock, strip_address
from webapp.ui.views import panel, register_switch

MODES = {"rate": "Rate pairs", "vote": "Which is more alike?", "results": "Results"}
HINT = (
    "People rate how alike a query and a result are, without knowing which engine found it. "
    "The results tell how well each engine's order agrees with theirs."
)


def layout() -> Component:
    """The panel; assets/search/study.mjs draws its setup, pairs and duels."""
    modes = dmc.SegmentedControl(
        id=names.SEARCH_STUDY,
        data=[{"value": value, "label": label} for value, label in MODES.items()],
        value="rate",
        size="xs",
        **attributes(aria_label="What to do"),
    )
    panels = [
        panel("study", "rate", html.Div(id=names.STUDY_RATE, className="card study-card"), hidden=False),
        panel("study", "vote", html.Div(id=names.STUDY_VOTE, className="card study-card"), hidden=True),
        panel("study", "results", html.Div(id=names.STUDY_RESULTS), hidden=True),
    ]
    stores = (names.STUDY_DATA, names.STUDY_DRAWN, names.STUDY_ANSWER, names.STUDY_RECEIVED, names.STUDY_WISH)
    return html.Div(
        [
            html.P(HINT, className="muted study-hint"),
            html.Div(id=names.STUDY_SETUP, className="card study-setup"),
            html.Div([modes], className="section-head section"),
            *panels,
            *(dcc.Store(id=store) for store in stores),
            dcc.Store(id=names.STUDY_PERSON, storage_type="local"),  # {"id", "name"} of who answers in this browser
        ],
        className="study",
    )


def register(app: Dash, workspace: Workspace) -> None:
    """Registers the study's callbacks."""
    _show(app, workspace)
    _take(app, workspace)
    register_switch(app, names.SEARCH_STUDY)
    app.clientside_callback(
        ClientsideFunction("study", "draw"),
        Output(names.STUDY_DRAWN, "data"),
        Input(names.STUDY_DATA, "data"),
        Input(VIEW, "data"),
        State(names.STUDY_PERSON, "data"),
    )


def _show(app: Dash, workspace: Workspace) -> None:
    @app.callback(
        Output(names.STUDY_DATA, "data"),
        Input(VIEW, "data"),
        Input(DATASET, "data"),
        Input(names.STUDY_PERSON, "data"),
        Input(JOBS_FINISHED, "data"),
        State(names.STUDY_DATA, "data"),
    )
    def gather(view, name, person, finished, before):
        view = view or {}
        if view.get("look") != "agree":
            return no_update
        who = person_of(person)
        relevant = {key: text for key, text in view.items() if key == "asks" or key.startswith("search-")}
        inputs = {"dataset": name or "", "link": relevant, "person": who, "finished": finished or ""}
        if not name:
            return {"inputs": inputs, "error": "Add recordings, or make the demo, in the Library first."}
        if before and before["inputs"] == inputs:
            return no_update
        try:
            return {"inputs": inputs, **study_data(workspace, workspace.open(name), view, who)}
        except MotionscapeError as error:
            return {"inputs": inputs, "error": sentence(error)}

    @app.callback(
        Output(names.STUDY_RESULTS, "children"),
        Input(VIEW, "data"),
        Input(DATASET, "data"),
        Input(names.STUDY_RECEIVED, "data"),
        Input(THEME, "data"),
    )
    def show_results(view, name, _received, scheme):
        if (view or {}).get("look") != "agree" or (view or {}).get("study") != "results" or not name:
            return no_update
        try:
            return results(workspace, name, scheme)
        except WorkspaceError as error:
            return [empty_state("warning", "The results cannot be shown", str(error))]


def study_data(workspace: Workspace, dataset: Dataset, view: Mapping[str, str], person: str) -> dict[str, Any]:
    """The study as the browser shows it. Raises WorkspaceError or ValueError in plain words."""
    ready = study_rounds.ready_engines(workspace, dataset.name, view)
    queries = [query for query in study_rounds.queries_of(view) if query.clip in dataset.names]
    store = workspace.info(dataset.name).id
    rated = {(r.query, r.hit): r.value for r in workspace.ratings.list_ratings(store, person=person)}
    voted = {(v.query, v.left, v.right): v.choice for v in workspace.ratings.list_votes(store, person=person)}
    return {
        "engines": [{"method": m, "label": ENGINES.get(m, m), "ready": ready[m]} for m in ready],
        "queries": [
            {
                "name": write_hit(query),
                "clip": query.clip,
                "when": f"{clock(query.start / dataset.clip(query.clip).fps)}, "
                f"{(query.end - query.start) / dataset.clip(query.clip).fps:.1f} s",
                "strip": strip_address(dataset.name, query, 4, dataset.fingerprint),
            }
            for query in queries
        ],
        "pairs": study_rounds.shown_pairs(dataset, study_rounds.pairs(workspace, dataset, view), person, rated),
        "duels": study_rounds.shown_duels(dataset, study_rounds.duels(workspace, dataset, view, person), person, voted),
    }


def _take(app: Dash, workspace: Workspace) -> None:
    @app.callback(
        Output(names.STUDY_RECEIVED, "data"),
        Input(names.STUDY_ANSWER, "data"),
        State(DATASET, "data"),
        State(VIEW, "data"),
        State(names.STUDY_PERSON, "data"),
        prevent_initial_call=True,
    )
    def keep(request, name, view, person):
        answers = (request or {}).get("answers") or []
        if not answers or not name:
            return no_update
        dataset, who = workspace.open(name), person_of(person)
        for answer in answers:
            try:
                take = study_rounds.keep_vote if answer.get("kind") == "vote" else study_rounds.keep_rating
                take(workspace, dataset, view, answer | {"person": str(answer.get("person") or who)[:80]})
            except MotionscapeError as error:
                message = notice("An answer was not kept", sentence(error), "red")
                set_props(NOTICES, {"sendNotifications": [message]})
        return {"received": [answer.get("id") for answer in answers]}

    app.clientside_callback(ClientsideFunction("study", "received"), Input(names.STUDY_RECEIVED, "data"))

    @app.callback(
        Output(names.STUDY_RECEIVED, "data", allow_duplicate=True),
        Input(names.STUDY_WISH, "data"),
        State(DATASET, "data"),
        State(VIEW, "data"),
        prevent_initial_call=True,
    )
    def grant(wish, name, view):
        """Builds an engine's index, draws queries, or forgets all answers."""
        if not wish or not name:
            return no_update
        try:
            if wish.get("build") in ENGINES:
                request = settings.request_of(searching.PAGE, name, study_rounds.with_engine(view, wish["build"]))
                set_props(JOB_STARTED, {"data": jobs.start(workspace, analyses.normalise(request)).id})
            elif wish.get("draw"):
                drawn = study_rounds.draw_queries(workspace.open(name), int(wish["draw"]))
                both = dict.fromkeys([*study_rounds.queries_of(view), *drawn])
                set_props(VIEW_CHANGE, {"data": {"asks": ",".join(map(write_hit, both))}})
            elif wish.get("clear"):
                removed = workspace.ratings.clear(workspace.info(name).id)
                set_props(NOTICES, {"sendNotifications": [notice("Forgotten", f"{removed} answers were removed.")]})
                return {"at": wish.get("at")}
        except (WorkspaceError, ParameterError) as error:
            set_props(NOTICES, {"sendNotifications": [notice("That did not work", str(error), "red")]})
        return no_update


def person_of(stored: Mapping[str, str] | None) -> str:
    """The person who answers: the name that was given, else the browser's id."""
    stored = stored or {}
    return str(stored.get("name") or stored.get("id") or "")[:80]


def results(workspace: Workspace, name: str, scheme: str | None) -> list[Component]:
    """Tables and charts of all answers about a data set. Raises WorkspaceError."""
    store = workspace.info(name).id
    ratings, votes = workspace.ratings.list_ratings(store), workspace.ratings.list_votes(store)
    if not ratings and not votes:
        return [html.Div(empty_state("person", "No answers yet", "Rate some pairs first."), className="card")]
    people = len({rating.person for rating in ratings} | {vote.person for vote in votes})
    count = f"{len(ratings):,} ratings and {len(votes):,} votes of {people} {'person' if people == 1 else 'people'}"
    query = urlencode({"dataset": name})
    head = html.Div(
        [
            html.Span(count, className="muted"),
            html.Div(className="spacer"),
            html.A(
                [icon("download", 14), "Ratings (CSV)"],
                href=f"/api/search/ratings.csv?{query}",
                className="search-button",
            ),
            html.A(
                [icon("download", 14), "Votes (CSV)"], href=f"/api/search/votes.csv?{query}", className="search-button"
            ),
            html.Button(
                "Forget all answers", type="button", className="search-button", **attributes(data_study="clear")
            ),
        ],
        className="section-head",
    )
    shown: list[Component] = [head]
    if ratings:
        correlations = agreement(ratings)
        ranks = figures.rank_chart(correlations, ENGINES, scheme)
        chart = dcc.Graph(id=names.STUDY_CHART, figure=ranks, config=CONFIG, style=tall(ranks))
        bar = [html.H2("Rank against rank"), html.Div(className="spacer"), chart_menu(names.STUDY_CHART, "ranks")]
        shown += [
            html.Div(figures.means_table(correlations, ENGINES), className="card study-figures"),
            html.Div(figures.correlations_table(correlations, ENGINES), className="card study-figures section"),
            html.Div([html.Div(bar, className="section-head"), chart], className="card study-figures section"),
        ]
    if votes:
        shown.append(html.Div(figures.votes_table(win_rates(votes), ENGINES), className="card study-figures section"))
    return shown
