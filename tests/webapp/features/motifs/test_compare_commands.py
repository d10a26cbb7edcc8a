"""The commands compare and stability, from files to files."""

from __future__ import annotations

import json

import pytest

from core.mocap.bvh import write_bvh
from tests.core.motifs.recordings import recurring
from tests.webapp.cli.test_cli import run


@pytest.fixture(scope="module")
def recordings(tmp_path_factory):
    folder = tmp_path_factory.mktemp("recurring")
    for clip in recurring().clips:
        write_bvh(folder / f"{clip.name}.bvh", clip)
    return folder


def test_two_results_are_compared(recordings, tmp_path):
    settings = ["--min-letters", 3, "--quiet"]
    for name, kappa in (("a", 60), ("b", 30)):
        run("motifs", recordings, "--kappa", kappa, *settings, "--out", tmp_path / f"{name}.json")
    said = run("compare", tmp_path / "a.json", tmp_path / "b.json", "--out", tmp_path / "c.json").stdout.splitlines()
    found = json.loads((tmp_path / "c.json").read_text())
    assert found["format"] == "motionscape/comparison/1"
    assert len(said) == len(found["first"]) + sum(f["change"] == "gained" for f in found["second"]) + 2
    assert "motifs are kept in the other result" in said[-2] and said[-1].startswith("adjusted Rand index 0.")
    assert run("compare", tmp_path / "a.json", tmp_path / "a.json", "--quiet").stdout == ""


def test_what_cannot_be_compared_is_said(recordings, tmp_path):
    run("motifs", recordings, "--kappa", 60, "--quiet", "--out", tmp_path / "a.json")
    run("motifs", recordings, "--kappa", 60, "--quiet", "--clips", "clip0", "--out", tmp_path / "part.json")
    (tmp_path / "text.json").write_text("motifs")
    (tmp_path / "other.json").write_text("{}")
    for second, words in (
        ("part.json", "different recordings"),
        ("text.json", "not a file that “motionscape motifs” wrote"),
        ("other.json", "not a motif graph"),
        ("none.json", "no such file"),
    ):
        assert words in run("compare", tmp_path / "a.json", tmp_path / second, code=2).stderr
    assert "is a folder" in run("compare", tmp_path / "a.json", tmp_path / "a.json", "--out", tmp_path, code=2).stderr


def test_stability_is_measured_from_files(recordings, tmp_path):
    settings = ["--kappa", 60, "--min-letters", 3, "--repetitions", 1, "--noise-degrees", 1]
    said = run("stability", recordings, *settings, "--out", tmp_path / "s.json").stdout
    found = json.loads((tmp_path / "s.json").read_text())
    assert [r["name"] for r in found["repeats"]] == [
        "noise 1", "seed 1", "kappa 48", "kappa 75", "rho 0.8", "rho 1.25", "gamma 1.4", "gamma 1.6",
    ]  # fmt: skip
    assert f"{len(found['motifs'])} motifs, mean stability 0." in said and found["parameters"]["noise_degrees"] == 1
    assert "noise_low" in run("stability", recordings, "--noise-low", 9, "--out", tmp_path / "t.json", code=2).stderr
    assert not (tmp_path / "t.json").exists()
