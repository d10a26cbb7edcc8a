"""Sweep tables, the motion explained, and which setting is suggested: known trade-offs, flat ones, noisy ones."""

from __future__ import annotations

import numpy as np
import pytest

from core.motifs.suggestion import CLEAR, NONE, UNSURE, suggest
from core.motifs.sweep_table import SweepTable, explained

KAPPAS = (50, 100, 200, 500, 1000)


def figures(coverage: float, ratio: float, motions: float = 1e9) -> dict[str, float]:
    return {
        "coverage": coverage,
        "average_frame_error": 100 * ratio,
        "mean_pose_distance": 100.0,
        "mean_motions": motions,
        "n_motifs": 10.0,
    }


def table(coverage, ratio, seeds: int = 5, noise: float = 0.002, axes=None) -> SweepTable:
    """coverage, ratio: of each cell, in order; noise: standard deviation of the coverage over seeds."""
    rng = np.random.default_rng(0)
    points = [figures(c + rng.normal(0, noise), r) for c, r in zip(coverage, ratio, strict=True) for _ in range(seeds)]
    return SweepTable(axes or {"kappa": KAPPAS}, seeds, points)


def trade_off(**more) -> SweepTable:
    """As in the paper's Figure 5: error falls and levels, coverage falls; 200 explains most."""
    return table((0.95, 0.92, 0.86, 0.6, 0.3), (0.7, 0.42, 0.28, 0.2, 0.17), **more)


def test_a_table_has_a_place_for_every_point():
    axes = {"kappa": (50, 100), "rho": (0.2, 1.0, 5.0)}
    numbers = [{"coverage": k / 10} if k != 3 else None for k in range(12)]
    whole = SweepTable(axes, 2, numbers)
    assert whole.shape == (2, 3, 2) and whole.n_ready == 11
    assert np.array_equal(whole.of("coverage")[0], [[0, 0.1], [0.2, np.nan], [0.4, 0.5]], equal_nan=True)
    assert whole.middle("coverage")[0] == pytest.approx([0.05, 0.2, 0.45])
    assert np.array_equal(whole.along("coverage", "kappa", {"rho": 1.0}), [[0.2, np.nan], [0.8, 0.9]], equal_nan=True)
    assert whole.along("coverage", "rho", {"kappa": 100}).tolist() == [[0.6, 0.7], [0.8, 0.9], [1.0, 1.1]]
    assert whole.has("coverage") and not whole.has("purity") and np.isnan(whole.middle("purity")).all()
    with pytest.raises(ValueError, match="do not fill"):
        SweepTable(axes, 2, numbers[:-1])


def test_where_there_is_no_motif_there_is_no_error():
    entries = [figures(0.9, 0.3), figures(0.8, 0.2), figures(0.3, 0.1), figures(0, 0, 0) | {"n_motifs": 0.0}]
    whole = SweepTable({"kappa": (50, 100, 200, 500)}, 1, entries)
    assert np.isnan(whole.of("average_frame_error")[3, 0]) and np.isnan(whole.of("mean_motions")[3, 0])
    assert whole.of("coverage")[3, 0] == 0 and whole.of("explained")[3, 0] == 0 and whole.of("n_motifs")[3, 0] == 0
    assert "nan" not in suggest(whole).why
    ends = SweepTable({"kappa": (200, 500, 600)}, 1, [entries[2], entries[3], entries[3]])
    assert "at kappa 500 coverage is 30 points lower" in suggest(ends).why


def test_the_motion_explained_counts_coverage_and_likeness():
    assert explained(figures(0.8, 0.25)) == pytest.approx(0.6)
    assert explained(figures(0.8, 1.2)) == 0 and explained(figures(0, 0, 0)) == 0
    assert explained(figures(1, 0)) == 1


def test_motifs_of_two_look_no_tighter_than_motifs_of_many():
    """Motions scattered alike give the same figure, however many there are in a motif."""
    rng = np.random.default_rng(0)
    for n in (2, 3, 8):
        motions = rng.normal(0, 1, (3000, n, 12))
        apart = np.linalg.norm(motions - motions.mean(1, keepdims=True), axis=2).mean()
        entry = figures(1.0, apart / 10, n)
        assert explained(entry) == pytest.approx(1 - np.sqrt(12) / 10, abs=0.01)


def test_a_clear_trade_off_is_found_and_explained():
    found = suggest(trade_off())
    assert (found.verdict, found.at, found.index) == (CLEAR, {"kappa": 200}, (2,))
    assert found.why == (
        "With kappa 200 the motifs explain 62 % of the motion: at kappa 100 the error is 50 % higher, "
        "at kappa 500 coverage is 26 points lower; 5 of 5 seeds agree."
    )


