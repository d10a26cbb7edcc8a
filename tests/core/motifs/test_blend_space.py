"""Blend spaces: a weight of 1 gives a motion back, means against an eigenvector oracle, paths, times, feet, speed."""

from __future__ import annotations

import time
from collections.abc import Sequence
from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from core.demo.actions import perform
from core.demo.gaits import gait
from core.demo.performers import PERFORMERS
from core.editing.blending import ground_fit, place
from core.editing.contacts import foot_skate
from core.mocap import quaternions as quat
from core.mocap.clip import Clip, Segment
from core.mocap.dataset import Dataset
from core.mocap.kinematics import joint_positions
from core.motifs.blend_space import BlendSpace, blend_space, blendable, mean_rotations, steady_warp
from core.motifs.graph import Motif
from core.sequences.warping import registration, warp_path
from tests.webapp.generated import walk


def motif_of(clips: Sequence[Clip], medoid: int = 0) -> tuple[Dataset, Motif]:
    """Whole clips as the motions of one motif, registered by their postures."""
    dataset = Dataset("clips", tuple(replace(clip, name=f"c{k}") for k, clip in enumerate(clips)))
    flat = [np.asarray(c.rotations, np.float32)[:, 1:].reshape(c.n_frames, -1) for c in dataset.clips]
    warps = [registration(warp_path(flat[medoid], f), len(flat[medoid])).astype(np.float32) for f in flat]
    segments = tuple(Segment(c.name, 0, c.n_frames) for c in dataset.clips)
    return dataset, Motif(0, segments, medoid, tuple(warps))


@cache
def scattered(name: str, seeds: range, performer: int = 0) -> tuple[Clip, ...]:
    clips = [perform(name, PERFORMERS[performer], np.random.default_rng(seed)) for seed in seeds]
    return tuple(place(clip, 0.9 * k, np.array([2.0 * k, 0, -k])) for k, clip in enumerate(clips))


def kicks(n: int = 4, performer: int = 0) -> tuple[Clip, ...]:
    """Kicks; the demo makes some with the left leg and some with the right."""
    return scattered("kick", range(n), performer)


def strolls(n: int) -> tuple[Clip, ...]:
    """Two seconds of walking from one phase on, each turning more than the last, and a little faster."""
    performers = [replace(PERFORMERS[0], tempo=1 + 0.03 * k) for k in range(n)]
    rng, turns = np.random.default_rng, np.linspace(-0.8, 0.8, n)
    return tuple(gait([("walk", 2.0)], t, p, rng(0))[0] for t, p in zip(turns, performers, strict=True))


@pytest.fixture(scope="module")
def space() -> BlendSpace:
    return blend_space(*motif_of(kicks(), medoid=1))


def apart(a: Clip, b: Clip) -> float:
    """Greatest distance of a joint, metres, once ``b`` is laid upon ``a`` on the ground as a whole."""
    pa, pb = joint_positions(a), joint_positions(b)
    yaw, shift, _ = ground_fit(pa.reshape(-1, 3), pb.reshape(-1, 3))
    return float(np.linalg.norm(joint_positions(place(b, yaw, shift)) - pa, axis=-1).max())


def test_a_weight_of_one_gives_the_motion_back(space):
    for k, clip in enumerate(kicks()):
        back = space.blend({k: 1.0})
        assert back.n_frames == clip.n_frames and back.fps == clip.fps
        assert apart(clip, back) < 1e-4
        nearly = space.blend({k: 1.0, (k + 1) % 4: 1e-4})
        assert apart(clip, nearly) < 5e-3  # and nothing jumps on the way there


def test_weights_are_shares(space):
    a, b = space.blend({0: 1, 2: 3}), space.blend({0: 0.25, 2: 0.75, 3: 0})
    assert np.array_equal(a.rotations, b.rotations) and np.array_equal(a.root_positions, b.root_positions)


def test_duration_is_the_weighted_mean(space):
    frames = [c.n_frames - 1 for c in kicks()]
    for weights in ({0: 1, 1: 1}, {0: 1, 1: 2, 2: 3, 3: 4}):
        w = np.array(list(weights.values())) / sum(weights.values())
        assert space.blend(weights).n_frames == pytest.approx(w @ [frames[k] for k in weights] + 1, abs=0.51)


