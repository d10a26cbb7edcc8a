"""Progress moves evenly: what the bar of jobs shows never stands for a tenth of a long analysis."""

from __future__ import annotations

import numpy as np
import pytest

from benchmarks.scale_runs import METHODS, Progress
from core.demo import make_demo
from core.grammar.build import learn_grammar
from core.grammar.induction import induce
from core.motifs import sweep as sweeps
from core.motifs.parameters import MotifParameters
from core.progress import Cancelled


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


def test_the_grouping_of_pieces_moves():
    heard = fractions(lambda report: learn_grammar(make_demo(1), report=report))["grouping"]
    assert heard == sorted(heard) and heard[-1] == 1
    assert len({round(10 * fraction) for fraction in heard}) >= 5


def test_the_search_for_rules_moves():
    rng = np.random.default_rng(0)
    sentences = [rng.integers(0, 8, 12).tolist() for _ in range(60)]
    heard = fractions(lambda report: induce(sentences, report=report))["rules"]
    assert heard == sorted(heard)
    assert len({round(20 * fraction) for fraction in heard}) >= 8


@pytest.mark.parametrize(
    ("method", "stages"),
    [
        (
            "grammar",
            ["reading recordings", "poses", "grouping", "rules"],
        ),
        ("search", ["reading bodies", "reading postures"]),
        ("features", ["poses", "features"]),
    ],
)
def test_a_job_stops_within_each_stage(method, stages):
    demo = make_demo(1)
    for wanted in stages:

        def report(stage: str, fraction: float, wanted: str = wanted) -> None:
            if stage == wanted and fraction < 1:
                raise Cancelled

        with pytest.raises(Cancelled):
            METHODS[method](demo, report)


@pytest.mark.slow
@pytest.mark.parametrize("method", ["motifs", "grammar", "sweep", "redundancy", "stability", "search", "features"])
def test_nothing_stands_for_a_tenth_of_a_long_run(method):
    demo = make_demo(20)
    METHODS[method](make_demo(1), Progress())  # compiles and imports
    progress = Progress()
    METHODS[method](demo, progress)
    progress.end()
    assert progress.standing <= 0.1, progress.stood_at