def test_what_is_not_there_yet_is_left_out():
    whole = trade_off()
    part = [entry if k < 10 else None for k, entry in enumerate(whole.figures)]  # kappa 50 and 100
    assert suggest(SweepTable(whole.axes, 5, part)).verdict == NONE
    part = [entry if k != 10 and k < 20 else None for k, entry in enumerate(whole.figures)]
    assert suggest(SweepTable(whole.axes, 5, part)).verdict == CLEAR, "of one setting a seed is missing"
    part = [entry if k < 15 else None for k, entry in enumerate(whole.figures)]
    found = suggest(SweepTable(whole.axes, 5, part))
    assert (found.verdict, found.at) == (UNSURE, {"kappa": 200}) and found.why.endswith("kappa 500 is not there yet.")
    nothing = SweepTable(whole.axes, 5, [None] * 25)
    assert (suggest(nothing).verdict, suggest(nothing).at) == (NONE, {})


def test_no_motifs_anywhere_is_said():
    assert "Nothing recurs" in suggest(table([0.0] * 5, [0.0] * 5, noise=0)).why


def test_flat_sweeps_have_no_clear_trade_off():
    found = suggest(table([0.8] * 5, [0.25] * 5, noise=0.02))
    assert found.verdict == UNSURE and found.why.startswith("No clear trade-off: these settings explain")


def test_seeds_that_disagree_are_no_clear_trade_off():
    rng, points = np.random.default_rng(3), []
    for _ in KAPPAS:
        points += [figures(c, 0.2) for c in rng.uniform(0.3, 0.9, 3)]
    points[0:3] = [figures(0.1, 0.2)] * 3  # so that kappa matters
    points[3:6] = [figures(0.9, 0.2), figures(0.6, 0.2), figures(0.6, 0.2)]
    points[12:15] = [figures(0.3, 0.2), figures(0.95, 0.2), figures(0.95, 0.2)]
    found = suggest(SweepTable({"kappa": KAPPAS}, 3, points))
    assert found.verdict == UNSURE


def test_one_seed_is_not_sure():
    found = suggest(trade_off(seeds=1))
    assert (found.verdict, found.at) == (UNSURE, {"kappa": 200}) and "3 seeds or more" in found.why


def test_the_end_of_a_range_is_said():
    found = suggest(table((0.9, 0.7, 0.5, 0.3, 0.1), [0.2] * 5))
    assert found.verdict == UNSURE and found.at == {"kappa": 50} and "no smaller kappa was tried" in found.why
    assert "at kappa 100 coverage is 20 points lower" in found.why
    lowest = suggest(table((0.9, 0.7, 0.5), [0.2] * 3, axes={"rho": (0.2, 1.0, 5.0)}))
    assert lowest.verdict == CLEAR, "rho cannot be smaller"
    words = suggest(table((0.9, 0.7, 0.5), [0.2] * 3, axes={"kappa": ("auto", 50, 100)}))
    assert (words.verdict, words.at) == (CLEAR, {"kappa": "auto"})


def test_of_equals_the_usual_is_taken():
    axes = {"kappa": (50, 100, 200), "rho": (0.2, 1.0, 5.0)}
    coverage = [c + d for c in (0.5, 0.8, 0.5) for d in (0.001, 0, 0.001)]
    found = suggest(table(coverage, [0.2] * 9, noise=0.01, axes=axes))
    assert found.at == {"kappa": 100, "rho": 1.0} and found.verdict == CLEAR


def test_nothing_but_seeds_is_nothing_to_choose_from():
    assert suggest(SweepTable({}, 4, [figures(0.5, 0.5)] * 4)).verdict == NONE


@pytest.mark.slow
def test_it_comes_near_the_best_agreement_with_labels(shared_data):
    """On labelled exercise clips: the paper's spheres, where kappa matters, and the default, where it hardly does."""
    from core.figures import figures_of
    from core.mocap.dataset import open_dataset
    from core.mocap.labels import read_labels
    from core.motifs.parameters import MotifParameters
    from core.motifs.sweep import sweep

    folder = shared_data / "cmu" / "asfamc"
    clips = "13_29,13_30,13_31,14_14,14_20"
    dataset = open_dataset([folder / "13", folder / "14"], skeleton=folder / "86" / "86.asf", clips=clips)
    labels, axes = read_labels(shared_data / "labels" / "mocap6"), {"kappa": (50, 100, 200, 500, 1000)}
    for adjacency, verdict in (("spheres", CLEAR), ("radius", None)):
        points = sweep(dataset, MotifParameters(adjacency=adjacency), axes, seeds=5)
        whole = SweepTable(axes, 5, [figures_of(point.graph, labels) for point in points])
        found, f1 = suggest(whole), whole.middle("f1_majority")
        assert f1[found.index] >= f1.max() - 0.03 and verdict in (None, found.verdict)
        trend = whole.middle("error_ratio")
        assert trend[0] > trend[2] > trend[4], "the paper's Figure 5: the error falls as kappa rises"
        if adjacency == "spheres":
            assert (np.diff(whole.middle("coverage")) < 0).all()
