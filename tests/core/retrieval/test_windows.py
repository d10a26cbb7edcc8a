"""The coarse look for stretches: its scores against the distance written out, and whom it finds."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from core.demo import make_demo
from core.poses.body_parts import LEAVES
from core.progress import silent
from core.retrieval import windows
from core.retrieval.compose import compose
from core.retrieval.descriptors import BLOCKS, N_COLUMNS
from core.retrieval.frames import UNITS, FrameStore
from core.retrieval.metric import FASTEST, SMALL, Metric
from core.retrieval.queries import whole_query

EQUAL = dict.fromkeys(LEAVES, 1 / len(LEAVES))


def written_out(store, metric, keys, start, window, stride):
    """Distance of one window, frame by frame, as the module's docstring has it."""
    way = metric.way
    frames = store.codes[start : start + window : stride][:, metric.columns] * (UNITS[metric.columns] * metric.factors)
    fastest = FASTEST * metric.factors[way:]
    frames[:, way:] = np.clip(frames[:, way:], -fastest, fastest)
    mean = frames[:, :way].mean(0)
    changed = ((frames[:, :way] - mean) ** 2).sum(1).mean()
    size = np.sqrt(changed + SMALL**2)
    at = [min(int(t * (window - 1) / stride + 0.5), len(frames) - 1) for t in keys.times]
    seen = (frames[at, :way] - metric.centre * mean) / size
    left = ((1 - metric.centre) * mean / size) ** 2
    squares = (
        changed / size**2 + left.sum() + (keys.postures**2).sum(1).mean() - 2 * (seen * keys.postures).sum(1).mean()
    )
    return squares + ((frames[at, way:] - keys.root) ** 2).sum(1).mean()


def test_scores_are_distances_of_centred_postures_divided_by_their_size():
    demo = make_demo(minutes=0.5)
    store, metric = FrameStore.build(demo.clips, 30.0, silent), Metric(EQUAL)
    keys = windows._keys(compose(store, whole_query(demo.clips[0], 60, 180), EQUAL), metric)
    stride, window = 4, 61
    frames = np.diff(store.starts)
    offsets = np.concatenate([[0], np.cumsum(-(-frames // stride))])
    score, length = windows._scored(
        store.codes, store.starts[:-1], frames, offsets, metric.columns,
        (UNITS[metric.columns] * metric.factors).astype(np.float32), metric.centre,
        (FASTEST * metric.factors[metric.way :]).astype(np.float32), keys.postures, keys.mean, keys.root, keys.times,
        np.array([window]), stride, np.float32(SMALL),
    )  # fmt: skip
    judged = np.flatnonzero(length == window)
    assert len(judged) > 100
    for place in judged[::9]:
        clip = int(np.searchsorted(offsets, place, side="right")) - 1
        start = int(store.starts[clip] + (place - offsets[clip]) * stride)
        wanted = written_out(store, metric, keys, start, window, stride)
        assert abs(score[place] - wanted) < 2e-3 * max(1, wanted)


@pytest.mark.parametrize("start", (40, 300))
def test_a_smaller_movement_in_another_posture_is_found(start):
    """Somebody who stoops and moves half as much: far from the query posture by posture, near in how it changes."""
    demo = make_demo(minutes=1)
    store, metric = FrameStore.build(demo.clips, 30.0, silent), Metric(EQUAL)
    clip = demo.clips[0]
    query = compose(store, whole_query(clip, start, start + 120), EQUAL)
    mean = query.codes.mean(0)
    stoop = np.random.default_rng(0).integers(-30, 31, query.codes.shape[1])
    stoop[N_COLUMNS:] = 0
    for side in ("left_arm", "right_arm"):
        stoop[BLOCKS[side]] = 0
    small = np.where(np.arange(len(mean)) < N_COLUMNS, 0.5, 1.0)
    codes = np.clip(np.rint(mean + stoop + small * (query.codes - mean)), -127, 127).astype(np.int8)
    found = windows.find_windows(store, replace(query, codes=codes), metric, np.arange(len(store.clips)), 1)
    first, last = int(found.start[0] - store.starts[0]) * 2, int(found.end[0] - store.starts[0]) * 2
    assert found.clip[0] == store.index(clip.name)
    assert min(last, start + 120) - max(first, start) > 60
