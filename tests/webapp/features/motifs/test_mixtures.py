"""Made-up motion of a motif: names and weights, what opens and what is refused, what the blend side is told."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from core import analyses
from core.mocap.clip import Segment
from core.mocap.dataset import Dataset
from core.motifs.blend_space import blendable
from core.motifs.compression import OWN, POSE_PCA, Step
from core.motifs.graph import MotifGraph, dataset_head
from core.workspace import Workspace, WorkspaceError
from tests.core.motifs.test_blend_space import motif_of, scattered
from tests.webapp.stored import misfit
from webapp.app import create_app
from webapp.features.motifs import mixtures, names
from webapp.features.motifs.blend_side import MOST_MIXED, blend_data
from webapp.shell.virtual import open_any

KEY_REQUEST = analyses.Request("punches", "motifs")


@pytest.fixture(scope="module")
def workspace(tmp_path_factory: pytest.TempPathFactory) -> Workspace:
    """Ten punches of one body and one of another, found to be one motif."""
    clips = (*scattered("punch", range(10)), *scattered("punch", range(1), performer=1))
    dataset, motif = motif_of([replace(clip, name=f"p{k}") for k, clip in enumerate(clips)])
    workspace = Workspace(tmp_path_factory.mktemp("mixtures") / "workspace")
    workspace.add_dataset("punches", dataset)
    dataset = workspace.open("punches")
    alone = replace(motif, id=1, segments=(Segment("c0", 5, 60), Segment("c10", 5, 60)), warps=(np.arange(55.0),) * 2)
    graph = MotifGraph((motif, alone), (), {}, {}, dataset=dataset_head(dataset))
    workspace.results.put(analyses.key(workspace, KEY_REQUEST), graph.to_json(dataset))
    return workspace


@pytest.fixture(scope="module")
def key(workspace: Workspace) -> str:
    return analyses.key(workspace, KEY_REQUEST)


@given(st.dictionaries(st.integers(0, 999), st.integers(0, 100).map(lambda n: n / 100), min_size=1, max_size=20))
def test_weights_survive_a_link(weights: dict[int, float]):
    text = mixtures.write_weights(weights)
    assert mixtures.read_weights(text) == weights and set(text) <= set("0123456789:.,")


@pytest.mark.parametrize(
    "text", ["", "x", "1", "1:", "1:2:3", "1:-1", "1:nan", "1:1e9", "1:1,", ",".join(["1:1"] * 99)]
)
def test_unreadable_weights_are_refused(text: str):
    with pytest.raises(WorkspaceError, match="cannot be read"):
        mixtures.read_weights(text)


def test_a_mixture_opens_like_a_recording(workspace: Workspace, key: str):
    name = mixtures.blend_name(key, 0, {3: 0.5, 1: 0.25, 7: 0.0})
    assert name == f"~blend~{key}~0~1:0.25,3:0.5"
    dataset = open_any(workspace, name)
    assert isinstance(dataset, Dataset) and dataset.names == ("blend",)
    assert open_any(workspace, name) is dataset
    alone = open_any(workspace, mixtures.blend_name(key, 0, {4: 1.0})).clip("blend")
    assert alone.n_frames == workspace.open("punches").clip("c4").n_frames


@pytest.mark.parametrize(
    ("rest", "words"),
    [
        ("", "damaged"),
        ("{key}~0", "damaged"),
        ("{key}~0~1:1~2", "damaged"),
        ("{key}~0~1:0", "weight above 0"),
        ("{key}~0~99:1", "no motion 100"),
        ("{key}~0~1:0.5,10:0.5", "cannot be mixed"),
        ("{key}~9~1:1", "not there any more"),
        ("{key}~x~1:1", "not there any more"),
        ("0123456789abcdef0123456789abcdef~0~1:1", "not there any more"),
        ("../../etc~0~1:1", "key"),
    ],
)
def test_what_cannot_be_mixed_says_so(workspace: Workspace, key: str, rest: str, words: str):
    with pytest.raises(WorkspaceError, match=words):
        open_any(workspace, "~blend~" + rest.format(key=key))


def test_rebuilt_motions_stand_beside_their_originals(workspace: Workspace, key: str):
    dataset = open_any(workspace, mixtures.rebuilt_name(key, 0, OWN, Step(2)))
    assert len(dataset.clips) == 20 and {"1 original", "1 rebuilt", "10 rebuilt"} <= set(dataset.names)
    for rest in (f"{key}~0~{OWN}~0~0", f"{key}~0~zip~1~0", f"{key}~0~{POSE_PCA}~x~1", f"{key}~0~own~1~0~0"):
        with pytest.raises(WorkspaceError, match=r"rebuilt|damaged"):
            open_any(workspace, "~rebuilt~" + rest)


def test_curves_only_where_two_motions_are_of_one_body(workspace: Workspace, key: str):
    curves = mixtures.curves_of(workspace, key, 0)
    assert curves is not None and curves.motions == 10
    assert mixtures.curves_of(workspace, key, 0) is curves
    assert mixtures.curves_of(workspace, key, 1) is None


def test_what_the_blend_side_is_told(workspace: Workspace, key: str):
    dataset, motif = mixtures.motif_of(workspace, key, 0)
    data = json.loads(json.dumps(blend_data(workspace, key, dataset, motif, "punch")))
    assert misfit(data, names.BLEND_DATA) is None
    assert data["total"] == 11 and len(data["bodies"]) == 1
    body = data["bodies"][0]
    assert [m["motion"] for m in body["motions"]] == list(blendable(dataset, motif)[0])
    assert len(body["chosen"]) == MOST_MIXED and body["chosen"] == sorted(body["chosen"])
    for motion in body["motions"]:
        seconds = motion["seconds"]
        assert seconds[0] == 0 and (np.diff(seconds) > 0).all()
        assert seconds[-1] == pytest.approx((motion["end"] - motion["start"] - 1) / motion["fps"], abs=1e-3)
    assert data["middles"]["layout"] == "pose" and len(data["middles"]["items"]) == 11
    alone = mixtures.motif_of(workspace, key, 1)[1]
    assert blend_data(workspace, key, dataset, alone, "alone")["bodies"] == []


def test_mixtures_are_served_and_saved(workspace: Workspace, key: str, tmp_path: Path):
    client = create_app(workspace.path).server.test_client()
    name = mixtures.blend_name(key, 0, {0: 0.5, 1: 0.5})
    assert client.get(f"/api/motion/{name}/blend").status_code == 200
    saved = client.get(f"/api/bvh/{name}/blend")
    assert saved.status_code == 200 and saved.data.startswith(b"HIERARCHY")
    refused = client.get(f"/api/motion/~blend~{key}~0~1:0.5,10:0.5/blend")
    assert refused.status_code == 404 and "cannot be mixed" in refused.json["error"]
