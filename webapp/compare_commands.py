"""The commands ``compare`` and ``stability``: motif graphs held against one another."""

from __future__ import annotations

import json
import time
from argparse import Namespace
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from core import analyses
from core.motifs.compare import Comparison, compare
from core.motifs.graph import MotifGraph, from_json
from core.motifs.stability import Stability
from core.workspace import WorkspaceError
from webapp.commands import write_json
from webapp.figures.compare import WORDS, sentence
from webapp.progress_bar import progress_bar
from webapp.sources import named_dataset, open_source, refuse_reading_options


def compare_files(asked: Namespace) -> int:
    """Compares two motifs.json files: prints what changed, a line a motif, and writes ``--out`` where it is given."""
    if asked.out is not None and asked.out.is_dir():
        raise WorkspaceError(f"{asked.out} is a folder; --out names the file to write.")
    found = compare(_read_graph(asked.first), _read_graph(asked.second))
    if asked.out is not None:
        write_json(asked.out, found.to_json())
    if not asked.quiet:
        print("\n".join([*_changes(found), sentence(found), f"adjusted Rand index {found.adjusted_rand:.2f}"]))
    return 0


def measure_stability(asked: Namespace) -> int:
    """Measures how stable the motifs of SOURCE are and writes stability.json; prints a table."""
    values = {p.name: getattr(asked, p.name) for p in analyses.parameters("stability")}
    analyses.normalise(analyses.Request("", "stability", values))  # refuses before anything is read
    if asked.out.is_dir():
        raise WorkspaceError(f"{asked.out} is a folder; --out names the file to write.")
    named = named_dataset(asked.source)
    started = time.perf_counter()
    with progress_bar(asked.quiet) as report:
        if named and not asked.clips:
            refuse_reading_options(asked)
            found = analyses.run(named[0], analyses.Request(named[1], "stability", values), report)
        else:
            found = analyses.compute(open_source(asked, report), "stability", values, report)
    write_json(asked.out, found.to_json())
    if not asked.quiet:
        print("\n".join(_stability_summary(found)))
        print(f"{time.perf_counter() - started:.1f} s, written to {asked.out}")
    return 0


def _read_graph(path: Path) -> MotifGraph:
    try:
        return from_json(json.loads(path.read_bytes()))
    except (UnicodeDecodeError, json.JSONDecodeError) as error:
        raise WorkspaceError(f"{path} is no JSON file; expected one that `motionscape motifs` wrote.") from error
    except ValueError as error:
        raise WorkspaceError(f"{path}: {error}") from error


def _changes(found: Comparison) -> Iterator[str]:
    for fate in found.a:
        others = f" {', '.join(map(str, fate.partners))}" if fate.partners else ""
        yield f"{WORDS[fate.change].lower():<8}{fate.motif:>5} ->{others:<12} overlap {fate.best:.2f}"
    for fate in found.b:
        if fate.change == "gained":
            yield f"{WORDS[fate.change].lower():<8}{'':>5} -> {fate.motif:<11} overlap {fate.best:.2f}"


def _stability_summary(found: Stability) -> Iterator[str]:
    yield f"{'repeat':<14}{'stability':>10}{'kept':>8}{'same frames':>13}{'adj. Rand':>11}"
    n = len(found.motifs)
    for repeat in found.repeats:
        mean = repeat.overlaps.mean() if n else np.nan
        kept = f"{repeat.kept.sum()}/{n}"
        yield f"{repeat.name:<14}{mean:>10.2f}{kept:>8}{repeat.agreement:>13.2f}{repeat.adjusted_rand:>11.2f}"
    if n:
        for kind, values in found.by_kind().items():
            yield f"mean over {kind}: {values.mean():.2f}"
        yield f"{n} motifs, mean stability {found.overall.mean():.2f}"
