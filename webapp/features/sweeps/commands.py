"""The command ``sweep``: motif graphs over ranges of parameters, as a table and as charts."""

from __future__ import annotations

import csv
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
from core.motifs.axes import PAPER, SweepParameters, write_axis
from core.motifs.parameters import MotifParameters
from core.motifs.suggestion import suggest
from core.motifs.sweep import graphs_of
from core.motifs.sweep_table import SweepTable
from core.progress import Report
from core.workspace import WorkspaceError, atomic_file
from webapp.cli.progress_bar import progress_bar
from webapp.cli.sources import named_dataset, open_source, refuse_reading_options

_FIRST = ("kappa", "rho", "seed")


def sweep(asked: Namespace) -> int:
    """Sweeps and writes sweep.csv, with ``--plot`` charts as well; prints what it suggests."""
    values = asked_sweep(asked)
    if asked.out.is_dir():
        raise WorkspaceError(f"{asked.out} is a folder; --out names the file to write.")
    if asked.plot is not None and asked.plot.exists() and not asked.plot.is_dir():
        raise WorkspaceError(f"{asked.plot} is a file; --plot names a folder.")
    started = time.perf_counter()
    with progress_bar(asked.quiet) as report:
        figures = _figures(asked, values, report)
    points = values.points()
    table = SweepTable(values.values_of_axes(), values.seeds, figures)
    with atomic_file(asked.out) as file:
        file.write(rows_as_csv(points, figures, list(table.axes)).encode())
    charts = _write_charts(asked.plot, table) if asked.plot is not None else []
    if not asked.quiet:
        print(f"{len(points)} points in {time.perf_counter() - started:.1f} s, written to {asked.out}")
        for path in charts:
            print(f"chart written to {path}")
        print(suggest(table).why)
    return 0


def asked_sweep(asked: Namespace) -> SweepParameters:
    """The sweep that the options describe: an axis for every option with several values; raises ParameterError."""
    lists = {p.name: getattr(asked, p.name) for p in analyses.parameters("motifs") if p.name != "seed"}
    if all(len(values) == 1 for values in lists.values()):
        if asked.kappa == ("auto",) and asked.rho == (1.0,):
            lists |= PAPER
        elif asked.seeds == 1:
            raise ParameterError("give one option several values (--kappa 50,100,200), or --seeds more than 1")
    axes = {name: values for name, values in lists.items() if len(values) > 1}
    base = {name: values[0] for name, values in lists.items() if name not in axes} | {"seed": asked.seed}
    text = ";".join(write_axis(name, values) for name, values in axes.items())
    return SweepParameters(text, asked.seeds, json.dumps(base))


def rows_as_csv(points: tuple[MotifParameters, ...], figures: list[Figures], axes: list[str]) -> str:
    """A row a point: kappa (the number used for auto), rho, seed, its figures, then what else is swept."""
    scores = [name for name in SCORES if any(name in entry for entry in figures)]
    more = [name for name in axes if name not in _FIRST]
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow([*_FIRST, *METRICS, "seconds", *scores, *more])
    for point, entry in zip(points, figures, strict=True):
        kappa = int(entry["kappa"]) if point.kappa == "auto" else point.kappa
        cells = [_number(entry[name]) for name in (*METRICS, "seconds", *scores)]
        writer.writerow([kappa, _number(point.rho), point.seed, *cells, *(getattr(point, name) for name in more)])
    return text.getvalue()


def _figures(asked: Namespace, values: SweepParameters, report: Report) -> list[Figures]:
    """Of every point, in order; those of a data set in a workspace are kept there."""
    named = named_dataset(asked.source)
    if named and not asked.clips:
        refuse_reading_options(asked)
        workspace, name = named
        parameters = {"axes": values.axes, "seeds": values.seeds, "base": values.base}
        analyses.run(workspace, analyses.Request(name, "sweep", parameters), report)
        dataset = workspace.open(name)
        keys = [analyses.point_key(dataset.fingerprint, point) for point in values.points()]
        found = read_figures(workspace, dataset, keys)
        if None in found:
            raise WorkspaceError("Some results of the sweep are gone again; run it once more.")
        return found
    return _in_memory(open_source(asked, report), values.points(), report)


def _in_memory(dataset: Dataset, points: tuple[MotifParameters, ...], report: Report) -> list[Figures]:
    found: dict[int, Figures] = {}
    for k, graph in graphs_of(dataset, points, report):
        found[k] = figures_of(graph, dataset.labels)
    return [found[k] for k in range(len(points))]


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
