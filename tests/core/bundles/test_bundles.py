"""A bundle gives another workspace the same state; what is damaged, foreign or meant to do harm is refused in words."""

from __future__ import annotations

import hashlib
import json
import zipfile
from pathlib import Path

import numpy as np
import pytest

from core import analyses
from core.bundles import take_bundle, write_bundle
from core.workspace import Workspace, WorkspaceError
from core.workspace.blocks import Block
from tests.webapp.generated import walkers


@pytest.fixture(scope="module")
def home(tmp_path_factory) -> Workspace:
    workspace = Workspace(tmp_path_factory.mktemp("home"))
    workspace.add_dataset("walks", walkers(("a", "b")))
    request = analyses.Request("walks", "motifs")
    graph = analyses.run(workspace, request)
    analyses.run(workspace, analyses.Request("walks", "map", {"grid": "5x5"}))
    motif, id = graph.motifs[0], workspace.info("walks").id
    workspace.notes.put(id, analyses.key(workspace, request), motif.id, motif.segments, name="stroll", tags=("calm",))
    workspace.views.save("/motifs?dataset=walks&motif=0", "A stroll", tags=["calm"])
    pinned = {"dataset": "walks", "fingerprint": workspace.info("walks").fingerprint, "key": ""}
    board = workspace.boards.create("Ours", [Block("g", "graph", settings={"title": "Graph", "pinned": pinned})])
    workspace.boards.set_filters(board.id, {"dataset": "walks"})
    first = workspace.comments.add(f"board:{board.id}/block:g", "Why @Ben?", "Ana")
    workspace.comments.add(f"board:{board.id}/block:g", "Because.", "Ben", first.id)
    workspace.comments.resolve(first.id)
    return workspace


@pytest.fixture(scope="module")
def bundle(home, tmp_path_factory) -> Path:
    path = tmp_path_factory.mktemp("bundle") / "walks.zip"
    write_bundle(home, "walks", path)
    return path


@pytest.fixture
def other(tmp_path) -> Workspace:
    return Workspace(tmp_path / "other")


def repacked(bundle: Path, out: Path, change) -> Path:
    """The bundle with other files; ``change`` gets name -> bytes, and the manifest is made to fit."""
    with zipfile.ZipFile(bundle) as packed:
        files = {name: packed.read(name) for name in packed.namelist()}
    manifest = json.loads(files.pop("manifest.json"))
    change(files, manifest)
    manifest["files"] = {
        name: {"sha256": hashlib.sha256(data).hexdigest(), "bytes": len(data)} for name, data in files.items()
    }
    with zipfile.ZipFile(out, "w") as packed:
        packed.writestr("manifest.json", json.dumps(manifest))
        for name, data in files.items():
            packed.writestr(name, data)
    return out


def test_another_workspace_gets_the_same_state(home, bundle, other, tmp_path):
    taken = take_bundle(other, bundle)
    assert taken.dataset == "walks" and taken.new and (taken.notes, taken.views, taken.boards) == (1, 1, 1)
    assert other.info("walks").fingerprint == home.info("walks").fingerprint
    assert analyses.stored(other, analyses.Request("walks", "motifs")) is not None
    again = tmp_path / "again.zip"
    write_bundle(other, "walks", again)
    assert again.read_bytes() == bundle.read_bytes()
    board = other.boards.all()[0]
    first, answer = other.comments.under(f"board:{board.id}")
    assert first.resolved and answer.parent == first.id and first.author == "Ana"


def test_a_second_time_nothing_is_added(bundle, other):
    take_bundle(other, bundle)
    taken = take_bundle(other, bundle)
    assert taken == ("walks", False, 0, 0, 0, 0)


def test_under_another_name_everything_follows(bundle, other):
    take_bundle(other, bundle, "strolls")
    assert other.boards.all()[0].filters == {"dataset": "strolls"}
    assert other.boards.all()[0].blocks[0].settings["pinned"]["dataset"] == "strolls"
    assert other.views.all()[0].address == "/motifs?dataset=strolls&motif=0"


def test_features_only_hold_no_recordings_and_need_them(home, other, tmp_path, bundle):
    path = tmp_path / "features.zip"
    manifest = write_bundle(home, "walks", path, recordings=False)
    assert "features.npz" in manifest["files"] and not [name for name in manifest["files"] if "motion" in name]
    with pytest.raises(WorkspaceError, match="without recordings, and the recordings they were made from"):
        take_bundle(other, path)
    assert other.datasets() == []
    other.add_dataset("walks", home.open("walks"))
    assert take_bundle(other, path).results > 0 and other.boards.all()


