"""Recordings that are looked for: read by a job, kept under its key, refused in plain words."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from core import analyses, requests
from core.mocap.bvh import write_bvh
from core.mocap.dataset import motion_digest
from core.workspace import Workspace
from core.workspace.query_files import kept_query, pack_clip, unpack_clip
from tests.webapp.generated import walk


@pytest.fixture
def workspace(tmp_path: Path) -> Workspace:
    return Workspace(tmp_path / "workspace")


def read(workspace: Workspace, files: dict[str, bytes]) -> tuple[str, str]:
    """Uploads files and reads them as a query; the key, and the upload's token."""
    token = workspace.uploads.create()
    for name, content in files.items():
        workspace.uploads.add(token, name, [content])
    request = requests.query_request(next(iter(files)), token)
    analyses.run(workspace, request)
    return analyses.key(workspace, request), token


def test_a_recording_is_kept_and_its_upload_removed(workspace, tmp_path):
    write_bvh(tmp_path / "kick.bvh", walk("kick", seconds=1.0))
    key, token = read(workspace, {"kick.bvh": (tmp_path / "kick.bvh").read_bytes()})
    clip = kept_query(workspace, key)
    assert clip.name == "kick" and clip.n_frames == 60 and clip.fps == pytest.approx(60)
    assert not (workspace.uploads.folder / token).exists()
    assert workspace.datasets() == []


@pytest.mark.parametrize(
    ("files", "words"),
    [
        ({"bad.bvh": b"HIERARCHY\nROOT"}, "bad.bvh"),
        ({"labels.csv": b"clip,start_frame,end_frame,action\n"}, "There is no recording"),
        ({"a.amc": b":FULLY-SPECIFIED\n1\n"}, "no skeleton"),
        ({"broken.zip": b"PK\x03\x04 no archive"}, "broken.zip"),
    ],
)
def test_what_cannot_be_read_says_why(workspace, files, words):
    with pytest.raises(ValueError, match=words):
        read(workspace, files)
    assert list(workspace.uploads.folder.iterdir()) == []


def test_a_query_needs_some_frames(workspace, tmp_path):
    write_bvh(tmp_path / "short.bvh", walk("short", seconds=0.1, fps=30))
    with pytest.raises(ValueError, match="at least 8"):
        read(workspace, {"short.bvh": (tmp_path / "short.bvh").read_bytes()})


def test_packed_clips_come_back_whole():
    clip = walk("walk", seconds=0.5)
    moving = {3: np.arange(clip.n_frames * 3, dtype=np.float32).reshape(-1, 3)}
    clip = type(clip)(clip.name, clip.skeleton, clip.fps, clip.root_positions, clip.rotations, moving, ("said",))
    back = unpack_clip(*pack_clip(clip))
    assert motion_digest(back) == motion_digest(clip) and back.notes == ("said",) and back.name == clip.name
    with pytest.raises(ValueError, match="not a recording"):
        unpack_clip({"format": "motionscape/walk/1"}, {})
