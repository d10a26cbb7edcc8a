"""Progress moves evenly: what the bar of jobs shows never stands for a tenth of a long analysis."""

from __future__ import annotations

import pytest

from benchmarks.scale_runs import METHODS, Progress
from core.demo import make_demo
from core.grammar.build import learn_grammar
from core.motifs import sweep as sweeps
from core.motifs.parameters import MotifParameters


def fractions(run) -> dict[str, list[float]]:
    """Stage -> the fractions that a run reported of it, in order."""
    heard: dict[str, list[float]] = {}
    run(lambda stage, fraction: heard.setdefault(stage, []).append(fraction))
    return heard


def test_a_sweep_moves_within_its_points(monkeypatch):
    monkeypatch.setattr(sweeps, "_LOOK", 0.002)  # as if it took long
    demo = make_demo(1)
    heard = fractions(lambda report: sweeps.sweep(demo, MotifParameters(), {"rho": (0.5, 1.0)}, report=report))
    values = [fraction for stage in heard.values() for fraction in stage]
    assert values == sorted(values) and values[-1] == 1
    shown = {round(100 * fraction) for fraction in values}
    assert len(shown) >= 10 and any(0 < fraction < 0.3 for fraction in heard["0 of 2 points"])


def test_the_fine_search_of_the_grammar_moves():
    heard = fractions(lambda report: learn_grammar(make_demo(1), report=report))
    assert len(set(heard["fine search"])) >= 4 and heard["fine search"] == sorted(heard["fine search"])


@pytest.mark.slow
@pytest.mark.parametrize("method", ["motifs", "grammar", "sweep", "redundancy", "stability"])
def test_nothing_stands_for_a_tenth_of_a_long_run(method):
    demo = make_demo(20)
    METHODS[method](make_demo(1), Progress())  # compiles and imports
    progress = Progress()
    METHODS[method](demo, progress)
    progress.end()
    assert progress.standing <= 0.1, progress.stood_at
