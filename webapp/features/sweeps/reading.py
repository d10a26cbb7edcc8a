"""A sweep as it stands in the link, in the form and in the job table."""

from __future__ import annotations

import json
import shlex
from collections.abc import Mapping
from dataclasses import asdict
from pathlib import Path
from typing import Any, NamedTuple

from core import analyses
from core.errors import ParameterError
from core.figures import read_figures
from core.mocap.dataset import Dataset
from core.motifs.axes import USUAL, SweepParameters, read_axis, read_values, write_axis
from core.motifs.parameters import MotifParameters
from core.motifs.sweep_table import SweepTable
from core.parameters import write_value
from core.workspace import Workspace
from webapp.shell import links, settings
from webapp.shell.results import MOTIFS

NO_AXIS = "none"
SEEDS = 3
MOST_SEEDS = 20
_LONGEST = 300  # letters of an axis in a link
_ENOUGH_FRAMES = 4  # a letter


class Form(NamedTuple):
    """What people typed: names of the axes, their values as text, the number of seeds."""

    x_name: str
    x_values: str
    y_name: str
    y_values: str
    seeds: str


def form_of(dataset: Dataset | None, view: Mapping[str, str] | None) -> Form:
    """The form that stands for a view; where it says nothing, the paper's ranges."""
    x, y, seeds = ((view or {}).get(key) for key in ("x", "y", "seeds"))
    x_name, _, x_values = (x or write_axis("kappa", _kappas(dataset))).partition(":")
    y_name, _, y_values = (y or write_axis("rho", USUAL["rho"])).partition(":")
    if y_name == x_name and not y:
        y_name = NO_AXIS
    return Form(x_name, x_values.replace(",", ", "), y_name, y_values.replace(",", ", "), seeds or str(SEEDS))


def view_of(form: Form) -> dict[str, str]:
    """The form as it stands in the link."""
    y = f"{form.y_name}:{_compact(form.y_values)}" if form.y_name != NO_AXIS else NO_AXIS
    return {"x": f"{form.x_name}:{_compact(form.x_values)}", "y": y, "seeds": form.seeds.strip()}


def usual_values(dataset: Dataset | None, name: str) -> str:
    """The values to begin with, as text."""
    values = _kappas(dataset) if name == "kappa" else USUAL.get(name, ())
    return ", ".join(map(write_value, values))


def problems_of(form: Form) -> dict[str, str]:
    """Field -> what is wrong with it."""
    messages = {}
    for field, name, text in (("x", form.x_name, form.x_values), ("y", form.y_name, form.y_values)):
        if name != NO_AXIS:
            try:
                read_values(name, text)
            except ParameterError as error:
                messages[field] = _sentence(str(error), name)
            else:
                if len(f"{name}:{_compact(text)}") > _LONGEST:
                    messages[field] = "A link cannot hold that many values; leave some out."
    if form.y_name == form.x_name:
        messages["y"] = "Choose another setting than the first."
    if not form.seeds.isdecimal() or not 1 <= int(form.seeds) <= MOST_SEEDS:
        messages["seeds"] = f"Expected 1 to {MOST_SEEDS}."
    return messages


def sweep_of(form: Form, view: Mapping[str, str] | None) -> SweepParameters:
    """The sweep that a form asks for, all else as the settings in ``view``, seeds from 0. Raises ParameterError."""
    problems = problems_of(form)
    if problems:
        raise ParameterError(" ".join(problems.values()))
    base = dict(settings.request_of(MOTIFS, "", view).parameters) | {"seed": 0}
    axes = [text for text in (view_of(form)["x"], view_of(form)["y"]) if text != NO_AXIS]
    for name, _ in map(read_axis, axes):
        base.pop(name, None)  # the axis says it, and its old value may not fit the others
    return SweepParameters(";".join(axes), int(form.seeds), json.dumps(base))


def link_to_point(dataset: str, point: MotifParameters) -> str:
    """The address that opens the result of a point on the Motifs page."""
    return links.format_link(links.View("motifs", dataset, view=settings.in_link(MOTIFS, asdict(point))))


def request_of(name: str, sweep: SweepParameters) -> analyses.Request:
    """The request for a job that does what is missing of the sweep."""
    return analyses.Request(name, "sweep", {"axes": sweep.axes, "seeds": sweep.seeds, "base": sweep.base})


def table_of(workspace: Workspace, dataset: Dataset, sweep: SweepParameters) -> SweepTable:
    """The figures of the points that have been computed."""
    keys = [analyses.point_key(dataset.fingerprint, point) for point in sweep.points()]
    return SweepTable(sweep.values_of_axes(), sweep.seeds, read_figures(workspace, dataset, keys))


def recipes_of(workspace: Path, name: str, sweep: SweepParameters) -> dict[str, str]:
    """Label -> text to copy: the same sweep as a command and as Python."""
    words = ["motionscape", "sweep", f"{workspace}/{name}"]
    axes, base = sweep.values_of_axes(), json.loads(sweep.base)
    for parameter, values in axes.items():
        words += [f"--{parameter.replace('_', '-')}", ",".join(map(write_value, values))]
    for parameter, value in base.items():
        words += [f"--{parameter.replace('_', '-')}", write_value(value)]
    words += ["--seeds", str(sweep.seeds), "--out", "sweep.csv"]
    base_arguments = ", ".join(f"{parameter}={value!r}" for parameter, value in base.items())
    script = [
        "from core import MotifParameters, Workspace, sweep",
        "",
        f"dataset = Workspace({str(workspace)!r}).open({name!r})",
        f"points = sweep(dataset, MotifParameters({base_arguments}), {axes!r}, seeds={sweep.seeds})",
        "for point in points:",
        "    print(point.parameters.kappa, point.parameters.rho, point.parameters.seed, dict(point.graph.metrics))",
    ]
    return {"Copy as command": shlex.join(words), "Copy as Python": "\n".join(script) + "\n"}


def _kappas(dataset: Dataset | None) -> tuple[Any, ...]:
    """The paper's values of kappa for which there are enough frames (at 30 a second, the default)."""
    most = 30 * dataset.seconds / _ENOUGH_FRAMES if dataset is not None else float("inf")
    return tuple(kappa for kappa in USUAL["kappa"] if float(kappa) <= most) or USUAL["kappa"][:2]


def _compact(values: str) -> str:
    return ",".join(values.replace(",", " ").split())


def _sentence(error: str, name: str) -> str:
    words = error.removeprefix(f"{name}: ")
    return f"{words[:1].upper()}{words[1:]}."
