"""Folders of recordings become datasets: names, skeletons, labels, errors; and datasets go to disk and back."""

from __future__ import annotations

import gzip
import os
from dataclasses import replace

import numpy as np
import pytest

from core.mocap.bvh import write_bvh
from core.mocap.clip import Label
from core.mocap.dataset import Dataset, FileReport, ImportReport, find_recordings, open_dataset, read_recordings
from core.mocap.errors import RecordingError
from core.mocap.labels import write_labels
from core.mocap.reports import Finding
from core.mocap.storage import load_dataset, save_dataset, writing_dataset
from core.progress import Cancelled
from tests.core.mocap import samples


@pytest.fixture
def folder(tmp_path):
    """01/01.asf 01_01.amc 01_02.amc.gz; 02/02_01.amc without skeleton; b/c/walk.bvh; and what is no recording."""
    source = tmp_path / "source"
    for name in ("01", "02", "b/c", ".hidden", "__MACOSX"):
        (source / name).mkdir(parents=True)
    (source / "01/01.asf").write_text(samples.ASF)
    (source / "01/01_01.amc").write_text(samples.AMC)
    (source / "01/01_02.amc.gz").write_bytes(gzip.compress(samples.AMC.encode()))
    (source / "02/02_01.amc").write_text(samples.AMC)
    (source / "b/c/walk.bvh").write_text(samples.BVH)
    for name in (".hidden/x.bvh", "__MACOSX/x.bvh", "b/._walk.bvh", "notes.txt", "01/LICENSE"):
        (source / name).write_text("nothing")
    return source


def test_recordings_are_found(folder):
    names = [str(path.relative_to(folder)) for path in find_recordings(folder)]
    assert names == ["01/01_01.amc", "01/01_02.amc.gz", "02/02_01.amc", "b/c/walk.bvh"]
    assert find_recordings(folder / "b/c/walk.bvh") == [folder / "b/c/walk.bvh"]
    assert find_recordings([folder / "b", folder / "b/c/walk.bvh"]) == [folder / "b/c/walk.bvh"]


def test_a_dataset(folder):
    dataset = open_dataset(folder, skeleton=folder / "01/01.asf", fps=60)
    assert dataset.names == ("01_01", "01_02", "02_01", "walk")
    assert dataset.name == "source"
    assert dataset.n_frames == 12 and dataset.seconds == pytest.approx(12 / 60)
    assert [file.verdict for file in dataset.report.files] == ["ok"] * 4
    assert {clip.fps for clip in dataset.clips} == {60}
    assert open_dataset(folder, skeleton=folder / "01/01.asf", clips="walk").clips[0].fps == 30
    assert dataset.clip("01_01").skeleton is dataset.clip("02_01").skeleton
    with pytest.raises(KeyError):
        dataset.clip("run")


def test_one_file(folder):
    dataset = open_dataset(folder / "01/01_02.amc.gz")
    assert (dataset.name, dataset.names) == ("01_02", ("01_02",))


def test_only_the_clips_asked_for_are_read(folder):
    (folder / "b/c/broken.bvh").write_text("nothing")
    dataset = open_dataset(folder, clips=["walk", "01_02"])
    assert dataset.names == ("01_02", "walk")
    assert open_dataset(folder, clips="walk, 01_02").fingerprint == dataset.fingerprint
    with pytest.raises(RecordingError, match="no clip is called '01_03'; expected a clip such as 01_0"):
        open_dataset(folder, clips=["01_03"])
    with pytest.raises(RecordingError, match="no clip is chosen"):
        open_dataset(folder, clips=[])


