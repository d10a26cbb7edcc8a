"""``motionscape grammar`` and ``motionscape derive``, as a user meets them."""

from __future__ import annotations

import json

import pytest

from core.demo import make_demo
from core.grammar.learned import from_json
from core.mocap.bvh import read_bvh, write_bvh
from tests.webapp.cli.test_cli import run

QUICK = ("--terminals", "6", "--analysis-fps", "15")


@pytest.fixture(scope="module")
def recordings(tmp_path_factory):
    """Two short clips as BVH."""
    folder = tmp_path_factory.mktemp("recordings")
    for clip in make_demo(minutes=1, seed=2).clips[:2]:
        write_bvh(folder / f"{clip.name}.bvh", clip.cut(0, min(clip.n_frames, 600)))
    return folder


@pytest.fixture(scope="module")
def learned(recordings):
    """grammar.json of them, and what was printed."""
    out = recordings.parent / "grammar.json"
    return out, run("grammar", recordings, *QUICK, "--out", out).stdout


def test_grammar_writes_the_contract_s_fields(learned) -> None:
    path, printed = learned
    document = json.loads(path.read_text())
    assert document["format"] == "motionscape/grammar/1" and len(document["terminals"]) == 6
    assert set(document["bits"]) == {"grammar", "sentences", "total"} and set(document["objective"]) == set("FRE")
    assert all({"left", "right", "count"} == set(rule) for rule in document["rules"])
    assert all(0 <= terminal < 6 for sentence in document["sentences"] for terminal in sentence)
    assert "6 terminals" in printed and "rules" in printed and f"written to {path}" in printed


def test_derive_writes_a_sentence_of_the_grammar(recordings, learned, tmp_path) -> None:
    out, parts = tmp_path / "sentence.bvh", tmp_path / "sentence.json"
    options = ("--max-terminals", "5", "--seed", "4", "--parts", parts)
    printed = run("derive", recordings, "--from", learned[0], *options, "--out", out).stdout
    document = json.loads(parts.read_text())
    assert from_json(json.loads(learned[0].read_text())).grammar.accepts(document["terminals"])
    assert read_bvh(out).n_frames == document["frames"] and "foot skate" in printed
    code = next(line.split()[1] for line in printed.splitlines() if line.startswith("sentence:"))
    again = tmp_path / "again.bvh"
    run("derive", recordings, "--from", learned[0], "--sentence", code, "--seed", "4", "--quiet", "--out", again)
    assert again.read_bytes() == out.read_bytes()


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (("--out", "sentence.txt"), "names a BVH file"),
        (("--max-terminals", "0"), "1 to 1000"),
        (("--sentence", "9.9"), "no tree of this grammar"),
        (("--sentence", "x"), "expected rule indices"),
        (("--from", "README.md"), "not a file that"),
        (("--from", "nowhere.json"), "no such file"),
    ],
)
def test_derive_says_what_is_wrong(recordings, learned, tmp_path, change, words) -> None:
    arguments = {"--from": learned[0], "--out": tmp_path / "a.bvh"} | {change[0]: change[1]}
    flat = [part for pair in arguments.items() for part in pair]
    assert words in run("derive", recordings, *flat, code=2).stderr


def test_other_recordings_are_refused(recordings, learned, tmp_path) -> None:
    names = sorted(path.stem for path in recordings.glob("*.bvh"))
    out = ("--out", tmp_path / "a.bvh")
    one = run("derive", recordings, "--clips", names[0], "--from", learned[0], *out, code=2)
    assert f"“{names[1]}”" in one.stderr


def test_grammar_refuses_before_it_reads(tmp_path) -> None:
    assert (
        "from 0 to 1" in run("grammar", tmp_path / "none", "--weight", "3", "--out", tmp_path / "g.json", code=2).stderr
    )
