"""Stitched motion: copies where nothing is blended, no jump where something is, feet that stay, one body."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest

from core.editing.blending import ground_fit
from core.editing.contacts import foot_contacts, slide
from core.mocap.clip import Segment
from core.mocap.dataset import Dataset
from core.mocap.kinematics import joint_positions
from core.synthesis.stitching import joint_speeds, overlaps_between, seam_speed, stitch
from core.synthesis.timeline import Overlap
from tests.core.editing.figures import moved, standing
from tests.core.synthesis.recordings import demo, other_joints


def same_up_to_place(a: np.ndarray, b: np.ndarray, tolerance: float = 2e-4) -> bool:
    """Whether joint positions ``(n, n_joints, 3)`` differ by one turn and shift on the ground, and their floor."""
    flat = [p.reshape(1, -1, 3) - [0, p[..., 1].min(), 0] for p in (a, b)]
    return float(ground_fit(*flat)[2][0]) < tolerance


def test_pieces_that_go_on_in_one_another_are_the_clip_itself() -> None:
    dataset, _ = demo()
    clip = dataset.clips[0]
    made = stitch(dataset, [Segment(clip.name, 50, 120), Segment(clip.name, 120, 200)], keep_feet=False)
    assert made.clip.n_frames == 150 and len(made.timeline.seams) == 0 and made.speeds.seams == 0
    assert same_up_to_place(joint_positions(made.clip), joint_positions(clip)[50:200])
    assert np.allclose(made.clip.root_positions[0, [0, 2]], 0)


def test_a_motion_blended_with_itself_stays_itself() -> None:
    dataset, _ = demo()
    clip = dataset.clips[1]
    rows = np.column_stack([np.arange(100.0, 160), np.arange(100.0, 160)])
    made = stitch(
        dataset, [Segment(clip.name, 40, 161), Segment(clip.name, 100, 220)], [Overlap(rows)], keep_feet=False
    )
    assert same_up_to_place(joint_positions(made.clip), joint_positions(clip)[40:220], 2e-3)


@pytest.mark.parametrize("keep_feet", [True, False])
def test_any_pieces_can_be_stitched_without_a_jump(keep_feet: bool) -> None:
    dataset, graph = demo()
    rng = np.random.default_rng(4)
    segments = [s for motif in graph.motifs for s in motif.segments]
    pieces = [segments[k] for k in rng.permutation(len(segments))[:9]]
    made = stitch(dataset, pieces, keep_feet=keep_feet)
    assert not made.speeds.jump
    breaks = sum((a.clip, a.end) != (b.clip, b.start) for a, b in pairwise(pieces))
    bounds = np.concatenate([[0], made.timeline.seams.ravel(), [made.clip.n_frames]])
    assert (np.diff(bounds) >= 0).all() and len(made.timeline.seams) == breaks
    assert np.allclose(np.linalg.norm(made.clip.rotations, axis=-1), 1, atol=1e-4)
    assert np.isfinite(made.clip.root_positions).all()
    if keep_feet:
        assert made.skate.kept < 0.5 * made.skate.plain
    else:
        assert made.skate.kept == made.skate.plain


def test_a_bare_cut_would_be_seen_as_a_jump() -> None:
    """The measure itself: pieces set one behind the other without a blend are faster there than any recording."""
    dataset, graph = demo()
    clips = [
        dataset.clip(s.clip).cut(s.start, s.end) for s in (graph.motifs[0].segments[0], graph.motifs[5].segments[0])
    ]
    root = np.concatenate([c.root_positions - c.root_positions[0] for c in clips])
    cut = replace(
        clips[0], root_positions=root + np.array([0, 1, 0]), rotations=np.concatenate([c.rotations for c in clips])
    )
    at = clips[0].n_frames
    assert seam_speed(cut, [(at, at)]) > 2 * max(joint_speeds(c).max() for c in clips)


def test_feet_that_stand_in_two_places_step_over() -> None:
    a = standing(120)
    wide = moved(standing(120), np.zeros(3))
    rotations = wide.rotations.copy()
    joint = wide.skeleton.index("RightUpLeg")  # the right foot stands further out
    rotations[:, joint] = rotations[:, joint] + np.float32([0, 0, 0, 0.08])
    wide = replace(wide, name="wide", rotations=rotations / np.linalg.norm(rotations, axis=-1, keepdims=True))
    dataset = Dataset("two", (a, wide))
    made = stitch(dataset, [Segment("standing", 0, 100), Segment("wide", 20, 120)])
    start, end = made.timeline.seams[0]
    foot = joint_positions(made.clip)[:, made.clip.skeleton.index("RightFoot")]
    assert np.linalg.norm((foot[-1] - foot[0])[[0, 2]]) > 0.08
    assert (foot[start:end, 1] - foot[0, 1]).max() > 0.01 and not made.contacts[start:end].all()
    assert made.contacts[: start - 5].all() and made.contacts[end + 5 :].all()
    assert made.skate.kept < 0.3 * made.skate.plain


def test_the_meter_measures_the_same_contacts_in_plain_and_kept_motion() -> None:
    dataset, graph = demo()
    pieces = [graph.motifs[k].segments[0] for k in (0, 1, 2)]
    plain, kept = (stitch(dataset, pieces, keep_feet=feet) for feet in (False, True))
    assert plain.skate.plain == kept.skate.plain and plain.skate.source == kept.skate.source
    metres, seconds = slide(plain.clip, plain.contacts, 0.0)
    assert plain.skate.plain == pytest.approx(metres / seconds)
    for made in (plain, kept):  # contacts found anew in the result tell the same story
        metres, seconds = slide(made.clip, foot_contacts(made.clip, 0.0), 0.0)
        assert abs(metres / seconds - made.skate.kept) < 0.035


def test_bodies_of_different_size_become_one() -> None:
    dataset, _ = demo()
    names = [next(c.name for c in dataset.clips if c.name.startswith(who)) for who in ("ana", "ben")]
    made = stitch(dataset, [Segment(names[0], 0, 300), Segment(names[1], 0, 100)])
    assert made.clip.skeleton == dataset.clip(names[0]).skeleton
    assert made.warnings == ("Motions of 2 bodies of different size were fitted to one of them.",)
    feet = joint_positions(made.clip)[..., 1].min(1)
    assert abs(np.median(feet[250:])) < 0.03  # on the floor, whosever legs they were


def test_what_cannot_be_stitched_is_refused_in_words() -> None:
    dataset, _ = demo()
    name = dataset.clips[0].name
    with pytest.raises(ValueError, match="nothing to stitch"):
        stitch(dataset, [])
    with pytest.raises(ValueError, match="cannot cut"):
        stitch(dataset, [Segment(name, 0, 10**6)])
    with pytest.raises(KeyError, match="nobody"):
        stitch(dataset, [Segment("nobody", 0, 10)])
    stranger = replace(other_joints(dataset.clips[1]), name="stranger")
    mixed = Dataset("mixed", (*dataset.clips, stranger))
    with pytest.raises(ValueError, match="skeletons with different joints"):
        stitch(mixed, [Segment(name, 0, 50), Segment("stranger", 0, 50)])


def test_crossfades_fit_between_short_pieces() -> None:
    dataset, _ = demo()
    name = dataset.clips[0].name
    pieces = [Segment(name, 100 * k, 100 * k + 12) for k in range(5)]  # a fifth of a second each
    overlaps = overlaps_between(dataset, pieces)
    for before, after in pairwise(overlaps):
        assert before.rows[-1, 1] <= after.rows[0, 0]
    assert stitch(dataset, pieces).clip.n_frames > 0