def test_which_skeleton_a_motion_gets(folder):
    other = folder / "other.asf"
    other.write_text(samples.ASF.replace("length 7.2", "length 14.4"))

    def femur(clip):
        return float(np.linalg.norm(clip.skeleton.offsets[clip.skeleton.index("foot")]) * 0.45 / 0.0254)

    both = open_dataset(folder, skeleton=other, clips=["01_01", "02_01"])
    assert femur(both.clip("01_01")) == pytest.approx(7.2, rel=1e-4)  # its own
    assert femur(both.clip("02_01")) == pytest.approx(14.4, rel=1e-4)  # the one given
    only = folder / "02/anything.ASF"
    only.write_text(samples.ASF.replace("length 7.2", "length 3.6"))
    assert femur(open_dataset(folder / "02", skeleton=other).clips[0]) == pytest.approx(3.6, rel=1e-4)  # the only one
    (folder / "02/more.asf").write_text(samples.ASF)
    with pytest.raises(RecordingError, match=r"02_01.amc: no skeleton: neither 02.asf .*skeleton given for all"):
        open_dataset(folder / "02")
    (folder / "02/02.asf").write_text("nothing")
    with pytest.raises(RecordingError, match=r"^02\.asf"):
        open_dataset(folder / "02")


def test_names_that_collide_get_their_folder_in_front(folder):
    (folder / "b/01_01.bvh").write_text(samples.BVH)
    (folder / "b/c/walk.bvh.gz").write_bytes(gzip.compress(samples.BVH.encode()))
    dataset = open_dataset(folder, skeleton=folder / "01/01.asf")
    assert dataset.names == ("01/01_01", "01_02", "02_01", "b/01_01", "b/c/walk.bvh", "b/c/walk.bvh.gz")
    file = next(f for f in dataset.report.files if f.clip == "b/01_01")
    assert file.verdict == "warning" and "another file is called 01_01" in file.messages[0]
    assert open_dataset(folder, clips=["b/01_01"]).names == ("b/01_01",)
    with pytest.raises(RecordingError, match="b/01_01"):
        open_dataset(folder, clips=["01_01"])


def test_nothing_to_read(tmp_path):
    (tmp_path / "a.txt").write_text("nothing")
    (tmp_path / "a.asf").write_text(samples.ASF)
    for source, words in ((tmp_path, "no recordings in this folder"), (tmp_path / "b", "no such file")):
        with pytest.raises(RecordingError, match=words):
            open_dataset(source)
    for name in ("a.txt", "a.asf"):
        with pytest.raises(RecordingError, match="not a recording"):
            open_dataset(tmp_path / name)


def test_bad_files_raise_or_stand_in_the_report(folder):
    (folder / "b/bad.bvh").write_text(samples.BVH[:300])
    with pytest.raises(RecordingError, match=r"^bad.bvh"):
        open_dataset(folder, skeleton=folder / "01/01.asf")
    dataset = open_dataset(folder, on_error="report")
    assert dataset.names == ("01_01", "01_02", "walk")
    errors = [file for file in dataset.report.files if file.verdict == "error"]
    assert [file.path for file in errors] == [str(folder / "02/02_01.amc"), str(folder / "b/bad.bvh")]
    assert dataset.report.count("error") == 2 and dataset.report.count("ok") == 3
    assert open_dataset(folder / "b/bad.bvh", on_error="report").clips == ()


@pytest.mark.parametrize("fps", [0, -1, float("nan"), float("inf")])
def test_bad_frame_rates(folder, fps):
    with pytest.raises(ValueError, match="frame rate"):
        open_dataset(folder, fps=fps, clips=["walk"])


def test_labels(folder, tmp_path):
    labels = [Label("walk", 0, 2, "walk"), Label("walk", 2, 9, "stop"), Label("gone", 0, 1, "x")]
    write_labels(tmp_path / "other.csv", labels)
    dataset = open_dataset(folder, clips=["walk"], labels=tmp_path / "other.csv")
    assert dataset.labels == (Label("walk", 0, 2, "walk"), Label("walk", 2, 3, "stop"))
    assert len(dataset.report.messages) == 2
    assert open_dataset(folder, clips=["walk"]).labels == ()
    write_labels(folder / "labels.csv", labels[:1])
    assert open_dataset(folder, clips=["walk"]).labels == (Label("walk", 0, 2, "walk"),)
    with pytest.raises(RecordingError):
        open_dataset(folder, clips=["walk"], labels=tmp_path / "none.csv")


