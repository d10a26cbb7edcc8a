"""The commands ``compare`` and ``stability``: comparisons of motif graphs."""

from __future__ import annotations

import time
from argparse import Namespace
from collections.abc import Iterator

from core.motifs.compare import Comparison, compare
from core.motifs.graph import from_json
from core.motifs.stability import Stability
from core.workspace import WorkspaceError
from webapp.cli.one_result import result_of
from webapp.cli.result_files import read_result, write_json
from webapp.features.motifs.figures.compare import WORDS, sentence


def compare_files(arguments: Namespace) -> int:
    """Compares two motifs.json files: prints the change of each motif, and writes ``--out`` where it is given."""
    if arguments.out is not None and arguments.out.is_dir():
        raise WorkspaceError(f"{arguments.out} is a folder; --out names the file to write.")
    comparison = compare(*(read_result(path, "motifs", from_json) for path in (arguments.first, arguments.second)))
    if arguments.out is not None:
        write_json(arguments.out, comparison.to_json())
    if not arguments.quiet:
        print(
            "\n".join(
                [*_changes(comparison), sentence(comparison), f"adjusted Rand index {comparison.adjusted_rand:.2f}"]
            )
        )
    return 0


def measure_stability(arguments: Namespace) -> int:
    """Measures how stable the motifs of SOURCE are and writes stability.json; prints a table."""
    started = time.perf_counter()
    measured = result_of(arguments, "stability")
    write_json(arguments.out, measured.to_json())
    if not arguments.quiet:
        print("\n".join(_stability_summary(measured)))
        print(f"{time.perf_counter() - started:.1f} s, written to {arguments.out}")
    return 0


def _changes(comparison: Comparison) -> Iterator[str]:
    for fate in comparison.a:
        others = f" {', '.join(map(str, fate.partners))}" if fate.partners else ""
        yield f"{WORDS[fate.change].lower():<8}{fate.motif:>5} ->{others:<12} overlap {fate.best:.2f}"
    for fate in comparison.b:
        if fate.change == "gained":
            yield f"{WORDS[fate.change].lower():<8}{'':>5} -> {fate.motif:<11} overlap {fate.best:.2f}"


def _stability_summary(measured: Stability) -> Iterator[str]:
    yield f"{'repeat':<14}{'stability':>10}{'kept':>8}{'same frames':>13}{'adj. Rand':>11}"
    n = len(measured.motifs)
    for repeat in measured.repeats:
        mean = f"{repeat.overlaps.mean():.2f}" if n else "-"
        n_kept = f"{repeat.kept.sum()}/{n}"
        yield f"{repeat.name:<14}{mean:>10}{n_kept:>8}{repeat.agreement:>13.2f}{repeat.adjusted_rand:>11.2f}"
    if not n:
        yield "no motifs, so there is nothing whose stability could be measured"
    else:
        for kind, values in measured.by_kind().items():
            yield f"mean over {kind}: {values.mean():.2f}"
        yield f"{n} motifs, mean stability {measured.overall.mean():.2f}"
