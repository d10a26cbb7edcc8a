"""Repairs as jobs: only what was chosen changes, and it is undone."""

from __future__ import annotations

import pytest

from core import analyses
from core.errors import MotionscapeError
from core.mocap.clip import Label
from core.mocap.dataset import Dataset
from core.requests import repair_request, usual_repairs_request
from core.workspace import Workspace, WorkspaceError
from tests.core.editing.test_repairs import jumping
from tests.core.mocap.odd_clips import mirrored, walking


@pytest.fixture
def workspace(tmp_path):
    """A workspace with a clip that jumps twice, a mirrored one, and one in which all is well."""
    space = Workspace(tmp_path / "space")
    clips = (jumping(walking("jumpy"), 60, 63), mirrored(walking("left", speed=1.0)), walking("calm", speed=1.4))
    space.add_dataset("odd", Dataset("odd", clips, (Label("jumpy", 0, 50, "walk"), Label("calm", 0, 9, "walk"))))
    return space


def kinds(workspace) -> dict[str, set[str]]:
    """What is found in each clip, beside that they are alike."""
    found = workspace.report("odd").findings_by_clip()
    kinds = {clip: {finding.kind for finding in findings} - {"duplicate"} for clip, findings in found.items()}
    return {clip: some for clip, some in kinds.items() if some}


def test_one_repair_of_one_clip_and_back(workspace):
    before = workspace.open("odd")
    assert kinds(workspace) == {"jumpy": {"jump"}, "left": {"sides"}}
    request = repair_request("odd", [{"clip": "jumpy", "action": "fill", "start": 60, "end": 63}], before.fingerprint)
    analyses.run(workspace, request)
    after = workspace.open("odd")
    assert kinds(workspace) == {"left": {"sides"}}
    assert after.labels and set(after.labels) == set(before.labels)
    assert [a == b for a, b in zip(after.digests, before.digests, strict=True)] == [False, True, True]
    with pytest.raises(MotionscapeError, match="has changed meanwhile"):
        analyses.run(workspace, request)
    workspace.revert(workspace.last_version("odd"))
    assert workspace.open("odd").fingerprint == before.fingerprint
    assert kinds(workspace) == {"jumpy": {"jump"}, "left": {"sides"}}


def test_the_usual_repairs_of_several_clips(workspace):
    analyses.run(workspace, usual_repairs_request("odd", ["jumpy", "left", "calm"], ["sides"]))
    assert kinds(workspace) == {"jumpy": {"jump"}}
    analyses.run(workspace, usual_repairs_request("odd", ["jumpy", "left", "calm"]))
    assert kinds(workspace) == {}
    with pytest.raises(MotionscapeError, match="nothing to repair"):
        analyses.run(workspace, usual_repairs_request("odd", ["calm"]))


def test_requests_that_mean_nothing_are_refused(workspace):
    with pytest.raises(WorkspaceError, match="no clip 'gone'"):
        workspace.repair("odd", {"gone": []})
    with pytest.raises(MotionscapeError, match="not clear"):
        analyses.run(workspace, analyses.Request("odd", "repair", {"repairs": '["x"]'}))
    with pytest.raises(MotionscapeError, match="no repair 'melt'"):
        analyses.run(workspace, repair_request("odd", [{"clip": "calm", "action": "melt"}]))
