"""The tests, intervals and corrections against other implementations, and how often they are wrong by chance."""

from __future__ import annotations

import numpy as np
import pytest
from scipy import stats

from core.errors import AnalysisError, ParameterError
from core.groups.clusters import cluster_test, t_statistics
from core.groups.design import Design, Unit, make_design
from core.groups.permutation import (
    benjamini_hochberg,
    compare_all,
    compare_two,
    effect_size,
    permuted,
    smallest_p,
)
from core.mocap.properties import Properties


def design_of(*sizes: int, paired: bool = False) -> Design:
    groups = tuple("ABCDEF"[: len(sizes)])
    units = [
        Unit(f"s{k}" if paired else f"{g}{k}", g, (f"{g}{k}",))
        for g, n in zip(groups, sizes, strict=True)
        for k in range(n)
    ]
    return Design("group", groups, tuple(units), "subject", paired)


@pytest.fixture
def rng():
    return np.random.default_rng(5)


def test_exact_p_values_are_those_of_scipy(rng):
    values = rng.normal(size=(9, 4)) + np.r_[np.zeros(4), np.ones(5)][:, None]
    tested = compare_two(design_of(4, 5), values, 1000, 200, 0)
    for k in range(4):
        found = stats.permutation_test(
            (values[:4, k], values[4:, k]),
            lambda a, b: abs(b.mean() - a.mean()),
            alternative="greater",
            n_resamples=np.inf,
        )
        assert tested.p[k] == pytest.approx(found.pvalue)
        assert tested.difference[k] == pytest.approx(values[4:, k].mean() - values[:4, k].mean())


def test_exact_paired_p_values_are_those_of_scipy(rng):
    values = rng.normal(size=(12, 3)) + np.r_[np.zeros(6), np.full(6, 0.8)][:, None]
    tested = compare_two(design_of(6, 6, paired=True), values, 1000, 200, 0)
    for k in range(3):
        found = stats.permutation_test(
            (values[6:, k] - values[:6, k],), lambda d: abs(d.mean()), permutation_type="samples",
            alternative="greater", n_resamples=np.inf,
        )  # fmt: skip
        assert tested.p[k] == pytest.approx(found.pvalue)
    difference = values[6:] - values[:6]
    d = difference.mean(0) / difference.std(0, ddof=1) * (1 - 3 / (4 * 5 - 1))
    assert tested.effect == pytest.approx(d)


def test_several_groups_are_tested_at_once(rng):
    values = rng.normal(size=(24, 2))
    values[16:, 0] += 2
    p, eta = compare_all(design_of(8, 8, 8), values, 2000, 0)
    expected = [stats.f_oneway(values[:8, k], values[8:16, k], values[16:, k]).pvalue for k in (0, 1)]
    assert p == pytest.approx(expected, abs=0.04) and p[0] < 0.01 and eta[0] > eta[1]


def test_effects_are_hedges_g(rng):
    values = rng.normal(size=(10, 1))
    a, b = values[:4, 0], values[4:, 0]
    pooled = np.sqrt((3 * a.var(ddof=1) + 5 * b.var(ddof=1)) / 8)
    assert effect_size(design_of(4, 6), values)[0] == pytest.approx((b.mean() - a.mean()) / pooled * (1 - 3 / 31))
    assert effect_size(design_of(2, 2), np.array([[1.0, 0], [1, 0], [3, 0], [3, 0]])).tolist() == [np.inf, 0]


def test_the_correction_is_scipys(rng):
    p = rng.uniform(size=40) ** 2
    assert benjamini_hochberg(p) == pytest.approx(stats.false_discovery_control(p))
    with_gap = benjamini_hochberg(np.r_[p, np.nan])
    assert with_gap[:-1] == pytest.approx(stats.false_discovery_control(p)) and np.isnan(with_gap[-1])


def test_nothing_is_found_too_often_where_there_is_nothing(rng):
    values = rng.exponential(size=(14, 4000))
    tested = compare_two(design_of(7, 7), values, 400, 100, 1)
    assert (tested.p <= 0.05).mean() == pytest.approx(0.05, abs=0.015)
    assert not (benjamini_hochberg(tested.p) <= 0.05).any()
    covered = (tested.low <= 0) & (tested.high >= 0)
    assert covered.mean() > 0.85  # percentile intervals of seven people are a little short


def test_columns_with_gaps_are_compared_by_who_has_a_value():
    values = np.array([[1.0, 1], [2, np.nan], [3, np.nan], [7, 4], [8, 5], [9, 6]])
    tested = compare_two(design_of(3, 3), values, 100, 100, 0)
    assert (
        tested.p[0] == pytest.approx(2 / 20) and np.isnan([tested.p[1], tested.difference[1], tested.effect[1]]).all()
    )


