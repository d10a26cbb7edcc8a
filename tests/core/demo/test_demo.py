"""The demo: grammatical, labelled, the same for the same seed, and moving like people."""

from __future__ import annotations

import itertools
from importlib.resources import files
from pathlib import Path

import numpy as np
import pytest

from core.demo import make_demo, write_demo
from core.demo.hidden_rules import ACTIONS, GRAMMAR, accepts, derive
from core.demo.motions import FPS, sources
from core.demo.performers import PERFORMERS, skeleton_of
from core.demo.routines import perform_sentence, routines
from core.editing.contacts import foot_contacts, foot_skate
from core.mocap.anatomy import find_anatomy
from core.mocap.bvh import read_bvh
from core.mocap.kinematics import joint_positions
from core.mocap.labels import read_labels

WIDE = ("idle", "walk", "run", "walk", "punch", "kick", "spin kick", "idle", "cartwheel", "idle", "backflip", "jump",
        "lie down", "crawl", "get up", "squat", "roll", "dance", "twirl", "idle")  # fmt: skip


@pytest.fixture(scope="module")
def demo():
    return make_demo(minutes=1.5, seed=0)


def perform(sentence=WIDE, performer=0, seed=0, plain=False):
    return perform_sentence(sentence, PERFORMERS[performer], np.random.default_rng(seed), "take", plain)


def speeds(clip) -> np.ndarray:
    """Of the fastest joint, (n_frames - 1,), metres a second."""
    return np.linalg.norm(np.diff(joint_positions(clip), axis=0), axis=-1).max(1) * clip.fps


def test_same_seed_same_demo_and_another_seed_another(demo) -> None:
    again, other = make_demo(minutes=1.5, seed=0), make_demo(minutes=1.5, seed=1)
    assert again.fingerprint == demo.fingerprint and again.labels == demo.labels
    assert other.fingerprint != demo.fingerprint and other.labels != demo.labels


def test_a_longer_demo_begins_like_a_shorter_one(demo) -> None:
    first, _ = next(routines(0.01, seed=0))
    assert np.array_equal(first.rotations, demo.clips[0].rotations)


def test_length_and_performers(demo) -> None:
    assert 90 <= demo.seconds < 180
    assert all(clip.fps == FPS for clip in demo.clips)
    assert len({clip.skeleton for clip in demo.clips}) == min(3, len(demo.clips))
    with pytest.raises(ValueError, match="positive"):
        make_demo(minutes=0)


def test_labels_cover_every_frame_once_and_spell_sentences_of_the_grammar(demo) -> None:
    for clip in demo.clips:
        labels = [label for label in demo.labels if label.clip == clip.name]
        assert labels[0].start == 0 and labels[-1].end == clip.n_frames
        assert all(a.end == b.start for a, b in itertools.pairwise(labels))
        assert min(label.end - label.start for label in labels) > 0.5 * clip.fps
        assert accepts([label.action for label in labels])


def test_grammar() -> None:
    rng = np.random.default_rng(0)
    sentences = [derive(rng) for _ in range(200)]
    assert all(accepts(s) for s in sentences)
    assert {action for s in sentences for action in s} == set(ACTIONS)
    assert all(symbol in GRAMMAR or symbol in ACTIONS for rules in GRAMMAR.values() for _, r in rules for symbol in r)
    for wrong in ((), ("idle",), ("idle", "crawl", "idle"), sentences[0][:-1], (*sentences[0], "kick")):
        assert not accepts(wrong)
    assert accepts(("punch", "kick"), "combination") and not accepts(("kick", "punch"), "combination")


def test_a_sentence_is_performed_action_by_action() -> None:
    clip, labels, seams = perform()
    assert tuple(label.action for label in labels) == WIDE
    assert len(seams) == len(WIDE) - 3  # walk, run and walk pass into one another without a seam
    assert all(0 <= a < b <= clip.n_frames for a, b in seams)


