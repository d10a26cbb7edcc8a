"""A form for the parameters of any method, made from their descriptions."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import dash_mantine_components as dmc
from dash import html
from dash.development.base_component import Component

from core.errors import ParameterError
from core.parameters import Parameter
from webapp.shell.attributes import attributes
from webapp.shell.icons import icon
from webapp.shell.identifiers import Pattern


def parameter_form(parameters: Sequence[Parameter], values: Mapping[str, Any], control: Pattern) -> Component:
    """A control for each parameter, with the id ``control(name)``; advanced ones are folded."""
    folded = [_control(p, values, control) for p in parameters if p.advanced]
    plain = [_control(p, values, control) for p in parameters if not p.advanced]
    parts: list[Component] = [html.Div(plain, className="form-grid")]
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


def read_form(
    parameters: Sequence[Parameter], ids: Sequence[Mapping[str, str]], values: Sequence[Any]
) -> tuple[dict[str, Any], dict[str, str]]:
    """Values as the method takes them, and what is wrong with the others: name -> sentence."""
    known = {parameter.name: parameter for parameter in parameters}
    parsed: dict[str, Any] = {}
    problems: dict[str, str] = {}
    for component, value in zip(ids, values, strict=True):
        parameter = known[component["name"]]
        if value in (None, ""):
            continue  # an empty control means the default
        try:
            parsed[parameter.name] = parameter.parse(value)
        except ParameterError:
            problems[parameter.name] = f"Expected {parameter.expected}."
    return parsed, problems


def summary(parameters: Mapping[str, Any]) -> str:
    """Settings in one line; only those that differ from the defaults should be given."""
    if not parameters:
        return "Default settings"
    return ", ".join(f"{name.replace('_', ' ')} {value}" for name, value in parameters.items())


def _control(parameter: Parameter, values: Mapping[str, Any], control: Pattern) -> Component:
    label = _label(parameter)
    identity = control(parameter.name)
    value = values.get(parameter.name, parameter.default)
    if bool in parameter.kinds:
        data = [{"value": "true", "label": "Yes"}, {"value": "false", "label": "No"}]
        return dmc.Select(id=identity, label=label, data=data, value=str(value).lower(), allowDeselect=False)
    if not parameter.kinds:
        data = [{"value": str(word), "label": str(word).capitalize()} for word in parameter.words]
        return dmc.Select(id=identity, label=label, data=data, value=str(value), allowDeselect=False)
    if str in parameter.kinds:
        shown = "" if value is None else str(value)
        return dmc.TextInput(id=identity, label=label, value=shown, placeholder=str(parameter.default or ""))
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
    help_text = parameter.help.strip()
    mark = dmc.Tooltip(
        html.Span(
            icon("info", 14), className="help-mark", tabIndex="0", role="note", **attributes(aria_label=help_text)
        ),
        label=help_text,
        events={"hover": True, "focus": True, "touch": True},
    )
    return html.Span([parameter.label, mark], className="form-label")
