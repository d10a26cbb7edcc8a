"""Motif scores against a frame-by-frame count and against the outside judge."""

from __future__ import annotations

import importlib.util
from collections import Counter
from itertools import pairwise, permutations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from core.evaluation.coverage import score_motifs
from core.mocap.clip import Label, Segment

ACTIONS = ("jump", "walk", "wave")


def random_case(seed):
    rng = np.random.default_rng(seed)
    labels, motifs = [], [[] for _ in range(int(rng.integers(1, 5)))]
    for clip in ("a", "b"):
        cuts = np.unique(np.concatenate([[0, 60], rng.integers(0, 60, 6)])).tolist()
        for start, end in pairwise(cuts):
            if rng.random() < 0.8:
                labels.append(Label(clip, start, end, ACTIONS[rng.integers(3)]))
            if rng.random() < 0.7:
                middle = max(start + 1, (start + end) // 2 + int(rng.integers(-3, 4)))
                motifs[rng.integers(len(motifs))].append(Segment(clip, start, middle))
    return [m for m in motifs if m], labels or [Label("a", 0, 5, "jump")]


def naive_scores(motifs, labels):
    truth = {(label.clip, f): label.action for label in labels for f in range(label.start, label.end)}
    found = {}
    for number, motif in enumerate(motifs):
        for s in motif:
            for f in range(s.start, s.end):
                found.setdefault((s.clip, f), number)
    pairs = Counter((found[f], truth[f]) for f in truth if f in found)
    sizes, inside = Counter(truth.values()), Counter(found[f] for f in truth if f in found)
    majority = {m: min(ACTIONS, key=lambda a, m=m: (-pairs[m, a], a)) for m in inside}
    purity = sum(pairs[m, majority[m]] for m in inside) / max(sum(inside.values()), 1)
    f1 = []
    for action in sizes:
        mine = [m for m in inside if majority[m] == action]
        f1.append(2 * sum(pairs[m, action] for m in mine) / (sizes[action] + sum(inside[m] for m in mine)))
    columns = [*inside, *[None] * len(sizes)]
    best = max(
        sum(2 * pairs[m, a] / (sizes[a] + inside[m]) for m, a in zip(chosen, sizes, strict=True) if m is not None)
        for chosen in permutations(columns, len(sizes))
    )
    covered = sum(inside.values()) / len(truth)
    return covered, purity, float(np.mean(f1)), best / len(sizes)


@settings(max_examples=40, deadline=None)
@given(seed=st.integers(0, 10**6))
def test_scores_are_what_counting_frames_gives(seed):
    motifs, labels = random_case(seed)
    scores, (coverage, purity, majority, one) = score_motifs(motifs, labels), naive_scores(motifs, labels)
    assert scores.coverage == pytest.approx(coverage) and scores.purity == pytest.approx(purity)
    assert scores.f1_one_to_one == pytest.approx(one) and scores.f1_majority == pytest.approx(majority)


def test_pure_counts_motifs_whose_motions_agree():
    labels = [Label("a", 0, 50, "jump"), Label("a", 50, 100, "walk")]
    one = [Segment("a", 0, 10), Segment("a", 20, 30)]
    two = [Segment("a", 30, 45), Segment("a", 60, 75)]
    assert score_motifs([one], labels).pure == 1
    assert score_motifs([one, two], labels).pure == 0.5


def test_no_motifs_score_nothing_and_no_labels_are_refused():
    assert score_motifs([], [Label("a", 0, 9, "jump")]) == (0, 0, 0, 0, 0)
    with pytest.raises(ValueError, match="no labels"):
        score_motifs([], [])


def test_same_figures_as_the_judge(shared_data):
    path = shared_data.parent / "eval" / "eval_motifs.py"
    if not path.is_file():
        pytest.skip("the judge is not here")
    spec = importlib.util.spec_from_file_location("judge", path)
    judge = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(judge)
    for seed in range(20):
        motifs, labels = random_case(seed)
        numbers = {action: i for i, action in enumerate(sorted({label.action for label in labels}))}
        frames = {c: np.full(max(la.end for la in labels if la.clip == c), -1) for c in {la.clip for la in labels}}
        for label in labels:
            frames[label.clip][label.start : label.end] = numbers[label.action]
        kept = [[s for s in m if s.clip in frames and s.start < len(frames[s.clip])] for m in motifs]
        document = {
            "clips": [{"name": c, "fps": 120} for c in frames],
            "motifs": [{"motions": [s._asdict() for s in m]} for m in kept],
        }
        expected = judge.score(document, frames, len(numbers), 120.0)
        ours = score_motifs(kept, labels)
        for key, value in ours._asdict().items():
            assert value == pytest.approx(float(expected[key]), abs=1e-9), (seed, key)
