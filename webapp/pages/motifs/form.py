"""The parameter form of motif graphs (webapp/components/parameter_form.py): here are the everyday names."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from typing import Any

from dash.development.base_component import Component

from core import analyses
from webapp.components import parameter_form as forms
from webapp.components.parameter_form import summary
from webapp.results import MOTIFS

__all__ = ["LABELS", "parameter_form", "read_form", "summary"]

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
    return forms.parameter_form(known, values, kind, LABELS)


def read_form(ids: list[dict[str, str]], values: list[Any]) -> tuple[dict[str, Any], dict[str, str]]:
    """Values as the method takes them, and what is wrong with the others: name -> sentence."""
    return forms.read_form(analyses.parameters(MOTIFS), ids, values)