@pytest.mark.parametrize("performer", range(3))
def test_moves_are_sound(performer: int) -> None:
    clip, _, seams = perform(performer=performer, seed=performer)
    plain, _, _ = perform(performer=performer, seed=performer, plain=True)
    assert np.abs(np.linalg.norm(clip.rotations, axis=-1) - 1).max() < 1e-5
    positions = joint_positions(clip)
    parents = np.array(clip.skeleton.parents[1:])
    bones = np.linalg.norm(positions[:, 1:] - positions[:, parents], axis=-1)
    assert np.abs(bones - np.linalg.norm(clip.skeleton.offsets[1:], axis=1)).max() < 1e-4
    assert positions[..., 1].min() > -0.01
    inside = np.zeros(clip.n_frames - 1, bool)
    for start, end in seams:
        inside[start:end] = True
    speed = speeds(clip)
    assert speed[inside].max() < 9 < speed[~inside].max() and np.percentile(speed[inside], 95) < 6
    # feet: judged at the same contacts rule, locked against plain cross-fades
    assert foot_skate(clip, floor=0.0) < min(0.5 * foot_skate(plain, floor=0.0), 0.08)
    assert foot_contacts(clip, 0.0).mean() > 0.4


def test_no_two_performances_are_alike() -> None:
    a, b = (perform(("idle", "punch", "idle"), seed=k)[0] for k in (1, 2))
    assert a.n_frames != b.n_frames or np.abs(a.rotations - b.rotations).max() > 0.1


def test_idling_feet_stay() -> None:
    clip, _, _ = perform(("idle", "idle"))
    feet = [clip.skeleton.index(f"{side}Foot") for side in ("Left", "Right")]
    positions = joint_positions(clip)[:60, feet]
    assert np.ptp(positions, axis=0).max() < 0.005
    assert np.ptp(joint_positions(clip)[:60, clip.skeleton.index("Head")], axis=0).max() > 0.005


def test_performers_are_recognised_and_differ() -> None:
    heights = [find_anatomy(skeleton_of(p)).body_height for p in PERFORMERS]
    assert np.ptp(heights) > 0.1 and 1.5 < min(heights) < max(heights) < 2.0
    anatomy = find_anatomy(skeleton_of(PERFORMERS[1]))
    assert anatomy.by_name and len(anatomy.joints) == 20  # all parts but the spine
    assert anatomy.head_tip == skeleton_of(PERFORMERS[1]).index("Head_end")


def test_written_files_read_back_and_are_the_same_bytes(tmp_path: Path) -> None:
    written = write_demo(tmp_path / "a", minutes=0.2, seed=5)
    again = write_demo(tmp_path / "b", minutes=0.2, seed=5)
    assert [p.read_bytes() for p in written] == [p.read_bytes() for p in again]
    demo = make_demo(minutes=0.2, seed=5)
    assert [p.name for p in written] == [*(f"{clip.name}.bvh" for clip in demo.clips), "labels.csv"]
    back = read_bvh(written[0])
    assert back.skeleton.names == demo.clips[0].skeleton.names
    assert np.abs(joint_positions(back) - joint_positions(demo.clips[0])).max() < 1e-4
    assert tuple(read_labels(written[-1])) == tuple(demo.labels)


def test_data_file_is_small_and_carries_its_licence() -> None:
    data = files("core").joinpath("data")
    assert len(data.joinpath("demo_motions.npz").read_bytes()) < 100_000
    licence = data.joinpath("demo_motions.LICENSE.txt").read_text(encoding="utf-8")
    assert "zlib" in licence and "ALTERED" in licence and "not recorded" in licence
    assert len(sources()) == 15 and 1600 < sum(len(motion) for _, motion in sources().values()) < 1650


def test_data_file_is_what_the_package_holds() -> None:
    """The extraction script, run again, gives the file that is here."""
    pytest.importorskip("pybullet_data")
    import importlib.util

    script = Path(__file__).parents[3] / "scripts" / "extract_demo_motions.py"
    spec = importlib.util.spec_from_file_location("extract_demo_motions", script)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    import pybullet_data

    folder = Path(pybullet_data.getDataPath(), "data", "motions")
    for name in ("walk", "kick"):
        rows = module.extract(name, folder / f"humanoid3d_{name}.txt")
        times, motion = sources()[name]
        assert np.allclose(np.cumsum(rows[:-1, 0] * 1e-4), times[1:])
        assert np.allclose(motion.pelvis[:, 1], rows[:, 2] * 1e-4)


def test_unknown_actions_are_refused() -> None:
    for sentence in ((), ("idle", "swim")):
        with pytest.raises(ValueError, match="made of"):
            perform(sentence)
