"""Compression: what is stored is enough and is counted, least squares, greedy choice, exact blends, whole data sets."""

from __future__ import annotations

import json
from dataclasses import replace
from functools import cache
from itertools import pairwise

import numpy as np
import pytest

from core.mocap.clip import Clip, Segment
from core.mocap.dataset import Dataset
from core.mocap.kinematics import joint_positions
from core.motifs.alignment import at_frames
from core.motifs.blend_space import blend_space
from core.motifs.channels import channels_of
from core.motifs.compressed_dataset import ALL, CLIP, FORMAT, MOTIF, REST, WAYS, compress_dataset, from_json
from core.motifs.compression import (
    METHODS,
    MOTION_PCA,
    OWN,
    OWN_PCA,
    POSE_PCA,
    Step,
    curves,
    errors,
    motion_errors,
    rebuild,
    rebuilt_clips,
)
from core.motifs.graph import Motif, MotifGraph
from core.motifs.motion_matrices import Motions, motions_of, stored
from core.progress import Cancelled
from tests.core.motifs.test_blend_space import motif_of, scattered


@cache
def punches(n: int = 6) -> Motions:
    return motions_of(blend_space(*motif_of(scattered("punch", range(n)), medoid=2)))


def squared(motions: Motions, method: str, step: Step) -> float:
    return float(((rebuild(motions, method, step)[0] - motions.values) ** 2).sum())


def test_matrices_show_the_motions():
    motions = punches()
    assert motions.n == 6 and motions.starts[-1] == len(motions.values)
    for k, clip in enumerate(scattered("punch", range(6))):
        frames = motions.part(k).stop - motions.part(k).start
        assert frames == pytest.approx(clip.seconds * 30, abs=1.01)
        warped = at_frames(
            motions.moved[k], np.interp(np.arange(frames), motions.warp(k), np.arange(motions.n_moments))
        )
        assert np.allclose(motions.off_grid(motions.moved)[motions.part(k)], warped)
    error, _ = errors(motions.channels, motions.off_grid(motions.moved), motions.values)
    assert error < 1.0, "the common time at 30 frames a second loses less than a centimetre"


def test_what_is_stored_is_enough_and_every_number_is_counted():
    """An unpacker that sees nothing but 16-bit arrays gives the same motions back, and no array is left out."""
    motions = punches()
    lengths = np.diff(motions.starts)
    for step in (Step(1), Step(3), Step(6), Step(2, 5), Step(4, 12)):
        packed = pack(motions, step)
        values, numbers = rebuild(motions, OWN_PCA if step.components else OWN, step)
        assert all(array.dtype == np.float16 for array in packed.values())
        assert numbers == sum(array.size for array in packed.values()) + 3 * motions.n  # where each motion stands
        assert np.allclose(unpack(packed, motions.order, lengths), values, atol=0.05)


def pack(motions: Motions, step: Step) -> dict[str, np.ndarray]:
    kept, packed = motions.order[: step.motions], {"rest": motions.channels.rest}
    frames = np.concatenate([motions.values[motions.part(k)] for k in kept])
    if step.components:
        mean = stored(frames.mean(0))
        basis = stored(np.linalg.svd(frames - mean)[2][: step.components])
        packed |= {"mean": mean, "basis": basis, "frames": (frames - mean) @ basis.T}
    else:
        packed |= {"mean": motions.mean, "frames": frames - motions.mean}
    if step.motions < motions.n:
        packed["weights"] = motions.weights(step.motions)[[k for k in range(motions.n) if k not in kept], 1:]
        packed["knots"] = np.delete(motions.knots, motions.reference, 0)
    return {name: np.asarray(array, np.float16) for name, array in packed.items()}


