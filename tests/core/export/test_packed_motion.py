"""Packed motion comes back as it was, to within the error that it states."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from core.demo import make_demo
from core.export import packed_motion
from core.export.packed_motion import MILLIMETRE, pack_motion, unpack
from core.mocap.clip import Segment
from core.mocap.posture_drawing import drawn_positions
from tests.webapp.generated import walkers


@pytest.fixture(scope="module")
def dataset():
    return walkers(("a", "b"))


def recorded(dataset, packed):
    return [drawn_positions(dataset.clip(p.segment.clip), p.segment.start, p.segment.end)[0] for p in packed.pieces]


def joints(dataset, packed):
    return [positions.shape[1] for positions in recorded(dataset, packed)]


def test_what_comes_back_is_as_near_as_it_says(dataset):
    whole = [Segment(clip.name, 0, clip.n_frames) for clip in dataset.clips]
    packed = pack_motion(dataset, whole, 10_000_000)
    assert {piece.step for piece in packed.pieces} == {1} and packed.left_out == ()
    back = unpack(packed, joints(dataset, packed))
    largest = max(np.linalg.norm(a - b, axis=-1).max() for a, b in zip(back, recorded(dataset, packed), strict=True))
    assert largest == pytest.approx(packed.error, rel=1e-3)
    assert 0 < packed.error <= np.sqrt(3) * MILLIMETRE / 2 * 1.01
    assert len(packed.data) < sum(one.size * 2 for one in back)


def test_where_there_is_little_room_frames_and_then_segments_are_left_out():
    demo = make_demo(minutes=0.5)
    cuts = [Segment(clip.name, 300 * k, 300 * k + 200) for clip in demo.clips for k in range(clip.n_frames // 300)]
    most = len(pack_motion(demo, cuts, 10_000_000).data)
    thinner = pack_motion(demo, cuts, int(0.8 * most))
    assert {piece.step for piece in thinner.pieces} == {2} and thinner.left_out == ()
    assert thinner.between > 5 * thinner.error
    few = pack_motion(demo, cuts, most // 5)
    assert len(few.data) <= most // 5 and 0 < len(few.left_out) < len(cuts)
    assert few.left_out == tuple(cuts[-len(few.left_out) :])


def test_stretches_that_touch_are_packed_once(dataset):
    name = dataset.names[0]
    packed = pack_motion(dataset, [Segment(name, 0, 20), Segment(name, 10, 40), Segment(name, 41, 50)], 10_000_000)
    assert [piece.segment for piece in packed.pieces] == [Segment(name, 0, 50)]


def test_a_clip_that_goes_far_has_a_larger_unit_and_says_so(dataset):
    clip = dataset.clips[0]
    far = clip.root_positions + np.linspace(0, 300, clip.n_frames)[:, None].astype(np.float32) * [1, 0, 0]
    moved = replace(dataset, clips=(replace(clip, root_positions=far.astype(np.float32)),), labels=(), digests=())
    packed = pack_motion(moved, [Segment(clip.name, 0, clip.n_frames)], 10_000_000)
    assert packed.pieces[0].unit > MILLIMETRE
    back = unpack(packed, joints(moved, packed))[0]
    assert np.linalg.norm(back - recorded(moved, packed)[0], axis=-1).max() == pytest.approx(packed.error, rel=1e-3)


def test_nothing_wanted_is_nothing_packed(dataset):
    packed = pack_motion(dataset, [], 1000)
    assert packed.pieces == () and unpack(packed, []) == []


def test_a_guess_of_what_fits_is_no_more_than_there_is(dataset, monkeypatch):
    monkeypatch.setattr(packed_motion, "_MOST_FRAMES", 10)
    whole = [Segment(clip.name, 0, clip.n_frames) for clip in dataset.clips]
    assert pack_motion(dataset, whole, 10_000_000).left_out == tuple(whole)
