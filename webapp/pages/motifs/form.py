"""The parameter form, made from the parameters' own descriptions; only the everyday names are written here."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from typing import Any

import dash_mantine_components as dmc
from dash import html
from dash.development.base_component import Component

from core import analyses
from core.parameters import Parameter, ParameterError
from webapp.components.icons import icon
from webapp.results import MOTIFS

LABELS = {
    "kappa": "Distinct poses (kappa)",
    "rho": "Long or frequent (rho)",
    "gamma": "Speed tolerance (gamma)",
    "min_letters": "Shortest motion",
    "max_letters": "Longest motion",
    "adjacency": "Alike poses",
    "pose": "Compare",
    "analysis_fps": "Frames per second",
    "seed": "Random seed",
}


def parameter_form(values: Mapping[str, Any], kind: str = "parameter", without: Collection[str] = ()) -> Component:
    """One control a parameter, its id of the type ``kind``; the advanced ones folded away."""
    known = [p for p in analyses.parameters(MOTIFS) if p.name not in without]
    folded = [_control(p, values, kind) for p in known if p.advanced]
    parts = [html.Div([_control(p, values, kind) for p in known if not p.advanced], className="form-grid")]
    if folded:
        parts.append(
            dmc.Accordion(
                variant="default",
                className="form-advanced",
                children=dmc.AccordionItem(
                    value="advanced",
                    children=[
                        dmc.AccordionControl("Advanced"),
                        dmc.AccordionPanel(html.Div(folded, className="form-grid")),
                    ],
                ),
            )
        )
    return html.Div(parts)


def read_form(ids: list[dict[str, str]], values: list[Any]) -> tuple[dict[str, Any], dict[str, str]]:
    """Values as the method takes them, and what is wrong with the others: name -> sentence."""
    known = {parameter.name: parameter for parameter in analyses.parameters(MOTIFS)}
    taken: dict[str, Any] = {}
    problems: dict[str, str] = {}
    for component, value in zip(ids, values, strict=True):
        parameter = known[component["name"]]
        if value in (None, ""):
            continue  # an empty control means the default
        try:
            taken[parameter.name] = parameter.parse(value)
        except ParameterError:
            problems[parameter.name] = f"Expected {parameter.expected}."
    return taken, problems


def summary(parameters: Mapping[str, Any]) -> str:
    """A request in one line: only what differs from the defaults."""
    if not parameters:
        return "Default settings"
    return ", ".join(f"{name.replace('_', ' ')} {value}" for name, value in parameters.items())


def _control(parameter: Parameter, values: Mapping[str, Any], kind: str) -> Component:
    label = _label(parameter)
    identity = {"type": kind, "name": parameter.name}
    value = values.get(parameter.name, parameter.default)
    if not parameter.kinds:
        data = [{"value": str(word), "label": str(word).capitalize()} for word in parameter.words]
        return dmc.Select(id=identity, label=label, data=data, value=str(value), allowDeselect=False)
    word = str(parameter.words[0]) if parameter.words else f"{parameter.default:g}"
    return dmc.NumberInput(
        id=identity,
        label=label,
        value="" if value in parameter.words else value,
        placeholder=word,
        min=parameter.minimum,
        max=parameter.maximum,
        step=parameter.step or 1,
        allowDecimal=float in parameter.kinds,
        clampBehavior="none",
    )


def _label(parameter: Parameter) -> Component:
    name = LABELS.get(parameter.name, parameter.name.replace("_", " ").capitalize())
    help_text = parameter.help.strip()
    mark = dmc.Tooltip(
        html.Span(icon("info", 14), className="help-mark", tabIndex="0", role="note", **{"aria-label": help_text}),
        label=help_text,
        events={"hover": True, "focus": True, "touch": True},
    )
    return html.Span([name, mark], className="form-label")