def test_every_byte_that_changes_is_noticed(bundle, other, tmp_path):
    data = bytearray(bundle.read_bytes())
    with zipfile.ZipFile(bundle) as packed:
        places = [
            info.header_offset + 50 + len(info.filename) + info.compress_size // 2
            for info in packed.infolist()
            if info.compress_size > 200
        ]
    for at in places:
        broken = tmp_path / "broken.zip"
        changed = data.copy()
        changed[at] ^= 0x55
        broken.write_bytes(changed)
        with pytest.raises(WorkspaceError):
            take_bundle(other, broken)
    broken.write_bytes(data[: len(data) // 2])
    with pytest.raises(WorkspaceError, match=r"no zip, or a damaged one"):
        take_bundle(other, broken)
    assert other.datasets() == [] and other.boards.all() == [] and list(other.results.all_keys()) == []
    assert list((other.path / "uploads").iterdir()) == []


class Harm:
    def __reduce__(self):
        return Path.touch, (Path("harm-was-done"),)


def _pickled(files, manifest):
    array = np.array([Harm()], dtype=object)
    name = next(name for name in files if name.startswith("results/") and name.endswith(".json"))
    files.pop(name)
    path = Path("harmful.npz")
    np.savez(path, document=array)
    files[name.replace(".json", ".npz")] = path.read_bytes()
    path.unlink()


def _renamed(name):
    def change(files, manifest):
        files[name] = files.pop("notes.json")

    return change


def _drawing(files, manifest):
    document = {"format": "motionscape/block/1", "kind": "text", "content": {"html": "<img src=x onerror=alert(1)>"}}
    files["results/" + "ab" * 16 + ".json"] = json.dumps(document).encode()


def _poisoned_board(files, manifest):
    boards = json.loads(files["boards.json"])
    boards[0]["blocks"][0]["kind"] = "<script>"
    files["boards.json"] = json.dumps(boards).encode()


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (_renamed("../../outside.json"), "something that a bundle does not"),
        (_renamed("/etc/outside.json"), "something that a bundle does not"),
        (_renamed("results/../../outside.json"), "something that a bundle does not"),
        (_renamed("results/outside.json"), "no key"),
        (_renamed("dataset\\outside.json"), "something that a bundle does not"),
        (_renamed("more.py"), "something that a bundle does not"),
        (_pickled, "damaged, or no result"),
        (lambda files, manifest: manifest.update(format="motionscape/bundle/99"), "not 'motionscape/bundle/1'"),
        (lambda files, manifest: manifest.pop("dataset"), "incomplete"),
        (lambda files, manifest: manifest["dataset"].update(fingerprint="0" * 32), "not those that its results"),
        (lambda files, manifest: files.update({"boards.json": b"{}"}), "is no list"),
        (lambda files, manifest: files.update({"notes.json": b"[" * 100_000}), "cannot be read"),
        (lambda files, manifest: files.pop("dataset/motion.npy"), "cannot be read"),
        (_drawing, "something that a bundle does not: a drawing"),
        (_poisoned_board, "characters that it cannot have"),
    ],
)
def test_what_is_foreign_or_harmful_is_refused(bundle, other, tmp_path, monkeypatch, change, words):
    monkeypatch.chdir(tmp_path)
    path = repacked(bundle, tmp_path / "foreign.zip", change)
    with pytest.raises(WorkspaceError, match=words):
        take_bundle(other, path)
    assert not (tmp_path / "harm-was-done").exists() and not list(tmp_path.rglob("outside*"))
    assert other.boards.all() == []


def test_files_that_are_not_listed_and_other_zips_are_refused(bundle, other, tmp_path):
    more = tmp_path / "more.zip"
    more.write_bytes(bundle.read_bytes())
    with zipfile.ZipFile(more, "a") as packed:
        packed.writestr("extra.txt", "x")
    with pytest.raises(WorkspaceError, match="do not agree"):
        take_bundle(other, more)
    with zipfile.ZipFile(tmp_path / "plain.zip", "w") as packed:
        packed.writestr("readme.txt", "hello")
    with pytest.raises(WorkspaceError, match=r"no bundle of Motionscape: it has no manifest.json"):
        take_bundle(other, tmp_path / "plain.zip")


def test_a_file_that_grows_beyond_what_it_says_is_cut_off(bundle, other, tmp_path):
    path = repacked(bundle, tmp_path / "bomb.zip", lambda files, manifest: None)
    with zipfile.ZipFile(path) as packed:
        files = {name: packed.read(name) for name in packed.namelist()}
    files["notes.json"] = b" " * 50_000_000
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as packed:
        for name, data in files.items():
            packed.writestr(name, data)
    with pytest.raises(WorkspaceError, match=r"damaged: notes.json"):
        take_bundle(other, path)
