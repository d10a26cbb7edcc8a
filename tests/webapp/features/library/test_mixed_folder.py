"""A mixed folder by command: imported in one go, and every analysis runs on it among bodies that can be compared."""

from __future__ import annotations

import json

import pytest

from core.inspection import facts_of
from core.mocap.anatomy import find_anatomy
from core.workspace import Workspace
from tests.core.mocap.dialects import DIALECTS
from tests.core.mocap.mixed_folder import ANIMALS, PEOPLE, mixed_folder
from webapp.cli.main import main


@pytest.fixture(scope="module")
def source(tmp_path_factory):
    """WORKSPACE/mixed, imported by command."""
    folder = mixed_folder(tmp_path_factory.mktemp("mixed") / "files")
    space = folder.parent / "space"
    assert main(["import", str(space), str(folder), "--name", "mixed", "--quiet"]) == 0
    return f"{space}/mixed"


def test_everything_is_read_upright_and_in_metres(source):
    dataset = Workspace(source.rpartition("/")[0]).open("mixed")
    facts = {clip.name: facts_of(clip) for clip in dataset.clips}
    assert len(facts) == len(PEOPLE) + len(ANIMALS) + 2
    for name, (dialect, _) in PEOPLE.items():
        assert facts[name].up == DIALECTS[dialect].up and 1.6 < facts[name].height < 1.8
    assert (facts["walk"].up, facts["walk with Z up"].up) == ("y", "z")
    bodies = {clip.name: find_anatomy(clip.skeleton).body for clip in dataset.clips}
    assert {name for name, body in bodies.items() if body == "other"} == set(ANIMALS)


@pytest.mark.parametrize(
    ("method", "options"), [("motifs", []), ("map", ["--grid", "7x7"]), ("grammar", ["--terminals", "3"])]
)
def test_motifs_map_and_grammar_take_the_people_and_say_so(source, tmp_path, capsys, method, options):
    out = tmp_path / "out.json"
    assert main([method, source, *options, "--out", str(out)]) == 0
    said = capsys.readouterr().err
    assert "3 clips left out" in said and "rex" in said and "web" in said
    text = out.read_text()
    assert json.loads(text)["format"].startswith("motionscape/") and '"walk' in text
    assert (
        main([method, source, *options, "--clips", "rex,rover", "--out", str(out), "--quiet"]) == 0
    )  # among their kind


def test_the_turned_copy_of_a_walk_is_its_first_hit(source, tmp_path):
    out = tmp_path / "hits.json"
    assert main(["search", source, "--query", "walk", "--out", str(out), "--quiet"]) == 0
    first, *others = json.loads(out.read_text())["queries"]["walk"]["hits"]
    assert first["clip"] == "walk with Z up" and first["score"] == pytest.approx(1, abs=1e-3)
    assert not {hit["clip"] for hit in others} & set(ANIMALS)
    assert main(["search", source, "--query", "rex", "--out", str(out), "--quiet"]) == 0
    assert {hit["clip"] for hit in json.loads(out.read_text())["queries"]["rex"]["hits"]} == {"rover"}