def unpack(packed: dict[str, np.ndarray], order: tuple[int, ...], lengths: np.ndarray) -> np.ndarray:
    """All motions one after the other; the first of ``order`` has the common time."""
    packed = {name: array.astype(np.float64) for name, array in packed.items()}
    frames = packed["mean"] + (packed["frames"] @ packed["basis"] if "basis" in packed else packed["frames"])
    back, used = {}, 0
    for k in order:
        if used < len(frames):
            back[k], used = frames[used : used + lengths[k]], used + lengths[k]
    others = [k for k in range(len(lengths)) if k not in back]
    if others:
        n = int(lengths[order[0]])
        knots = np.insert(packed["knots"], order[0], np.linspace(0, n - 1, packed["knots"].shape[1]), 0)
        warps = [np.interp(np.arange(n), np.linspace(0, n - 1, knots.shape[1]), warp) for warp in knots]
        bases = [at_frames(back[k], warps[k]) for k in order[: len(back)]]
        for k, weights in zip(others, packed["weights"], strict=True):
            mixed = bases[0] * (1 - weights.sum()) + sum(w * b for w, b in zip(weights, bases[1:], strict=True))
            back[k] = at_frames(mixed, np.interp(np.arange(lengths[k]), warps[k], np.arange(n)))
    return np.concatenate([back[k] for k in range(len(lengths))])


def test_weights_are_the_least_squares():
    motions = punches()
    flat = motions.moved.reshape(motions.n, -1)
    first, *others = motions.order[:3]
    weights = motions.weights(3)
    assert np.allclose(weights.sum(1), 1)
    for k in range(motions.n):
        basis = np.stack([flat[j] - flat[first] for j in others], 1)
        best = np.linalg.lstsq(basis, flat[k] - flat[first], rcond=None)[0]
        assert np.allclose(weights[k, 1:], best, atol=1e-5)


def test_kept_motions_are_chosen_greedily():
    motions = punches()
    flat = motions.moved.reshape(motions.n, -1)
    left = flat - flat[motions.reference]
    chosen = [motions.reference]
    while len(chosen) < motions.n:
        scores = {}
        for j in set(range(motions.n)) - set(chosen):
            direction = left[j] / np.linalg.norm(left[j])
            scores[j] = ((left @ direction) ** 2).sum()
        best = max(scores, key=scores.get)
        chosen.append(best)
        direction = left[best] / np.linalg.norm(left[best])
        left = left - np.outer(left @ direction, direction)
    assert motions.order == tuple(chosen)


def test_more_numbers_bring_smaller_errors_and_all_motions_none():
    motions = punches()
    found = curves(motions)
    assert set(found.points) == set(METHODS) and found.frames == len(motions.values)
    for method, points in found.points.items():
        numbers, cm = [p.numbers for p in points], [p.cm for p in points]
        assert numbers == sorted(numbers)
        left = [squared(motions, method, p.step) for p in points]
        assert all(b <= a * 1.02 + 1 for a, b in pairwise(left)), method
        assert cm[-1] < 0.5 < 1 < cm[0]
        assert all(p.pose >= 0 for p in points)
    assert found.points[OWN][-1].cm < 0.05 and found.points[OWN][-1].pose < 0.1


def test_principal_motions_are_the_best_of_their_number():
    motions = punches()
    flat = motions.moved.reshape(motions.n, -1)
    for n in (2, 3, 4):
        kept = motions.order[:n]
        mixed = motions.weights(n) @ flat[list(kept)]
        mean, basis = motions.principal
        principal = mean + (flat - mean) @ basis[: n - 1].T @ basis[: n - 1]
        assert ((flat - principal) ** 2).sum() <= ((flat - mixed) ** 2).sum() * 1.001
    assert squared(motions, POSE_PCA, Step(components=8)) < squared(motions, POSE_PCA, Step(components=4))


def test_a_motion_that_is_a_blend_of_two_costs_two_numbers():
    space = blend_space(*motif_of(scattered("punch", range(2))))
    a, b = (space.blend({k: 1.0}).cut(0, 150) for k in range(2))
    channels = channels_of([a, b])
    both = [channels.encode(clip) for clip in (a, b)]
    mixtures = [w * both[0] + (1 - w) * both[1] for w in (1.0, 0.0, 0.7, 0.35, 0.5)]
    clips = [channels.decode(values, f"m{k}", a.fps) for k, values in enumerate(mixtures)]
    segments = tuple(Segment(clip.name, 0, 150) for clip in clips)
    even = np.arange(150, dtype=np.float32)
    space = blend_space(Dataset("d", tuple(clips)), Motif(0, segments, 0, (even,) * 5))
    motions = motions_of(space)
    values, numbers = rebuild(motions, OWN, Step(2))
    assert errors(motions.channels, values, motions.values)[0] < 1.0
    everything = rebuild(motions, OWN, Step(5))[1]
    assert numbers < 0.45 * everything