def test_labellings_are_all_or_drawn_and_the_observed_is_first(rng):
    all_of = permuted(design_of(3, 3), 1000, rng)
    assert len(all_of) == 20 and len(np.unique(all_of, axis=0)) == 20 and (all_of[0] == [0, 0, 0, 1, 1, 1]).all()
    drawn = permuted(design_of(10, 10), 300, rng)
    assert len(drawn) == 301 and (drawn.sum(1) == 10).all()
    pairs = permuted(design_of(4, 4, paired=True), 100, rng)
    assert len(pairs) == 16 and (pairs[:, :4] + pairs[:, 4:] == 1).all()
    three = permuted(design_of(5, 5, 5, paired=True), 200, rng)
    assert all(sorted(row[[k, k + 5, k + 10]]) == [0, 1, 2] for row in three for k in range(5))
    assert smallest_p(design_of(3, 3), 1000) == pytest.approx(0.1)
    assert smallest_p(design_of(3, 4), 1000) == pytest.approx(1 / 35)
    assert smallest_p(design_of(3, 3, paired=True), 1000) == pytest.approx(0.25)


@pytest.mark.parametrize("paired", [False, True])
def test_t_is_students(rng, paired):
    values = rng.normal(size=(12, 5))
    design = design_of(6, 6, paired=paired)
    t = t_statistics(design, design.codes[None], values)[0]
    test = stats.ttest_rel if paired else stats.ttest_ind
    assert t == pytest.approx(test(values[6:], values[:6]).statistic)


def test_a_difference_along_a_curve_is_found_where_it_is(rng):
    time = np.linspace(0, 1, 101)
    smooth = np.array([np.interp(time, np.linspace(0, 1, 9), rng.normal(size=9)) for _ in range(20)])
    smooth[10:, 40:60] += 3
    test = cluster_test(design_of(10, 10), smooth, 500)
    at = np.flatnonzero(test.clusters[0].where)
    assert test.clusters[0].p < 0.01 and test.clusters[0].sign == 1 and abs(at[0] - 40) <= 2 and abs(at[-1] - 59) <= 2
    on_map = rng.normal(size=(16, 9, 9))
    on_map[8:, 2:4, 2:5] -= 3
    found = cluster_test(design_of(8, 8), on_map, 300).clusters[0]
    assert found.sign == -1 and found.p < 0.05 and found.where[2:4, 2:5].sum() >= 4


def test_curves_without_a_difference_rarely_have_a_cluster(rng):
    curves = rng.normal(size=(300, 12, 20)).cumsum(2)
    hits = [min([c.p for c in cluster_test(design_of(6, 6), one, 200, seed=k).clusters], default=1) <= 0.05
            for k, one in enumerate(curves)]  # fmt: skip
    assert np.mean(hits) < 0.09
    with pytest.raises(ValueError, match="finite"):
        cluster_test(design_of(6, 6), np.full((12, 4), np.nan))


CLIPS = [f"{who}_{state}_{k}" for who in ("ana", "ben", "eve") for state in ("rest", "tired") for k in (1, 2)]


def known(**more: dict[str, str]) -> Properties:
    from core.mocap.property_files import by_pattern

    return Properties().with_values(by_pattern("{subject}_{state}_{take}", CLIPS)[0])


def test_subjects_in_several_groups_are_compared_with_themselves():
    design = make_design(known(), CLIPS, "state")
    assert design.paired and design.unit == "subject" and len(design.units) == 6
    assert design.units[0].clips == ("ana_rest_1", "ana_rest_2") and design.groups == ("rest", "tired")
    clips = [clip for clip in CLIPS if clip[:8] != "eve_rest"]
    design = make_design(known(), clips, "state")
    assert [unit.name for unit in design.units] == ["ana", "ben"] * 2 and "1 of 3 subjects" in design.remarks[0]


def test_where_nobody_is_known_clips_are_compared_and_it_is_said():
    design = make_design(known().without_column("subject"), CLIPS, "state")
    assert design.unit == "clip" and len(design.units) == 12 and "clips are compared" in design.remarks[0]


@pytest.mark.parametrize(
    ("by", "options", "words"),
    [
        ("height", {}, "There is no property 'height'"),
        ("subject", {}, r"there are: ana 4, ben 1"),
        ("state", {"groups": ["rest"]}, "One group alone"),
        ("state", {"groups": ["rest", "ill"]}, "No clip has the state 'ill'"),
        ("take", {"paired": "yes"}, "Only 1 of 2"),
        ("many", {}, "“many” has 13 values"),
        ("one", {}, "all 13 clips that have one have x"),
    ],
)
def test_what_cannot_be_compared_is_said_with_counts(by, options, words):
    clips = ["ana_1", "ana_2", "ana_3", "ana_4", "ben_1", *(f"c{k}" for k in range(8))]
    values = {clip: {"many": str(k), "one": "x"} for k, clip in enumerate(clips)}
    for clip in clips[:5]:
        values[clip] |= {"subject": clip[:3], "take": clip[4:], "state": "rest" if clip[4:] in "12" else "tired"}
    if by == "take":
        values = {
            clip: own | {"take": "1" if own.get("take") == "1" else "2"}
            for clip, own in values.items()
            if "take" in own
        }
    with pytest.raises((AnalysisError, ParameterError), match=words):
        make_design(Properties().with_values(values), clips, by, **options)
