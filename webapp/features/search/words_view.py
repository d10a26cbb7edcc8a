"""The view that finds clips and stretches by words: one field, and hits that say which words were seen where."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

import dash_mantine_components as dmc
from dash import Dash, Input, Output, State, html, no_update, set_props
from dash.development.base_component import Component

from core.caching import RecentCache
from core.errors import MotionscapeError
from core.mocap.clip import Label
from core.mocap.dataset import Dataset
from core.retrieval.words.finding import Place, WordHit
from core.retrieval.words.search import Answer, WordSearch
from core.retrieval.words.vocabulary import WORDS
from core.workspace import Workspace
from webapp.features.search import names, searching
from webapp.features.search.word_commands import notes
from webapp.shell.attributes import attributes
from webapp.shell.buttons import sends, similar
from webapp.shell.errors import sentence
from webapp.shell.icons import icon
from webapp.shell.names import DATASET, REVISION, SELECTION, VIEW, VIEW_CHANGE
from webapp.ui.tables import clock, strip_address

LEVELS = {"interval": "Stretches", "clip": "Whole clips"}
SHOWN = 30
HINT = "walk then turn left"
EXAMPLES = ("walk then turn left", "both hands raised", "kick with the right leg", "jump twice", "sit down", "run fast")


def layout() -> Component:
    """The panel before any data is loaded."""
    field = dmc.TextInput(
        id=names.SEARCH_WORDS,
        placeholder=HINT,
        debounce=600,
        size="md",
        leftSection=icon("search", 16),
        className="words-field",
        **attributes(aria_label="What to look for, in words"),
    )
    level = dmc.SegmentedControl(
        id=names.SEARCH_WORDS_LEVEL,
        data=[{"value": value, "label": label} for value, label in LEVELS.items()],
        value="interval",
        size="xs",
        **attributes(aria_label="What is found"),
    )
    return html.Div(
        [
            html.Div(
                [html.Div([field, level], className="words-ask"), _examples(), _vocabulary()],
                className="card words-card",
            ),
            html.Div(id=names.SEARCH_WORDS_FOUND),
        ],
        className="words-view",
    )


def register(app: Dash, workspace: Workspace) -> None:
    """Registers the view's callbacks."""

    @app.callback(
        Input(names.SEARCH_WORDS, "value"),
        Input(names.SEARCH_WORDS_LEVEL, "value"),
        State(VIEW, "data"),
        prevent_initial_call=True,
    )
    def ask(text, level, view):
        shown = view or {}
        if shown.get("look") != "words":
            return
        asked = {"words": (text or "").strip()[:400], "seen": level if level == "clip" else ""}
        if asked != {"words": shown.get("words", ""), "seen": shown.get("seen", "")}:
            set_props(VIEW_CHANGE, {"data": asked})

    @app.callback(
        Output(names.SEARCH_WORDS_FOUND, "children"),
        Output(names.SEARCH_WORDS, "value"),
        Output(names.SEARCH_WORDS_LEVEL, "value"),
        Input(VIEW, "data"),
        Input(DATASET, "data"),
        Input(REVISION, "data"),
        State(names.SEARCH_WORDS, "value"),
    )
    def find(view, name, _revision, typed):
        if (view or {}).get("look") != "words" or not name:
            return no_update, no_update, no_update
        text, level = view.get("words", ""), "clip" if view.get("seen") == "clip" else "interval"
        try:
            found = result(workspace, workspace.open(name), view) if text else []
        except MotionscapeError as error:
            found = [dmc.Alert(sentence(error), color="red", title="This cannot be looked for")]
        return found, no_update if (typed or "").strip() == text else text, level


def answer_of(workspace: Workspace, dataset: Dataset, view: Mapping[str, str]) -> Answer:
    """What a view's words find. Raises ParameterError."""
    place = workspace.path, dataset.fingerprint, dataset.labels
    words = _searches.get_or_compute(place, lambda: WordSearch(dataset))
    index = searching.index_of(workspace, dataset.name, view)
    words.index = (lambda: index) if index is not None else None
    return words.search(view["words"], level="clip" if view.get("seen") == "clip" else "interval", top=SHOWN)


