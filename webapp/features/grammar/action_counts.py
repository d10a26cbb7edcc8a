"""Comparison of several numbers of actions: those a link asks for, and the results that exist."""

from __future__ import annotations

import json
from collections.abc import Mapping

from core import analyses
from core.grammar.table import TableParameters
from core.parameters import build
from core.workspace import Workspace
from webapp.features.grammar import grammars
from webapp.features.grammar.figures.table import Point
from webapp.shell import settings

TABLE = "grammar-table"
USUAL = TableParameters().counts
View = Mapping[str, str] | None


def counts_text(view: View) -> str:
    """The numbers of a view as text for people."""
    return ", ".join(((view or {}).get("counts") or USUAL).replace(",", " ").split())


def counts_change(text: str | None) -> str:
    """The numbers that someone typed, as a link has them: empty for the defaults."""
    numbers = ",".join((text or "").replace(",", " ").split())
    return "" if numbers == USUAL else numbers


def table_parameters(view: View) -> TableParameters:
    """The numbers a view asks for, and its other settings. Raises ParameterError."""
    base = dict(analyses.normalise(settings.request_of(grammars.PAGE, "", view)).parameters)
    base.pop("n_terminals")
    numbers = ",".join(counts_text(view).replace(",", " ").split())
    return build(TableParameters, {"counts": numbers, "base": json.dumps(base)})


def request(dataset: str, view: View) -> analyses.Request:
    """The request for a job that computes what is missing. Raises ParameterError."""
    sweep = table_parameters(view)
    return analyses.Request(dataset, TABLE, {"counts": sweep.counts, "base": sweep.base})


def points(workspace: Workspace, dataset: str | None, view: View) -> list[Point | None]:
    """The results in order; None where it has not been computed. Raises ParameterError, WorkspaceError."""
    return [_point(workspace, dataset, point) for point in table_parameters(view).points()]


def _point(workspace: Workspace, dataset: str | None, values: Mapping[str, object]) -> Point | None:
    change = settings.view_of(grammars.PAGE, analyses.normalise(analyses.Request("", "grammar", values)).parameters)
    view = {key: text for key, text in change.items() if text}
    key = settings.key_of(workspace, grammars.PAGE, dataset, view)
    learned = grammars.learned(workspace, dataset, view) if key else None
    if key is None or learned is None:
        return None
    terminals, objective = learned.terminals, learned.terminals.objective
    return Point(
        actions=terminals.n_terminals,
        frames=sum(frames for _, frames, _ in terminals.clips),
        segments=sum(map(len, terminals.segments)),
        **{name: objective[name] for name in ("F", "R", "E")},
        rules=len(learned.grammar.rules),
        phrases=len(learned.grammar.nonterminals) - 1,
        sentences=len(learned.sentences),
        bits=learned.bits.total,
        seconds=sum(learned.seconds.values()),
        key=key,
        change=change,
    )
