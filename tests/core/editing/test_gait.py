"""Gait events, against walkers whose steps are known, and on recordings of people who walk, run and do neither."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from core.editing.gait import NO_FEET, NO_GAIT, Gait, find_gait
from core.editing.legs import place_ankles
from core.editing.mirror import mirror
from core.mocap.asfamc import read_amc, read_asf
from core.mocap.bvh import read_bvh
from core.mocap.clip import Clip
from core.mocap.kinematics import joint_positions
from core.mocap.skeleton import Skeleton
from tests.core.editing.figures import action, going, standing

FPS = 120.0
SIDES = ("left", "right")


def walker(
    n: int = 720,
    stride: float = 1.2,
    seconds: float = 1.1,
    stance: float = 0.6,
    direction: float = 0.0,
    lead: float = 0.5,
) -> tuple[Clip, dict[str, np.ndarray]]:
    """A body gliding along (``direction`` radians from where it faces), and the frames of its strikes and toe-offs.

    Every foot stands still for the share ``stance`` of a stride, then flies on at an even speed, lifted by 15 cm; the
    right comes ``lead`` strides after the left.
    """
    clip = standing(n, FPS)
    way = np.array([np.sin(direction), 0, np.cos(direction)])
    speed, t = stride / seconds, np.arange(n) / FPS
    feet = joint_positions(clip)[:, [clip.skeleton.index("LeftFoot"), clip.skeleton.index("RightFoot")]].astype(float)
    truth = {}
    for side in (0, 1):
        phase = t / seconds + 0.2 - lead * side
        cycle, within = np.floor(phase), phase % 1
        swing = np.clip((within - stance) / (1 - stance), 0, 1)
        # in the middle of its stance the foot is below the body
        along = stride * (cycle + swing + stance / 2 + lead * side - 0.2)
        feet[:, side] += along[:, None] * way
        feet[:, side, 1] += 0.15 * np.sin(np.pi * swing)
        inside = np.flatnonzero(np.diff(cycle) > 0) + 1
        truth[f"{SIDES[side]} strike"] = inside
        truth[f"{SIDES[side]} off"] = np.flatnonzero(np.diff((within >= stance).astype(int)) > 0) + 1
    clip = replace(clip, root_positions=(clip.root_positions + np.outer(speed * t, way)).astype(np.float32))
    return place_ankles(clip, feet), truth


def frames(gait: Gait, side: str, kind: str) -> np.ndarray:
    return np.array([e.frame for e in gait.events if (e.side, e.kind) == (side, kind)])


def measure(gait: Gait, name: str, bout: int = 0):
    return next(m for m in gait.bouts[bout].measures if m.name == name)


@pytest.mark.parametrize(("stance", "seconds", "kind"), [(0.62, 1.1, "walk"), (0.36, 0.72, "run")])
def test_strikes_and_toe_offs_of_a_known_walker(stance, seconds, kind):
    clip, truth = walker(stance=stance, seconds=seconds, stride=1.2)
    gait = find_gait(clip)
    assert len(gait.bouts) == 1 and gait.bouts[0].kind == kind and not gait.bouts[0].backward and not gait.why
    for side in SIDES:
        for what in ("strike", "off"):
            found, known = frames(gait, side, what), truth[f"{side} {what}"]
            known = known[(known >= frames(gait, side, "strike")[0] - 3) & (known <= found.max() + 3)]
            assert len(found) == len(known)
            assert np.abs(found - known).max() <= 3  # 25 ms
    assert measure(gait, "Cadence").mean == pytest.approx(120 / seconds, rel=0.01)
    assert measure(gait, "Speed").mean == pytest.approx(1.2 / seconds, rel=0.01)
    assert measure(gait, "Stride length").mean == pytest.approx(1.2, abs=0.01)
    assert measure(gait, "Step length").mean == pytest.approx(0.6, abs=0.02)
    assert measure(gait, "Stance").mean == pytest.approx(100 * stance, abs=3)
    assert abs(measure(gait, "Stance").asymmetry) < 2


def test_a_limp_shows_on_its_side_and_changes_sides_in_the_mirror():
    clip, _ = walker(lead=0.42)
    gait, other = find_gait(clip), find_gait(mirror(clip))
    times = measure(gait, "Step time")
    assert times.right == pytest.approx(0.42 * 1.1, abs=0.01) and times.left == pytest.approx(0.58 * 1.1, abs=0.01)
    assert times.asymmetry == pytest.approx(100 * (0.42 - 0.58) / 0.5, abs=3)
    assert measure(other, "Step time").asymmetry == pytest.approx(-times.asymmetry, abs=1)
    assert measure(gait, "Stride time").asymmetry == pytest.approx(0, abs=1)


def test_backward_is_gait_sideways_and_on_the_spot_are_not():
    assert find_gait(walker(direction=np.pi)[0]).bouts[0].backward
    assert find_gait(walker(direction=np.pi / 2)[0]).why == NO_GAIT
    assert find_gait(walker(stride=0.02)[0]).why == NO_GAIT
    assert find_gait(standing(200)).why == NO_GAIT
    assert find_gait(action("punch")).bouts == ()


def test_both_feet_at_once_is_hopping():
    assert find_gait(walker(lead=1.0, stance=0.5)[0]).why == NO_GAIT


def test_walking_that_turns_into_running_makes_two_bouts():
    gait = find_gait(going(("walk", 4.0), ("run", 3.0), seed=1))
    assert [bout.kind for bout in gait.bouts] == ["walk", "run"]
    assert 60 * 3.3 < gait.bouts[1].start < 60 * 4.7
    assert 58 < measure(gait, "Stance").mean < 70
    assert measure(gait, "Stance", 1).mean < 48
    assert len({(e.frame, e.side, e.kind) for e in gait.events}) == len(gait.events)


def test_a_body_without_legs_says_so():
    chain = Skeleton(("a", "b", "c"), (-1, 0, 1), np.array([[0, 0, 0], [0, 1, 0], [0, 1, 0]]))
    still = np.tile(np.array([1, 0, 0, 0], np.float32), (9, 3, 1))
    assert find_gait(Clip("chain", chain, 30, np.zeros((9, 3), np.float32), still)).why == NO_FEET


def test_a_recorded_walk_and_run_are_as_in_textbooks(shared_data):
    """CMU 02_02 and 02_03. A walk's stance is 58 to 66 % of a stride, a run's below 45 % (Winter 1991)."""
    folder = shared_data / "cmu/asfamc/02"
    asf = read_asf(folder / "02.asf")
    walk, run = (find_gait(read_amc(folder / f"{name}.amc", asf)) for name in ("02_02", "02_03"))
    assert [b.kind for b in walk.bouts] == ["walk"] and [b.kind for b in run.bouts] == ["run"]
    assert 58 < measure(walk, "Stance").mean < 66 and 25 < measure(run, "Stance").mean < 45
    assert 110 < measure(walk, "Cadence").mean < 130 and 140 < measure(run, "Cadence").mean < 180
    assert 15 < measure(walk, "Both feet down").mean < 30 and measure(run, "Both feet off").mean > 15


def test_gait_is_found_in_walks_and_runs_and_nowhere_else(shared_data):
    """Bandai-Namco: one clip of each content and three styles."""
    wrong = []
    for style in ("normal", "old", "active"):
        for path in sorted((shared_data / "bandai_namco_1").rglob(f"*_{style}_001.bvh")):
            clip, content = read_bvh(path), path.stem.split("_")[1]
            if content.startswith("dance") or clip.n_frames < 60:
                continue
            goes = content.split("-")[0] in ("walk", "run", "dash")
            gait = find_gait(clip)
            if bool(gait.bouts) != goes or any(b.backward != (content == "walk-back") for b in gait.bouts):
                wrong.append(path.stem)
    assert not wrong