def test_rebuilt_clips_stand_beside_their_originals():
    motions = punches()
    pairs, off = list(rebuilt_clips(motions, OWN, Step(2))), motion_errors(motions, OWN, Step(2))
    assert [name for name, _, _ in pairs] == list(motions.names)
    for name, before, after in pairs:
        assert before.n_frames == after.n_frames and before.fps == 30
        way = np.linalg.norm(joint_positions(before) - joint_positions(after), axis=-1).mean()
        assert way < 0.3 and 100 * way == pytest.approx(off[name], rel=0.6, abs=0.05)
        if name in motions.order[:2]:
            assert way < 1e-3


@pytest.mark.parametrize(
    ("method", "step"),
    [("zip", Step(1)), (OWN, Step(0)), (OWN, Step(99)), (OWN, Step(2, 3)), (OWN_PCA, Step(2)), (MOTION_PCA, Step())],
)
def test_what_there_is_not_is_refused(method, step):
    with pytest.raises(ValueError, match="not stored"):
        rebuild(punches(), method, step)


@cache
def small() -> tuple[Dataset, MotifGraph]:
    """Three clips of two actions each; two motifs; two bodies in one of them."""
    parts = [scattered("punch", range(4)), scattered("jump", range(3)), scattered("jump", range(2), performer=1)]
    clips = tuple(replace(c, name=f"{i}{k}") for i, group in enumerate(parts) for k, c in enumerate(group))
    dataset = Dataset("small", clips)

    def motif(number: int, chosen: list[Clip]) -> Motif:
        segments = tuple(Segment(c.name, 10, c.n_frames - 20) for c in chosen)
        n = segments[0].n_frames
        return Motif(number, segments, 0, tuple(np.linspace(0, s.n_frames - 1, n).astype(np.float32) for s in segments))

    return dataset, MotifGraph((motif(0, list(clips[:4])), motif(1, list(clips[4:]))), (), {}, {})


def test_a_data_set_by_its_motifs():
    dataset, graph = small()
    found = compress_dataset(dataset, graph)
    kinds = [unit.kind for unit in found.units]
    assert kinds.count(MOTIF) == 3 and len(found.motif(0)) == 1 and len(found.motif(1)) == 2
    assert kinds.count(CLIP) == len(dataset.clips) and kinds.count(REST) == kinds.count(ALL) == 2
    frames = {kind: sum(u.curves.frames for u in found.units if u.kind == kind) for kind in kinds}
    assert frames[ALL] == frames[CLIP] == pytest.approx(dataset.seconds * 30, abs=len(dataset.clips))
    assert frames[MOTIF] + frames[REST] == pytest.approx(frames[ALL], abs=3 * len(dataset.clips))
    for way in WAYS:
        totals = found.totals(way, (0.2, 0.5, 1.0, 2.0, 1000.0))
        assert all(total.cm <= total.tolerance for total in totals)
        assert [t.numbers for t in totals] == sorted((t.numbers for t in totals), reverse=True)
        assert all(0 < t.numbers <= 1.05 * t.raw for t in totals)
    best, own = (found.totals(way) for way in ("best", "own"))
    assert all(a.numbers <= b.numbers for a, b in zip(best, own, strict=True))
    assert from_json(json.loads(json.dumps(found.to_json()))) == found
    with pytest.raises(ValueError, match="one of these ways"):
        found.totals("zip")


@pytest.mark.parametrize("document", [{}, {"format": "motionscape/motifs/1"}, None, {"format": FORMAT}])
def test_other_documents_are_refused(document):
    with pytest.raises(ValueError, match="compression"):
        from_json(document)


@pytest.mark.parametrize("stage", ["motifs", "frames in no motif", "clips"])
def test_it_can_be_stopped(stage):
    def stop(now, fraction):
        assert 0 <= fraction <= 1
        if now == stage:
            raise Cancelled

    with pytest.raises(Cancelled):
        compress_dataset(*small(), report=stop)
