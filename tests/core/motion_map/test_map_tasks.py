"""People find what they look for on the map: the benchmark's search tasks, once, on the demo."""

from __future__ import annotations

import numpy as np

from benchmarks.bench_map_search import TASKS, choice_rows, icon_keys, key_postures, run_tasks, share_of_time, successes
from core.demo import make_demo
from core.motion_map.build import MapParameters, build_motion_map
from core.poses.postures import postures_of


def test_actions_are_found_by_three_postures_of_another_instance():
    demo = make_demo(minutes=6)
    found = run_tasks(demo, TASKS["demo"], seeds=1, grid="30x30")
    assert successes(found)[0] >= 7
    right = np.mean([rows[0][3] for rows in found.values()])
    chance = np.mean([share_of_time(demo, action) for action in found])
    assert right > 5 * chance, "far more hits are right than would be by chance"


def test_keys_are_icons_and_one_posture_leaves_few_clips():
    demo = make_demo(minutes=2)
    motion_map = build_motion_map(demo, MapParameters(samples=800))
    keys = icon_keys(motion_map, key_postures(postures_of(demo), demo.labels[0]))
    assert 1 <= len(keys) <= 3 and all(list(key) in motion_map.icons.tolist() for key in keys)
    rows = choice_rows(demo)
    assert all(1 <= a <= b <= c <= len(demo.clips) for _, a, b, c in rows)
