"""Motion and features for other tools, from the app and from the command line."""

from __future__ import annotations

import io

import numpy as np
import pytest

from core import analyses
from core.mocap.bvh import read_bvh
from core.mocap.kinematics import joint_positions
from core.workspace import Workspace
from tests.webapp.generated import walkers
from webapp.app import create_app
from webapp.cli.main import main


@pytest.fixture(scope="module")
def workspace(tmp_path_factory):
    made = Workspace(tmp_path_factory.mktemp("export") / "ws")
    made.add_dataset("walkers", walkers(("a_01", "b_01"), seconds=2.0))
    yield made
    made.close()


@pytest.fixture(scope="module")
def client(workspace):
    return create_app(workspace.path).server.test_client()


def test_a_segment_leaves_as_bvh(workspace, client, tmp_path):
    answer = client.get("/api/bvh/walkers/a_01?start=10&end=50")
    assert answer.status_code == 200 and "a_01%2010-50.bvh" in answer.headers["Content-Disposition"]
    (tmp_path / "part.bvh").write_bytes(answer.data)
    part, expected = read_bvh(tmp_path / "part.bvh"), workspace.open("walkers").clip("a_01").cut(10, 50)
    order = [part.skeleton.index(name) for name in expected.skeleton.names]  # a file goes limb by limb
    np.testing.assert_allclose(joint_positions(part)[:, order], joint_positions(expected), atol=1e-4)


@pytest.mark.parametrize(
    "path", ["bvh/walkers/nobody", "bvh/nowhere/a_01", "bvh/~made~up/a_01", "features/walkers.csv"]
)
def test_what_is_not_there_is_said(client, path):
    answer = client.get(f"/api/{path}")
    assert answer.status_code == 404 and answer.json["error"].endswith(".")


def test_features_once_computed_can_be_downloaded(workspace, client):
    assert client.get("/api/features/walkers.npz").status_code == 404
    analyses.run(workspace, analyses.Request("walkers", "features"))
    answer = client.get("/api/features/walkers.npz")
    with np.load(io.BytesIO(answer.data), allow_pickle=False) as found:
        assert tuple(found["clips"]) == ("a_01", "b_01") and len(found["frames"]) == 120
        assert set(found["labels"]) == {-1}
    assert client.get("/api/features/walkers.parquet").data[:4] == b"PAR1"
    labels = workspace.path.parent / "labels.csv"
    labels.write_text("clip,start_frame,end_frame,action\na_01,0,60,step\n")
    workspace.add_labels("walkers", [labels])
    with np.load(io.BytesIO(client.get("/api/features/walkers.npz").data), allow_pickle=False) as found:
        assert list(found["labels"][:30]) == [0] * 30 and tuple(found["actions"]) == ("step",)
    assert client.get("/api/features/walkers.npz?analysis_fps=no").status_code == 400


def test_the_command_writes_features_and_clips(workspace, tmp_path, capsys):
    source = f"{workspace.path}/walkers"
    assert main(["export", source, "--out", str(tmp_path / "f.npz"), "--quiet"]) == 0
    assert main(["export", source, "--clips", "a_01", "--frames", "5-25", "--out", str(tmp_path / "c.bvh")]) == 0
    assert read_bvh(tmp_path / "c.bvh").n_frames == 20
    assert main(["export", source, "--out", str(tmp_path / "all"), "--quiet"]) == 0
    assert sorted(path.name for path in (tmp_path / "all").iterdir()) == ["a_01.bvh", "b_01.bvh"]


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (["--out", "x.csv"], ".bvh or .glb"),
        (["--out", "x.bvh"], "choose it with --clips"),
        (["--out", "x.npz", "--frames", "1-2"], "--frames"),
        (["--out", "x.bvh", "--clips", "a_01", "--frames", "5-900"], "frames 0 to 120"),
    ],
)
def test_wrong_use_is_one_clear_line(workspace, options, words, capsys):
    assert main(["export", f"{workspace.path}/walkers", *options, "--quiet"]) == 2
    assert words in capsys.readouterr().err