def test_selection(folder):
    write_labels(folder / "labels.csv", [Label("walk", 0, 2, "walk"), Label("01_01", 0, 2, "run")])
    dataset = open_dataset(folder, skeleton=folder / "01/01.asf")
    part = dataset.select(["walk", "01_02", "walk"])
    assert part.names == ("01_02", "walk") and part.labels == (Label("walk", 0, 2, "walk"),)
    assert part.fingerprint == open_dataset(folder, clips=["walk", "01_02"]).fingerprint != dataset.fingerprint
    assert [file.clip for file in part.report.files] == ["01_02", "walk"]
    with pytest.raises(KeyError):
        dataset.select(["run"])


def test_the_fingerprint_follows_the_content(folder):
    dataset = open_dataset(folder, clips=["walk", "01_01"])
    assert open_dataset(folder, clips=["walk", "01_01"]).fingerprint == dataset.fingerprint
    clip = dataset.clips[0]
    moved = clip.root_positions.copy()
    moved[0, 0] += 1e-3
    turned = clip.rotations.copy()
    turned[0, 0] *= -1
    changes = [{"name": "other"}, {"fps": 61.0}, {"root_positions": moved}, {"rotations": turned}]
    changes.append({"translations": {1: moved}})
    prints = {Dataset("a", (replace(clip, **change), dataset.clips[1])).fingerprint for change in [{}, *changes]}
    assert len(prints) == 1 + len(changes) and dataset.fingerprint in prints


def test_two_clips_of_one_name_are_refused():
    clip = samples.idling(seconds=0.1)
    with pytest.raises(ValueError, match="same name"):
        Dataset("a", (clip, clip))


def test_progress_and_cancel(folder):
    for k in range(30):
        (folder / f"b/{k}.bvh").write_text(samples.BVH)
    heard = []
    open_dataset(folder / "b", report=lambda stage, fraction: heard.append(fraction))
    assert heard == sorted(heard) and heard[0] == 0 and heard[-1] == 1 and len(heard) > 3

    def cancel(stage, fraction):
        if fraction > 0.4:
            raise Cancelled

    with pytest.raises(Cancelled):
        open_dataset(folder / "b", report=cancel)


def _assert_same(a: Dataset, b: Dataset) -> None:
    assert (a.name, a.names, a.labels, a.report, a.fingerprint) == (b.name, b.names, b.labels, b.report, b.fingerprint)
    for x, y in zip(a.clips, b.clips, strict=True):
        assert (x.skeleton, x.fps, x.notes, x.findings, x.up) == (y.skeleton, y.fps, y.notes, y.findings, y.up)
        assert (x.skeleton.channels, x.skeleton.unit) == (y.skeleton.channels, y.skeleton.unit)
        np.testing.assert_array_equal(x.rotations, y.rotations)
        np.testing.assert_array_equal(x.root_positions, y.root_positions)
        assert x.translations.keys() == y.translations.keys()
        for joint in x.translations:
            np.testing.assert_array_equal(x.translations[joint], y.translations[joint])


@pytest.fixture
def dataset(folder):
    write_labels(folder / "labels.csv", [Label("walk", 0, 2, "gehen, schön")])
    read = open_dataset(folder, skeleton=folder / "01/01.asf")
    clip = samples.idling("waving")
    track = np.random.default_rng(0).normal(size=(clip.n_frames, 3)).astype(np.float32)
    files = (*read.report.files, FileReport("x.bvh", None, "error", ("x.bvh:1: bad",)))
    clips = (
        *read.clips,
        replace(clip, translations={3: track}, notes=("a note",), findings=(Finding("gap", "a doubt", 1, 3),), up="z"),
    )
    return Dataset("Größe", clips, read.labels, ImportReport(files, ("all", "well")))


def test_datasets_on_disk(tmp_path, dataset):
    save_dataset(tmp_path / "new/kept", dataset)
    loaded = load_dataset(tmp_path / "new/kept")
    _assert_same(loaded, dataset)
    assert loaded.clips[0].skeleton is loaded.clips[1].skeleton
    save_dataset(tmp_path / "new/kept", loaded.select(["walk"]))  # over itself, while it is open
    _assert_same(load_dataset(tmp_path / "new/kept"), dataset.select(["walk"]))
    _assert_same(loaded, dataset)
    assert [p.name for p in (tmp_path / "new").iterdir()] == ["kept"]
    save_dataset(tmp_path / "empty", Dataset("empty", ()))
    assert load_dataset(tmp_path / "empty").clips == ()


