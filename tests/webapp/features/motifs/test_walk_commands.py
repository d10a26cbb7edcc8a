"""``motionscape walk``: a BVH and its provenance from a folder and a motifs.json; errors in one line."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from core.demo import write_demo
from core.mocap.bvh import read_bvh
from core.mocap.dataset import open_dataset
from core.motifs.build import find_motifs
from webapp.cli.main import main


@pytest.fixture(scope="module")
def recordings(tmp_path_factory) -> tuple[Path, Path, dict]:
    """A folder of the demo, its motifs.json, and what that holds."""
    folder = tmp_path_factory.mktemp("walk")
    write_demo(folder / "demo", minutes=0.7, seed=3)
    dataset = open_dataset(folder / "demo")
    document = find_motifs(dataset).to_json(dataset)
    (folder / "motifs.json").write_text(json.dumps(document))
    return folder / "demo", folder / "motifs.json", document


def test_a_walk_is_written_with_where_it_comes_from(recordings, tmp_path, capsys) -> None:
    source, graph, document = recordings
    edge = document["edges"][0]
    path = f"{edge['source']},{edge['target']}"
    out, parts = tmp_path / "walk.bvh", tmp_path / "walk.json"
    words = ["walk", str(source), "--from", str(graph), "--motifs", path, "--out", str(out), "--parts", str(parts)]
    assert main(words) == 0
    clip, written = read_bvh(out), json.loads(parts.read_text())
    assert clip.n_frames == written["frames"] == written["parts"][-1]["end"]
    assert written["format"] == "motionscape/walk/1" and written["path"] == [edge["source"], edge["target"]]
    said = capsys.readouterr().out
    assert "foot skate, m per second of contact" in said and "fastest joint" in said and str(out) in said


def test_random_and_between(recordings, tmp_path) -> None:
    source, graph, document = recordings
    common = ["walk", str(source), "--from", str(graph), "--quiet", "--out"]
    for name in ("a", "b"):
        assert main([*common, str(tmp_path / f"{name}.bvh"), "--random", "--seconds", "5", "--seed", "2"]) == 0
    first, second = ((tmp_path / f"{name}.bvh").read_bytes() for name in "ab")
    assert first == second
    edge = document["edges"][-1]
    ends = ["--start", str(edge["source"]), "--target", str(edge["target"])]
    for by in ("fewest", "used"):
        assert main([*common, str(tmp_path / "new" / "folder" / "c.bvh"), *ends, "--by", by, "--plain"]) == 0


def test_what_is_wrong_is_said_in_one_line(recordings, tmp_path, capsys) -> None:
    source, graph, document = recordings
    out = str(tmp_path / "walk.bvh")
    edges = {(e["source"], e["target"]) for e in document["edges"]}
    ids = [m["id"] for m in document["motifs"]]
    apart = next((a, b) for a in ids for b in ids if a != b and (a, b) not in edges)
    cases = [
        (["--motifs", "99999"], "There is no motif 99999"),
        (["--motifs", f"{apart[0]},{apart[1]}"], "--gaps bridge"),
        ([], "Say which way to go"),
        (["--motifs", "1", "--random"], "Say which way to go"),
        (["--target", "1"], "needs --start"),
        (["--random", "--seconds", "0"], "--seconds"),
        (["--random", "--out", str(tmp_path / "walk.fbx")], "names a BVH file"),
        (["--motifs", "1", "--from", str(source / "labels.csv")], "not a file that"),
        (["--motifs", "1", "--parts", str(source)], "is a folder; --parts names the file to write"),
    ]
    for options, words in cases:
        assert main(["walk", str(source), "--from", str(graph), "--out", out, "--quiet", *options]) == 2
        said = capsys.readouterr().err
        assert words in said and said.count("\n") == 1
    one = min(source.glob("*.bvh"))
    assert main(["walk", str(one), "--from", str(graph), "--motifs", "1", "--out", out]) == 2
    assert "does not have" in capsys.readouterr().err
    assert not Path(out).exists()