def result(workspace: Workspace, dataset: Dataset, view: Mapping[str, str]) -> list[Component]:
    """The hits of a view, with what is not known said first."""
    answer = answer_of(workspace, dataset, view)
    said = [html.P(note[:1].upper() + note[1:] + ".", className="muted words-note") for note in notes(answer)]
    hits = [hit for hit in answer.hits if hit.score >= 0.01]
    if not hits:
        return [*said, html.P("Nothing shows this.", className="muted section")]
    rows = [_row(dataset, hit, rank) for rank, hit in enumerate(hits, 1)]
    return [*said, html.Div(rows, className="card words-hits", role="list", **attributes(aria_label="Hits"))]


def _row(dataset: Dataset, hit: WordHit, rank: int) -> Component:
    segment, clip = hit.segment, dataset.clip(hit.segment.clip)
    when = f"{clock(segment.start / clip.fps)} to {clock(segment.end / clip.fps)}"
    plays = sends(
        SELECTION, {"clip": segment.clip, "start": int(segment.start), "end": int(segment.end)}, every_time=True
    )
    play = html.Button(
        [
            html.Span(str(rank), className="muted"),
            html.Img(src=strip_address(dataset.name, segment, 5, dataset.fingerprint), alt="", className="words-strip"),
            html.Span(
                [html.B(segment.clip, className="ellipsis"), html.Span(when, className="muted")], className="words-name"
            ),
        ],
        type="button",
        className="words-play",
        title=f"Play {segment.clip}, {when}",
        **plays,
    )
    alike = html.Button(
        icon("search", 14),
        type="button",
        className="search-button",
        title="More like this",
        **similar(segment.clip, segment.start, segment.end),
        **attributes(aria_label="More like this"),
    )
    return html.Div([play, _seen(hit), _score(hit.score), alike], className="words-hit", role="listitem")


def _score(score: float) -> Component:
    bar = html.Span(style={"width": f"{100 * score:.0f}%"})
    return html.Span([html.Span(bar, className="words-bar"), f"{100 * score:.0f} %"], className="words-score")


def _seen(hit: WordHit) -> Component:
    """A line for each word: where in the hit it was seen."""
    lines = []
    for text in dict.fromkeys(place.text for place in hit.places):
        marks = [_mark(hit, place) for place in hit.places if place.text == text]
        lines.append(html.Div([html.Span(text, className="ellipsis"), html.Span(marks, className="words-line")]))
    return html.Div(lines, className="words-seen")


def _mark(hit: WordHit, place: Place) -> Component:
    segment = hit.segment
    start = max(0.0, (place.start - segment.start) / segment.n_frames)
    end = min(1.0, (place.end - segment.start) / segment.n_frames)
    style = {
        "left": f"{100 * start:.1f}%",
        "width": f"{100 * max(end - start, 0.01):.1f}%",
        "opacity": max(place.score, 0.25),
    }
    return html.I(style=style)


def _examples() -> Component:
    links = [
        html.Button(text, type="button", className="search-button", **sends(VIEW_CHANGE, {"words": text}))
        for text in EXAMPLES
    ]
    return html.Div([html.Span("For example", className="muted"), *links], className="words-examples")


def _vocabulary() -> Component:
    """All words that are seen in the motion, with what each means."""
    rows = [html.Div([html.Dt(word.name), html.Dd(word.help)]) for word in sorted(WORDS, key=lambda word: word.name)]
    hint = (
        "These words are seen in the motion itself, in all forms and with others for the same. They are joined by "
        "“and”, “then”, “while” and “without”, and take left, right, both, twice or three times. Names of clips and "
        "labels count as well."
    )
    return html.Details([html.Summary("Words that are known"), html.P(hint, className="muted"), html.Dl(rows)])


_searches: RecentCache[tuple[Path, str, Sequence[Label]], WordSearch] = RecentCache(4)