def test_changing_a_loaded_clip_never_changes_the_files(tmp_path, dataset):
    save_dataset(tmp_path / "kept", dataset)
    load_dataset(tmp_path / "kept").clips[0].root_positions[:] = 0
    _assert_same(load_dataset(tmp_path / "kept"), dataset)


def test_loading_maps_the_numbers(tmp_path, dataset):
    save_dataset(tmp_path / "kept", dataset)
    base = load_dataset(tmp_path / "kept").clips[0].rotations
    while isinstance(base.base, np.ndarray):
        base = base.base
    assert isinstance(base, np.memmap)


def test_a_failed_save_leaves_what_was_there(tmp_path, dataset):
    save_dataset(tmp_path / "kept", dataset)
    with pytest.raises(RuntimeError), writing_dataset(tmp_path / "kept", "other") as writer:
        writer.add(dataset.clips[0])
        raise RuntimeError
    _assert_same(load_dataset(tmp_path / "kept"), dataset)
    assert [p.name for p in tmp_path.iterdir() if p.name not in ("source", "kept")] == []


def test_damaged_datasets_are_refused(tmp_path, dataset):
    with pytest.raises(RecordingError, match="no dataset"):
        load_dataset(tmp_path / "none")
    save_dataset(tmp_path / "kept", dataset)
    head, numbers = tmp_path / "kept/dataset.json", tmp_path / "kept/motion.npy"
    good_head, good_numbers = head.read_text(), numbers.read_bytes()
    bad = [(good_head[:-20], good_numbers), ("[]", good_numbers), ("{}", good_numbers), (good_head, b"nothing")]
    bad += [
        (good_head, good_numbers[:-400]),
        (good_head, b""),
        (good_head.replace('"parents": [-1', '"parents": [3'), good_numbers),
    ]
    for text, data in bad:
        head.write_text(text)
        numbers.write_bytes(data)
        with pytest.raises(RecordingError) as caught:
            load_dataset(tmp_path / "kept")
        assert "\n" not in str(caught.value)
    head.write_text(good_head.replace("dataset/1", "dataset/9"))
    with pytest.raises(RecordingError, match="dataset/9"):
        load_dataset(tmp_path / "kept")


def test_a_pickle_is_never_opened(tmp_path, dataset):
    save_dataset(tmp_path / "kept", dataset)
    trap = np.empty(1, object)
    trap[0] = os.getcwd
    np.save(tmp_path / "kept/motion.npy", trap, allow_pickle=True)
    with pytest.raises(RecordingError):
        load_dataset(tmp_path / "kept")


def test_written_clips_come_back_as_a_dataset(tmp_path):
    clips = [samples.idling(f"take {k}", seed=k, seconds=0.5) for k in range(3)]
    for clip in clips:
        write_bvh(tmp_path / f"{clip.name}.bvh", clip)
    dataset = open_dataset(tmp_path)
    assert dataset.names == tuple(clip.name for clip in clips)
    assert len({clip.skeleton for clip in dataset.clips}) == 1


@pytest.mark.parametrize(
    "part, clips, frames", [("cmu", 97, 133563), ("bandai_namco_1", 174, 31914), ("fairmotion", 3, 2992)]
)
def test_all_real_recordings_load(shared_data, part, clips, frames):
    skeleton = shared_data / "cmu/asfamc/86/86.asf"
    n, total = 0, 0
    for file, clip in read_recordings(shared_data / part, skeleton=skeleton):
        assert clip is not None, str(file)
        assert np.isfinite(clip.rotations).all() and np.isfinite(clip.root_positions).all()
        n, total = n + 1, total + clip.n_frames
    assert (n, total) == (clips, frames)


def test_the_labelled_clips_with_a_borrowed_skeleton(shared_data):
    source = shared_data / "cmu/asfamc"
    names = ["13_29", "13_30", "13_31", "14_14", "14_20"]
    dataset = open_dataset(source, clips=names, skeleton=source / "86/86.asf", labels=shared_data / "labels/mocap6")
    assert list(dataset.names) == names and dataset.n_frames == 19371
    assert len(dataset.labels) == 30 and not dataset.report.messages
