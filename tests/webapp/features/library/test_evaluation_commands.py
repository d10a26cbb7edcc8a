"""``motionscape evaluate``: what it writes is what the scores say, and what it refuses."""

from __future__ import annotations

import json

import pytest

from core.demo import make_demo
from core.evaluation.action_segmentation import score_segmentation
from core.evaluation.coverage import score_motifs
from core.grammar.build import GrammarParameters, learn_grammar
from core.motifs.build import MotifParameters, find_motifs
from tests.webapp.cli.test_cli import run


@pytest.fixture(scope="module")
def demo(tmp_path_factory):
    folder = tmp_path_factory.mktemp("demo")
    run("demo", folder / "clips", "--minutes", 0.5, "--quiet")
    data = make_demo(0.5)
    motifs = find_motifs(data, MotifParameters(kappa=60))
    grammar = learn_grammar(data, GrammarParameters(n_terminals=4, starts=2, crossings=0))
    for name, result in (("motifs", motifs), ("grammar", grammar), ("terminals", grammar.terminals)):
        (folder / f"{name}.json").write_text(json.dumps(result.to_json()), encoding="utf-8")
    return folder, data, motifs, grammar


@pytest.mark.parametrize("name", ["motifs", "grammar", "terminals"])
def test_scores_are_those_of_the_functions(demo, tmp_path, name):
    folder, data, motifs, grammar = demo
    out = tmp_path / "scores.json"
    text = run("evaluate", folder / "clips", "--from", folder / f"{name}.json", "--out", out).stdout
    document = json.loads(out.read_text(encoding="utf-8"))
    classes = [m.segments for m in motifs.motifs] if name == "motifs" else grammar.terminals.segments
    expected = score_segmentation(classes, data.labels)
    assert document["format"] == "motionscape/scores/1" and [c["name"] for c in document["clips"]] == list(data.names)
    assert document["one_to_one"] == expected.one_to_one.to_json()
    assert document["clip_many_to_one"] == expected.clip_many_to_one.to_json()
    metrics = document["metrics"]
    assert list(metrics) == ["mof", "edit", "f1@10", "f1@25", "f1@50", "coverage", "purity"]
    shares = score_motifs(classes, data.labels)
    assert (metrics["coverage"], metrics["purity"]) == (shares.coverage, shares.purity)
    assert f"{metrics['mof']:.1f}" in text


def test_what_cannot_be_scored_is_said_in_one_line(demo, tmp_path):
    folder, _, _, _ = demo
    source, out = folder / "clips", tmp_path / "scores.json"
    graph = folder / "motifs.json"
    done = run("evaluate", source, "--from", graph, "--track", "quality", "--out", out, code=2)
    assert "no track “quality”" in done.stderr
    (tmp_path / "other.json").write_text('{"format": "motionscape/map/1"}', encoding="utf-8")
    done = run("evaluate", source, "--from", tmp_path / "other.json", "--out", out, code=2)
    assert "not a file that" in done.stderr and "motionscape/map/1" in done.stderr
    bare = tmp_path / "bare"
    bare.mkdir()
    for clip in source.glob("*.bvh"):
        (bare / clip.name).write_bytes(clip.read_bytes())
    done = run("evaluate", bare, "--from", graph, "--out", out, code=2)
    assert "no labels" in done.stderr and not out.exists()
    assert "is a folder" in run("evaluate", source, "--from", graph, "--out", tmp_path, code=2).stderr
