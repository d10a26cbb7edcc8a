"""Edits of clips as jobs: what comes of them is stored, the rest stays as it was, and it can be undone."""

from __future__ import annotations

import numpy as np
import pytest

from core import analyses, requests
from core.errors import ParameterError
from core.mocap.clip import Label
from core.mocap.dataset import Dataset
from core.workspace import Workspace, WorkspaceError
from tests.core.editing.figures import going


@pytest.fixture
def workspace(tmp_path):
    workspace = Workspace(tmp_path / "space")
    clip = going(("walk", 2.0))
    workspace.add_dataset(
        "walks", Dataset("walks", (clip,), (Label("gait", 0, 60, "walk"), Label("gait", 60, 120, "on")))
    )
    return workspace


def edit(workspace: Workspace, action: str, **options) -> Dataset:
    analyses.run(workspace, requests.edit_request("walks", "gait", action, **options))
    return workspace.open(options.get("into") or "walks")


@pytest.mark.parametrize(
    ("action", "options", "names"),
    [
        ("trim", {"start": 10, "end": 70}, ["gait 10-70"]),
        ("mirror", {}, ["gait mirrored"]),
        ("rate", {"fps": 30}, ["gait 30 fps"]),
        ("split", {"frame": 40}, ["gait walk", "gait part 2"]),
        ("labels", {}, ["gait walk", "gait on"]),
    ],
)
def test_every_edit_adds_clips_and_can_be_undone(workspace, action, options, names):
    before, token = workspace.open("walks"), workspace.version("walks")
    after = edit(workspace, action, **options)
    assert after.names == ("gait", *names)
    assert after.digests[0] == before.digests[0] and after.fingerprint != before.fingerprint
    assert {label.clip for label in after.labels} >= set(names)
    files = {file.clip: file for file in after.report.files}
    assert all("gait" in files[name].messages[0] for name in names)
    assert {files[name].addition for name in names} == {1}
    assert Workspace(workspace.path).open("walks").clip(names[0]).n_frames == after.clip(names[0]).n_frames
    workspace.revert(token)
    assert workspace.open("walks").fingerprint == before.fingerprint


def test_an_edit_made_twice_gets_a_number(workspace):
    edit(workspace, "mirror")
    after = edit(workspace, "mirror")
    assert after.names == ("gait", "gait mirrored", "gait mirrored (2)")
    assert np.array_equal(after.clips[1].rotations, after.clips[2].rotations)


def test_into_a_data_set_of_its_own(workspace):
    before = workspace.open("walks").fingerprint
    after = edit(workspace, "labels", into="pieces")
    assert after.names == ("gait walk", "gait on") and len(after.labels) == 2
    assert workspace.open("walks").fingerprint == before


def test_what_cannot_be_edited_says_why_and_leaves_all_as_it_is(workspace):
    before = workspace.open("walks").fingerprint
    for action, options, why in (
        ("trim", {"start": 50, "end": 500}, "gait has frames 0 to 120"),
        ("rate", {"fps": 60}, "60 frames a second already"),
        ("split", {"frame": 0}, "nothing to cut"),
        ("mirror", {"into": "walks"}, "already a dataset"),
    ):
        with pytest.raises(analyses.AnalysisError, match=why):
            analyses.run(workspace, requests.edit_request("walks", "gait", action, **options))
    with pytest.raises(analyses.AnalysisError, match="no clip 'jump'"):
        analyses.run(workspace, requests.edit_request("walks", "jump", "mirror"))
    with pytest.raises(ParameterError, match="action"):
        analyses.submit(workspace, requests.edit_request("walks", "gait", "paint"))
    with pytest.raises(WorkspaceError, match="no dataset"):
        analyses.submit(workspace, requests.edit_request("none", "gait", "mirror"))
    assert workspace.open("walks").fingerprint == before
