"""Stability of motifs: against separate analyses one after the other, and what it must say in clear cases."""

from __future__ import annotations

import json
from dataclasses import replace

import numpy as np
import pytest

from core.editing.noise import shake_dataset
from core.motifs.build import MotifParameters, find_motifs
from core.motifs.neighbours import neighbours, other_seeds
from core.motifs.stability import StabilityParameters, from_json, stability
from core.progress import Cancelled
from tests.core.motifs.recordings import recurring

SMALL = {"kappa": 60, "min_letters": 3}


@pytest.fixture(scope="module")
def dataset():
    return recurring(n_clips=3)


@pytest.fixture(scope="module")
def result(dataset):
    return stability(dataset, StabilityParameters(**SMALL, repetitions=1))


def frames_of(motif):
    return {(s.clip, k) for s in motif.segments for k in range(s.start, s.end)}


def test_every_repeat_is_the_analysis_it_says_and_its_overlaps_are_those_of_the_frames(dataset, result):
    own = MotifParameters(**SMALL)
    base = find_motifs(dataset, own)
    shaken = shake_dataset(dataset, 2.0, (0.5, 5.0), 1)
    alone = {"noise 1": find_motifs(shaken, own)}
    for name, parameters in (other_seeds(own, 1) | neighbours(own, 60)).items():
        alone[name] = find_motifs(dataset, parameters)
    assert [r.name for r in result.repeats] == list(alone)
    assert result.motifs == tuple(motif.id for motif in base.motifs)
    for repeat in result.repeats:
        others = [frames_of(motif) for motif in alone[repeat.name].motifs]
        for overlap, motif in zip(repeat.overlaps, base.motifs, strict=True):
            mine = frames_of(motif)
            assert overlap == pytest.approx(max((len(mine & o) / len(mine | o) for o in others), default=0))
        assert dict(repeat.metrics) == dict(alone[repeat.name].metrics)


def test_kinds_weigh_the_same_in_the_whole(result):
    kinds = result.by_kind()
    assert list(kinds) == ["noise", "seed", "parameters"]
    assert result.overall == pytest.approx(np.mean(list(kinds.values()), axis=0))
    assert ((result.overall >= 0) & (result.overall <= 1)).all()
    assert result.times_kept.tolist() == [
        sum(bool(r.kept[i]) for r in result.repeats) for i in range(len(result.motifs))
    ]


def test_no_noise_finds_the_same_and_much_noise_does_not(dataset):
    calm, wild = (
        stability(dataset, StabilityParameters(**SMALL, repetitions=1, noise_degrees=degrees)).by_kind()["noise"]
        for degrees in (0.0, 40.0)
    )
    assert calm.tolist() == [1.0] * len(calm)
    assert wild.mean() < 0.5


def test_the_same_again_and_there_and_back(dataset, result):
    again = stability(dataset, StabilityParameters(**SMALL, repetitions=1))
    document = json.loads(json.dumps(result.to_json()))
    for other in (again, from_json(document)):
        assert other.motifs == result.motifs
        assert [(r.kind, r.name) for r in other.repeats] == [(r.kind, r.name) for r in result.repeats]
        for a, b in zip(other.repeats, result.repeats, strict=True):
            assert a.overlaps == pytest.approx(b.overlaps, abs=1e-4) and a.kept.tolist() == b.kept.tolist()
    assert document["motifs"][0].keys() == {"id", "stability", "kept", "noise", "seed", "parameters"}


@pytest.mark.parametrize("damage", [{"format": "other"}, {"motifs": []}, {"repeats": [{}]}, {"parameters": None}])
def test_other_documents_are_refused(result, damage):
    with pytest.raises(ValueError, match=r"stability of (the )?motifs"):
        from_json(result.to_json() | damage)


def test_no_motif_is_no_fault(dataset):
    empty = stability(dataset, StabilityParameters(kappa=20, min_letters=90, max_letters=100, repetitions=1))
    assert empty.motifs == () and len(empty.overall) == 0 and empty.to_json()["motifs"] == []


def test_progress_is_told_and_raising_stops_it(dataset):
    said = []

    def stop(stage, fraction):
        said.append((stage, fraction))
        if fraction > 0.4:
            raise Cancelled

    with pytest.raises(Cancelled):
        stability(dataset, StabilityParameters(**SMALL), stop)
    assert any(stage.startswith("analysis 1 of 1") for stage, _ in said)
    assert [f for _, f in said if f] == sorted(f for _, f in said if f)


@pytest.mark.parametrize(
    "wrong", [{"noise_low": 6}, {"repetitions": 0}, {"noise_degrees": -1}, {"noise_degrees": 90}, {"rho": 9.0}]
)
def test_impossible_parameters_are_refused(wrong):
    with pytest.raises(ValueError, match=next(iter(wrong))):
        StabilityParameters(**wrong)


def test_noise_above_half_the_frame_rate_is_refused_in_words(dataset):
    with pytest.raises(ValueError, match="not possible at 30 frames a second"):
        stability(dataset, StabilityParameters(**SMALL, noise_low=20, noise_high=40))


def test_neighbours_are_a_step_away_and_in_range():
    own = MotifParameters(kappa="auto", rho=0.2, gamma=1.0, seed=4)
    found = neighbours(own, 100)
    assert list(found) == ["kappa 80", "kappa 125", "rho 0.25", "gamma 1.1"]
    assert found["rho 0.25"] == replace(own, rho=0.25)
    assert neighbours(own, 2).keys() == {"rho 0.25", "gamma 1.1"}
    assert [p.seed for p in other_seeds(own, 2).values()] == [5, 6]