@pytest.mark.parametrize("name", ["kick", "jump"])
def test_blends_do_not_jump_even_between_opposite_motions(name):
    clips = scattered(name, range(5))
    mixed = blend_space(*motif_of(clips)).blend(dict.fromkeys(range(5), 1.0))

    def hardest(clip: Clip) -> float:
        """Metres a second squared."""
        return np.linalg.norm(np.diff(joint_positions(clip), 2, axis=0), axis=-1).max() * clip.fps**2

    assert hardest(mixed) < 1.5 * max(hardest(clip) for clip in clips)
    assert np.allclose(np.linalg.norm(mixed.rotations, axis=-1), 1, atol=1e-5)
    assert ((mixed.rotations[1:] * mixed.rotations[:-1]).sum(-1) > 0).all()


def test_the_way_from_one_motion_to_another_is_continuous(space):
    shares = np.linspace(0, 1, 17)
    ends = []
    for s in shares:
        clip = space.blend({0: 1 - s, 2: s})
        p = joint_positions(clip)
        ends.append(p[[0, clip.n_frames // 2, -1]])
    steps = np.linalg.norm(np.diff(ends, axis=0), axis=-1).max((1, 2))
    assert steps.max() < 6 * np.median(steps) + 0.02


def test_left_and_right_turn_make_a_straight_walk_at_full_speed():
    def turning(rate: float) -> Clip:
        clip = walk(seconds=3.0, pace=1.0)
        yaw = rate * np.arange(clip.n_frames) / clip.fps
        step = np.stack([np.sin(yaw), np.zeros_like(yaw), np.cos(yaw)], -1) * 1.2 / clip.fps
        root = np.cumsum(step, axis=0)
        root[:, 1] = clip.root_positions[:, 1]
        rotations = clip.rotations.copy()
        rotations[:, 0] = quat.from_yaw(yaw)
        return replace(clip, root_positions=root.astype(np.float32), rotations=rotations)

    space = blend_space(*motif_of([turning(0.6), turning(-0.6), turning(0.0)]))
    mixed = space.blend({0: 0.5, 1: 0.5})
    way = mixed.root_positions[:, [0, 2]]
    length = np.linalg.norm(np.diff(way, axis=0), axis=1).sum()
    assert length == pytest.approx(1.2 * 3, rel=0.03)
    assert np.linalg.norm(way[-1] - way[0]) > 0.98 * length  # straight
    assert apart(mixed, space.blend({2: 1.0})) < 0.06


def test_standing_feet_stand():
    space = blend_space(*motif_of(strolls(4)))
    even = dict.fromkeys(space.motions, 1.0)
    assert foot_skate(space.blend(even)) < 0.6 * foot_skate(space.blend(even, clean=False))


@settings(max_examples=40)
@given(seed=st.integers(0, 10**6), k=st.integers(1, 8), spread=st.floats(0, 0.6))
def test_the_mean_rotation_has_the_least_squared_arcs(seed, k, spread):
    rng = np.random.default_rng(seed)
    q = quat.multiply(quat.normalise(rng.normal(size=4)), quat.from_rotvec(rng.normal(0, spread, (k, 5, 3))))
    q = np.where((q * q[:1]).sum(-1, keepdims=True) < 0, -q, q)
    w = rng.dirichlet(np.ones(k))
    mean = mean_rotations(w, q)
    assert np.allclose(np.linalg.norm(mean, axis=-1), 1, atol=1e-9)

    def cost(m):
        return (w[:, None] * np.arccos(np.clip((q * m).sum(-1), -1, 1)) ** 2).sum(0)

    for _ in range(20):
        moved = quat.multiply(mean, quat.from_rotvec(rng.normal(0, 0.02, (5, 3))))
        assert (cost(mean) <= cost(moved) + 1e-9).all()


def test_the_mean_of_two_is_the_great_arc_between_them():
    a, b = quat.from_rotvec(np.array([[0.2, 0.1, 0.5]])), quat.from_rotvec(np.array([[-0.3, 0.9, 0.0]]))
    for t in (0.0, 0.2, 0.5, 1.0):
        assert np.allclose(mean_rotations(np.array([1 - t, t]), np.stack([a, b])), quat.slerp(a, b, t), atol=1e-7)


@settings(max_examples=60)
@given(seed=st.integers(0, 10**6), n=st.integers(1, 200), frames=st.integers(2, 300))
def test_steady_warps_rise_from_first_to_last(seed, n, frames):
    rng = np.random.default_rng(seed)
    stairs = np.sort(rng.choice(frames, n)).astype(float)
    warp = steady_warp(stairs, frames, 60.0)
    assert warp[0] == 0 and warp[-1] == frames - 1
    assert (np.diff(warp) > 0).all() and len(warp) == max(n, 2)


@pytest.mark.parametrize("lengths", [(1, 1, 1), (2, 1, 3), (1, 30, 2), (30, 30, 1)])
@pytest.mark.parametrize("medoid", [0, 1, 2])
def test_motions_of_a_frame_or_two(lengths, medoid):
    dataset, _ = motif_of(kicks(3))
    segments = tuple(Segment(f"c{k}", 40, 40 + n) for k, n in enumerate(lengths))
    warps = tuple(np.linspace(0, n - 1, lengths[medoid], dtype=np.float32) for n in lengths)
    space = blend_space(dataset, Motif(0, segments, medoid, warps))
    assert [space.blend({k: 1.0}).n_frames for k in range(3)] == list(lengths)
    mixed = space.blend(dict.fromkeys(range(3), 1.0))
    assert np.isfinite(mixed.rotations).all() and np.isfinite(mixed.root_positions).all()


def test_most_different_motions(space):
    chosen = space.most_different(3)
    assert chosen[0] == 1 and len(set(chosen)) == 3 and space.most_different(99) and len(space.most_different(99)) == 4
    copies = blend_space(*motif_of([kicks()[0], kicks()[1], kicks()[0], kicks()[1]]))
    assert set(copies.most_different(2)) == {0, 1}


def test_motions_of_several_bodies_are_kept_apart():
    clips = kicks(3) + kicks(2, performer=1)
    dataset, motif = motif_of(clips, medoid=4)
    assert blendable(dataset, motif) == ((0, 1, 2), (3, 4))
    assert blend_space(dataset, motif).motions == (0, 1, 2)
    small = blend_space(dataset, motif, 3)
    assert small.motions == (3, 4) and small.reference == 4
    with pytest.raises(ValueError, match="cannot be mixed"):
        small.blend({0: 0.5, 3: 0.5})
    with pytest.raises(ValueError, match="no motion 9"):
        blend_space(dataset, motif, 9)


@pytest.mark.parametrize("weights", [{}, {0: 0.0}, {0: -1.0, 1: 2.0}, {0: float("nan")}, {0: float("inf")}, {17: 1.0}])
def test_weights_that_make_no_sense_are_refused(space, weights):
    with pytest.raises(ValueError, match=r"weight|cannot be mixed"):
        space.blend(weights)


def test_rates_and_shifting_joints():
    a, b = kicks(2)
    slow = replace(b, fps=b.fps / 2, root_positions=b.root_positions[::2], rotations=b.rotations[::2])
    shift = np.linspace(0, 0.1, a.n_frames)[:, None] * np.float32([1, 0, 0]) + a.skeleton.offsets[3]
    space = blend_space(*motif_of([replace(a, translations={3: shift.astype(np.float32)}), slow]))
    assert space.blend({0: 1}).fps == a.fps and space.blend({1: 1}).fps == slow.fps
    assert space.blend({1: 1}).n_frames == slow.n_frames
    mixed = space.blend({0: 0.5, 1: 0.5})
    assert mixed.fps == a.fps
    assert mixed.seconds == pytest.approx((a.seconds + slow.seconds) / 2, abs=0.03)
    assert mixed.translations[3][-1, 0] == pytest.approx(a.skeleton.offsets[3, 0] + 0.05, abs=1e-3)
    assert np.allclose(space.blend({0: 1}).translations[3], shift, atol=1e-5)


def test_eight_motions_of_two_seconds_blend_while_one_drags():
    space = blend_space(*motif_of(strolls(8)))
    weights = dict.fromkeys(space.motions, 1.0)
    space.blend(weights)  # kernels compile
    taken = []
    for _ in range(7):
        started = time.process_time()
        space.blend(weights)
        taken.append(time.process_time() - started)
    assert min(taken) < 0.05
