"""The command ``sweep``: motif graphs over ranges of parameters, as a table and as charts."""

from __future__ import annotations

import io
import json
import time
from argparse import Namespace
from pathlib import Path
from typing import Any

from core import analyses
from core.errors import ParameterError
from core.figures import METRICS, SCORES, Figures, figures_of, read_figures
from core.mocap.dataset import Dataset
from core.mocap.rigs import comparable
from core.motifs.axes import PAPER, SweepParameters, write_axis
from core.motifs.parameters import MotifParameters
from core.motifs.suggestion import suggest
from core.motifs.sweep import graphs_of
from core.motifs.sweep_table import SweepTable
from core.progress import Report
from core.spreadsheets import SheetWriter
from core.workspace import WorkspaceError, atomic_file
from webapp.cli.expected import say_expected
from webapp.cli.progress_bar import progress_bar
from webapp.cli.sources import open_source, say_left_out, stored_dataset

_FIRST = ("kappa", "rho", "seed")


def sweep(arguments: Namespace) -> int:
    """Sweeps and writes sweep.csv, with ``--plot`` charts as well; prints what it suggests."""
    values = sweep_parameters(arguments)
    if arguments.out.is_dir():
        raise WorkspaceError(f"{arguments.out} is a folder; --out names the file to write.")
    if arguments.plot is not None and arguments.plot.exists() and not arguments.plot.is_dir():
        raise WorkspaceError(f"{arguments.plot} is a file; --plot names a folder.")
    started = time.perf_counter()
    with progress_bar(arguments.quiet) as report:
        figures = _figures(arguments, values, report)
    points = values.points()
    table = SweepTable(values.values_of_axes(), values.seeds, figures)
    with atomic_file(arguments.out) as file:
        file.write(rows_as_csv(points, figures, list(table.axes)).encode())
    charts = _write_charts(arguments.plot, table) if arguments.plot is not None else []
    if not arguments.quiet:
        print(f"{len(points)} points in {time.perf_counter() - started:.1f} s, written to {arguments.out}")
        for path in charts:
            print(f"chart written to {path}")
        print(suggest(table).why)
    return 0


def sweep_parameters(arguments: Namespace) -> SweepParameters:
    """The sweep that the options describe: an axis for every option with several values; raises ParameterError."""
    lists = {p.name: getattr(arguments, p.name) for p in analyses.parameters("motifs") if p.name != "seed"}
    if all(len(values) == 1 for values in lists.values()):
        if arguments.kappa == ("auto",) and arguments.rho == (1.0,):
            lists |= PAPER
        elif arguments.seeds == 1:
            raise ParameterError("give one option several values (--kappa 50,100,200), or --seeds more than 1")
    axes = {name: values for name, values in lists.items() if len(values) > 1}
    base = {name: values[0] for name, values in lists.items() if name not in axes} | {"seed": arguments.seed}
    text = ";".join(write_axis(name, values) for name, values in axes.items())
    return SweepParameters(text, arguments.seeds, json.dumps(base))


def rows_as_csv(points: tuple[MotifParameters, ...], figures: list[Figures], axes: list[str]) -> str:
    """A row for each point: kappa (the number used for auto), rho, seed, its figures, then what else is swept."""
    scores = [name for name in SCORES if any(name in entry for entry in figures)]
    more = [name for name in axes if name not in _FIRST]
    text = io.StringIO()
    writer = SheetWriter(text)
    writer.writerow([*_FIRST, *METRICS, "seconds", *scores, *more])
    for point, entry in zip(points, figures, strict=True):
        kappa = int(entry["kappa"]) if point.kappa == "auto" else point.kappa
        cells = [_number(entry[name]) for name in (*METRICS, "seconds", *scores)]
        writer.writerow([kappa, _number(point.rho), point.seed, *cells, *(getattr(point, name) for name in more)])
    return text.getvalue()


def _figures(arguments: Namespace, values: SweepParameters, report: Report) -> list[Figures]:
    """The figures of every point, in order; those of a dataset in a workspace are kept there."""
    named = stored_dataset(arguments)
    if named:
        workspace, name = named
        parameters = {"axes": values.axes, "seeds": values.seeds, "base": values.base}
        say_expected(request := analyses.Request(name, "sweep", parameters), workspace, arguments.quiet)
        analyses.run(workspace, request, report)
        dataset = workspace.open(name)
        keys = [analyses.point_key(dataset.fingerprint, point) for point in values.points()]
        figures = read_figures(workspace, dataset, keys)
        stored = [point for point in figures if point is not None]
        if len(stored) < len(figures):
            raise WorkspaceError("Some results of the sweep are gone again; run it once more.")
        return stored
    dataset = open_source(arguments, report)
    say_left_out(dataset, arguments.quiet)
    asked = {"axes": values.axes, "seeds": values.seeds, "base": values.base}
    say_expected(analyses.Request(dataset.name, "sweep", asked), dataset, arguments.quiet)
    return _in_memory(comparable(dataset), values.points(), report)


def _in_memory(dataset: Dataset, points: tuple[MotifParameters, ...], report: Report) -> list[Figures]:
    by_point: dict[int, Figures] = {}
    for k, graph in graphs_of(dataset, points, report):
        by_point[k] = figures_of(graph, dataset.labels)
    return [by_point[k] for k in range(len(points))]


def _write_charts(folder: Path, table: SweepTable) -> list[Path]:
    from webapp.features.sweeps.figures.drawing import charts

    written = []
    for name, drawing in charts(table):
        path = folder / f"{name}.svg"
        with atomic_file(path) as file:
            file.write(drawing.encode())
        written.append(path)
    return written


def _number(value: Any) -> str:
    return f"{value:.6g}"
