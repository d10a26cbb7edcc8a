"""Results and uploads on disk: whole or absent, damaged ones set aside, never a pickle."""

import errno
import os
import pickle

import numpy as np
import pytest

from core.workspace import NameRefused, ResultDamaged, Workspace, WorkspaceError

KEY = "0123456789abcdef"


@pytest.fixture
def workspace(tmp_path):
    return Workspace(tmp_path / "space")


def test_what_is_put_comes_back(workspace):
    assert workspace.results.get(KEY) is None
    workspace.results.put(KEY, {"a": [1, 2.5, "ü"]})
    assert workspace.results.get(KEY).document == {"a": [1, 2.5, "ü"]}
    arrays = {"x": np.arange(12, dtype=np.float32).reshape(3, 4), "y": np.array([], np.int64)}
    workspace.results.put(KEY + "00", {"b": None}, arrays)
    found = workspace.results.get(KEY + "00")
    assert found.document == {"b": None}
    assert all(np.array_equal(found.arrays[n], arrays[n]) and found.arrays[n].dtype == arrays[n].dtype for n in arrays)
    workspace.results.remove(KEY)
    assert not workspace.results.has(KEY) and workspace.results.has(KEY + "00")


@pytest.mark.parametrize("key", ["../../etc/passwd", "/etc/passwd", "ABCDEF0123", "", "a", "nul\0" * 4, "g" * 16, None])
def test_keys_are_hashes_and_nothing_else(workspace, key):
    for use in (workspace.results.get, workspace.results.has, workspace.results.remove):
        with pytest.raises(NameRefused):
            use(key)
    with pytest.raises(NameRefused):
        workspace.results.put(key, {})


@pytest.mark.parametrize("damage", [b"", b"{", b"[1]", b"\xff\xfe\x00", b'{"a": 1'])
def test_a_damaged_document_is_said_once_and_set_aside(workspace, damage):
    workspace.results.put(KEY, {"a": 1})
    path = next(workspace.results.folder.rglob("*.json"))
    path.write_bytes(damage)
    with pytest.raises(ResultDamaged, match="set aside"):
        workspace.results.get(KEY)
    assert workspace.results.get(KEY) is None
    workspace.results.put(KEY, {"a": 2})
    assert workspace.results.get(KEY).document == {"a": 2}


def test_cut_and_flipped_arrays_are_noticed(workspace):
    for damage in (lambda b: b[:-30], lambda b: b[:100], lambda b: b[:300] + bytes(50) + b[350:]):
        workspace.results.put(KEY, {"a": 1}, {"x": np.arange(1000.0)})
        path = next(workspace.results.folder.rglob("*.npz"))
        path.write_bytes(damage(path.read_bytes()))
        with pytest.raises(ResultDamaged):
            workspace.results.get(KEY)


def test_a_pickle_is_never_loaded(workspace, tmp_path):
    class Evil:
        def __reduce__(self):
            return os.mkdir, (str(tmp_path / "owned"),)

    workspace.results.put(KEY, {}, {"x": np.zeros(3)})
    path = next(workspace.results.folder.rglob("*.npz"))
    np.savez(path, document=np.array([Evil()], dtype=object), allow_pickle=True)
    with pytest.raises(ResultDamaged):
        workspace.results.get(KEY)
    path.with_name(path.name).write_bytes(pickle.dumps(Evil()))
    with pytest.raises(ResultDamaged):
        workspace.results.get(KEY)
    assert not (tmp_path / "owned").exists()
    with pytest.raises(ValueError, match="numbers"):
        workspace.results.put(KEY, {}, {"x": np.array([Evil()], dtype=object)})


@pytest.mark.parametrize(
    ("code", "words"), [(errno.ENOSPC, "disk is full"), (errno.EACCES, "permission denied"), (errno.EROFS, "read-only")]
)
def test_a_full_disk_leaves_nothing_half_and_is_said_plainly(workspace, monkeypatch, code, words):
    def fails(_descriptor):
        raise OSError(code, os.strerror(code))

    workspace.results.put(KEY, {"old": 1})
    monkeypatch.setattr("core.mocap.files.os.fsync", fails)
    with pytest.raises(WorkspaceError, match=words):
        workspace.results.put(KEY, {"new": 1})
    token = workspace.uploads.create()
    with pytest.raises(WorkspaceError, match=words):
        workspace.uploads.add(token, "a.bvh", [b"x"])
    assert workspace.results.get(KEY).document == {"old": 1}
    assert [p.name for p in workspace.path.rglob("*") if p.name.startswith(".tmp")] == []
    assert list(workspace.uploads.path(token).iterdir()) == []


def test_old_temporary_files_are_swept_and_young_ones_left(workspace):
    workspace.results.put(KEY, {})
    folder = next(workspace.results.folder.rglob("*.json")).parent
    old, young = folder / ".tmp-old", folder / ".tmp-young"
    old.write_bytes(b"half")
    young.write_bytes(b"half")
    os.utime(old, (0, 0))
    workspace.results.put(KEY, {})
    assert not old.exists() and young.exists()


def test_an_upload_holds_its_files_until_removed(workspace):
    token = workspace.uploads.create()
    path = workspace.uploads.add(token, "walks/ä.bvh", [b"HIER", b"ARCHY"])
    assert path.read_bytes() == b"HIERARCHY" and path.is_relative_to(workspace.path)
    assert workspace.uploads.file(token, "walks/ä.bvh") == path
    assert workspace.uploads.size(token) == Workspace(workspace.path).uploads.size(token) == (1, 9)
    workspace.uploads.remove(token)
    workspace.uploads.remove(token)
    with pytest.raises(WorkspaceError, match="no longer here"):
        workspace.uploads.path(token)


def test_an_upload_that_breaks_off_leaves_no_file(workspace):
    def broken():
        yield b"HIER"
        raise ConnectionError("gone")

    token = workspace.uploads.create()
    with pytest.raises(WorkspaceError):
        workspace.uploads.add(token, "a.bvh", broken())
    assert list(workspace.uploads.path(token).iterdir()) == []


def test_uploads_have_limits_and_stay_inside(workspace, monkeypatch, tmp_path):
    token = workspace.uploads.create()
    monkeypatch.setattr("core.workspace.uploads.MAX_BYTES", 10)
    with pytest.raises(WorkspaceError, match="at most"):
        workspace.uploads.add(token, "a.bvh", [b"123456", b"123456"])
    monkeypatch.setattr("core.workspace.uploads.MAX_FILES", 1)
    workspace.uploads.add(token, "b.bvh", [b"1"])
    with pytest.raises(WorkspaceError, match="at most 1 files"):
        workspace.uploads.add(token, "c.bvh", [b"1"])
    (workspace.uploads.path(token) / "link").symlink_to(tmp_path)
    monkeypatch.setattr("core.workspace.uploads.MAX_FILES", 100)
    with pytest.raises(NameRefused):
        workspace.uploads.add(token, "link/out.bvh", [b"1"])
    for bad in ("..", "../datasets", "x", "/", "a\0"):
        with pytest.raises(NameRefused):
            workspace.uploads.path(bad)
        with pytest.raises(NameRefused):
            workspace.uploads.remove(bad)
    assert not (tmp_path / "out.bvh").exists()
