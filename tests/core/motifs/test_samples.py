"""Discovery in samples against the exact one, which stays the measure, and what it costs."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from core.errors import ParameterError
from core.motifs.adjacency import nearest_pairs_radius, radius_adjacency
from core.motifs.discovery import largest_first
from core.motifs.leftovers import join_leftovers
from core.motifs.matching import Matcher, Rule, first_cuts
from core.motifs.parameters import MotifParameters
from core.motifs.quantize import k_means
from core.motifs.samples import sampled_first
from core.motifs.volumes import index_of, motif_of, partition
from core.progress import Cancelled
from core.sequences.repeats import remove_runs
from tests.core.motifs.strings import naive_matches, naive_motif, random_adjacency, random_runs


@cache
def repetitive(n_clips: int = 40, seed: int = 0):
    """Clips that are made of a few movements, each repeated many times with noise: runs, their matcher and a rule."""
    rng = np.random.default_rng(seed)
    movements = [np.cumsum(rng.normal(size=(int(rng.integers(20, 40)), 4)), axis=0) for _ in range(6)]
    clips = []
    for _ in range(n_clips):
        parts = []
        for k in rng.integers(0, 6, 5):
            parts += [movements[k] + rng.normal(scale=0.1, size=movements[k].shape), rng.normal(size=(8, 4)) * 3]
        clips.append(np.concatenate(parts))
    poses = np.concatenate(clips).astype(np.float32)
    letters = k_means(poses, 300)
    runs = remove_runs(letters.labels, np.cumsum([0, *map(len, clips)]))
    adjacency = radius_adjacency(letters.centres, nearest_pairs_radius(letters.centres, 0.07))
    return runs, Matcher(runs, adjacency), Rule(5, 30, 1.5, 1.0, 0.545 * adjacency.radius, 10)


@cache
def all_matches():
    """Every match among ``repetitive()``: what the exact search begins with."""
    _, matcher, rule = repetitive()
    return matcher.all(rule)


def total_volume(runs, motifs) -> float:
    middles = runs.middles
    return sum((len(m) - 1) * float(np.mean(middles[m[:, 1]] - middles[m[:, 0]])) for m in motifs)


def test_a_sample_as_long_as_the_string_gives_the_exact_result():
    runs, matcher, rule = repetitive()
    exact = largest_first(runs, all_matches(), rule, 1.0, tightness=0.6)
    sampled = sampled_first(runs, matcher, rule, 1.0, len(runs.letters), tightness=0.6)
    assert len(exact) > 5
    assert [m.tolist() for m in sampled] == [m.tolist() for m in exact]


@pytest.mark.parametrize("rho", [0.2, 1.0, 5.0])
def test_motifs_found_in_samples_are_about_as_large(rho):
    runs, matcher, rule = repetitive()
    exact = total_volume(runs, largest_first(runs, all_matches(), rule, rho, tightness=0.6))
    for seed in range(3):
        sampled = sampled_first(runs, matcher, rule, rho, len(runs.letters) // 3, seed, tightness=0.6)
        assert total_volume(runs, sampled) > 0.95 * exact


@settings(max_examples=25, deadline=None)
@given(seed=st.integers(0, 10**6), size=st.integers(5, 30), rho=st.sampled_from([0.2, 1.0, 5.0]))
def test_every_motif_is_that_of_its_seed_in_the_whole_string(seed, size, rho):
    """However small the sample: a motif has all matches of its seed that were free, and motions do not overlap."""
    rng = np.random.default_rng(seed)
    runs, adjacency = random_runs(rng, 3, 11, kappa=5), random_adjacency(rng, 5, float(rng.uniform(0.3, 0.8)))
    rule, matcher = Rule(2, 5, 1.5, 0.5, np.inf, 0), Matcher(runs, adjacency)
    matches, cut = naive_matches(runs, adjacency, rule), set((runs.stops - 1).tolist())
    for motif in sampled_first(runs, matcher, rule, rho, size, seed):
        motions = [(int(a), int(b)) for a, b in motif]
        assert len(motions) >= 2
        assert motions == naive_motif(runs, motions[0], matches, cut)
        cut |= {t for a, b in motions for t in range(a, b)}


def test_the_same_seed_gives_the_same_motifs_and_another_one_others():
    runs, matcher, rule = repetitive()
    one, two, other = ([m.tolist() for m in sampled_first(runs, matcher, rule, 1.0, 800, seed)] for seed in (3, 3, 4))
    assert one == two != other


def test_progress_never_falls_moves_in_small_steps_and_can_stop_the_search(monkeypatch):
    monkeypatch.setattr("core.motifs.matching._BLOCK", 500)
    runs, matcher, rule = repetitive()
    said: list[float] = []
    sampled_first(runs, matcher, rule, 1.0, 800, report=lambda stage, fraction: said.append(fraction))
    assert len(said) > 10 and said == sorted(said) and said[-1] == 1
    assert max(np.diff([0, *said])) < 0.2

    def stop(stage, fraction):
        raise Cancelled

    with pytest.raises(Cancelled):
        sampled_first(runs, matcher, rule, 1.0, 800, report=stop)


def test_memory_is_that_of_the_sample_however_often_a_motion_recurs(monkeypatch):
    """The most matches that are there at once: four times the repetitions, no more of them in a sample."""
    most = {}
    for n_clips in (40, 160):
        runs, matcher, rule = repetitive(n_clips)
        sizes, find = [], matcher.all
        monkeypatch.setattr(matcher, "all", lambda *a, find=find, sizes=sizes, **k: remember(sizes, find(*a, **k)))
        sampled_first(runs, matcher, rule, 1.0, 1500)
        most[n_clips] = max(sizes)
    everything = len(all_matches().costs)
    assert most[160] < 1.5 * most[40] < everything


def remember(sizes: list[int], matches):
    sizes.append(len(matches.costs))
    return matches


def test_matches_among_some_letters_and_before_cuts_are_those_of_all_that_are_left():
    runs, matcher, rule = repetitive()
    everything, cut = all_matches(), first_cuts(runs)
    motif = largest_first(runs, everything, rule, 1.0)[0]
    partition(motif, cut)
    among = np.flatnonzero(np.random.default_rng(0).random(len(cut)) < 0.6)
    found = matcher.all(rule, cut=cut, among=among)
    lengths = rule.max_letters - rule.min_letters + 1

    def spans(matches):
        rows = np.repeat(np.arange(len(matches.pointers) - 1), np.diff(matches.pointers))
        first = matches.firsts[rows // lengths]
        return np.column_stack([first, first + rows % lengths + rule.min_letters - 1, matches.starts, matches.ends])

    kept = spans(everything)
    kept = kept[(cut[kept[:, 0]] >= kept[:, 1]) & (cut[kept[:, 2]] >= kept[:, 3])]
    kept = kept[np.isin(kept[:, 0], among) & np.isin(kept[:, 2], among)]
    assert len(kept) > 1000
    np.testing.assert_array_equal(spans(found), kept)


def test_many_overlapping_matches_are_chosen_as_by_comparing_all_pairs():
    runs, _, rule = repetitive()
    index, cut = index_of(runs, all_matches(), rule, 0.0), first_cuts(runs)
    seeds = np.flatnonzero(np.diff(index.pointers) > 20)[::97]
    assert len(seeds) > 20
    for k in seeds:
        low, high = index.pointers[k], index.pointers[k + 1]
        motif, _ = motif_of(index, k, cut)
        chosen = [tuple(motif[0])]
        for q in np.argsort(index.costs[low:high], kind="stable") + low:
            a, b = index.starts[q], index.ends[q]
            if all(a >= d or b <= c for c, d in chosen):
                chosen.append((a, b))
        assert motif.tolist() == [list(map(int, motion)) for motion in chosen]


def test_leftovers_join_a_large_motif_by_some_of_its_motions(monkeypatch):
    """Who asks whom changes with the limit; what joins still matches, and never overlaps."""
    runs, matcher, rule = repetitive()
    motifs = [m[: 1 + 2 * len(m) // 3] for m in sampled_first(runs, matcher, rule, 1.0, 1500)]
    loose = rule._replace(max_cost=1.5 * rule.max_cost)
    everyone = join_leftovers(runs, matcher, motifs, loose)
    monkeypatch.setattr("core.motifs.leftovers._ATTRACTORS", 8)
    some = join_leftovers(runs, matcher, motifs, loose)
    n, n_every, n_some = (sum(map(len, m)) for m in (motifs, everyone, some))
    assert n < n_some <= n_every
    taken = np.zeros(len(runs.letters), int)
    for motif in some:
        for a, b in motif:
            taken[a:b] += 1
    assert taken.max() == 1


def test_a_sample_is_none_or_large_enough_to_find_something_in():
    assert MotifParameters(sample=0).sample == 0
    with pytest.raises(ParameterError, match="at least 500"):
        MotifParameters(sample=20)
