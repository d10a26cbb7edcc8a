"""Files as people really have them: each is read, or refused, as the manifest says."""

from __future__ import annotations

import csv
import json
import re
from pathlib import Path

import pytest

from core.inspection import inspect_recording
from webapp.cli.main import main

# What the message must say, by the letter and number in front of a file's name.
WORDS = {
    "A1": "5 frames where .* says 3",
    "A2": "1 frame where .* says 1048",
    "A3": "41 frames where .* says 40",
    "A4": "39 frames where .* says 40",
    "B1": "displacements, added to OFFSET",
    "C1": "Z points up",
    "C2": "1.15 m tall in inches .* it would be 2.57 m",
    "E1": "no human body",
    "E2": "no human body",
    "E3": "no human body",
    "E4": "no legs",
    "F1": "left and right seem swapped",
    "G1": "numbers without a space",
    "G2": "frame 5 is filled",
    "G4": "decimal comma",
    "H8": "MOTION is missing",
    "H10": "text after the frames",
    "I4": "scale channels",
    "I6": "2 skeletons in one file",
    "I7": "UTF-16",
    "I9": "30 frames per second",
    "J1": "a skeleton without motion",
    "J2": "a skeleton without motion",
    "K_a01": "held from the frame before",
    "K_a05": "limits are not used",
    "K_a07": "no unit vector",
    "K_a09": "left out",
    "K_a10": "'lfingers': not in",
    "K_a19": "cut off",
}


@pytest.fixture(scope="module")
def reports(shared_data):
    folder = shared_data / "wild"
    with (folder / "manifest.csv").open(newline="") as file:
        return {row["file"]: inspect_recording(folder / row["file"]) for row in csv.DictReader(file)}


# What was read, by the beginning of the name: unit, way up, height in metres (within 2 cm), body.
FACTS = {
    "B1": ("dm", "z", 1.77, "human"),
    "C0": ("cm", "y", 1.70, "human"),
    "C1": ("cm", "z", 1.70, "human"),
    "C2": ("in", "z", 1.16, "human"),
    "C3": ("dm", "z", 1.60, "human"),
    "E1": (None, "y", None, "other"),
    "E2": (None, "y", None, "other"),
    "E3": (None, "y", None, "other"),
    "E4": ("cm", "y", None, "partial"),
    "F1": ("cm", "y", 1.70, "human"),
    "I6": ("cm", "y", 1.70, "human"),
    "K_a13": ("cmu", "y", 1.43, "human"),
}


@pytest.mark.parametrize("kind", FACTS)
def test_size_way_up_and_body(reports, kind):
    ((_, facts),) = (entry for name, entry in reports.items() if name.startswith(f"{kind}_"))
    unit, up, height, body = FACTS[kind]
    assert (facts.up, facts.body) == (up, body)
    assert unit is None or facts.unit == unit
    assert height is None or facts.height == pytest.approx(height, abs=0.02)
    assert (body == "other") == (list(facts.joints) == ["pelvis"])


# Verdict, frames and frames per second of every file, by the letter and number in front of its name; 40 frames at 30
# and the verdict "warning" where nothing is said.
READ = {
    "A1": ("warning", 5, 30),
    "A2": ("warning", 1, 10 / 3),
    "A3": ("warning", 41, 30),
    "A4": ("warning", 39, 30),
    "B1": ("warning", 1, 24),
    "C0": ("ok", 40, 30),
    "C1": ("ok", 40, 30),
    "C2": ("warning", 5, 30),
    "C3": ("ok", 14, 24),
    "E1": ("warning", 4, 30),
    "E2": ("warning", 4, 30),
    "E3": ("warning", 1, 25),
    "G4": ("ok", 40, 30),
    "H1": ("ok", 40, 30),
    "H3": ("ok", 40, 30),
    "H4": ("ok", 40, 30),
    "H6": ("ok", 40, 30),
    "H8": ("warning", 3, 30),
    "H9": ("ok", 40, 30),
    "I1": ("ok", 40, 30),
    "I2": ("ok", 3, 24),
    "I4": ("ok", 40, 30),
    "K_a13": ("ok", 20, 120),
    "K_a14": ("ok", 20, 120),
    "K_a16": ("ok", 20, 120),
    "K_a19": ("warning", 19, 120),
}


def test_every_row_of_the_manifest_agrees(shared_data, capsys):
    """As ``motionscape inspect --json`` gives them."""
    folder = shared_data / "wild"
    assert main(["inspect", "--json", "--quiet", str(folder)]) == 2
    files = {
        Path(entry["path"]).relative_to(folder).as_posix(): entry
        for entry in json.loads(capsys.readouterr().out)["files"]
    }
    with (folder / "manifest.csv").open(newline="") as file:
        rows = [row["file"] for row in csv.DictReader(file)]
    assert len(rows) == 41
    wrong = []
    for name in rows:
        entry, kind = files[name], re.match(r"(K_)?[A-Za-z]\d+", name).group()
        if kind in ("J1", "J2"):
            expected = ("error", None, None)
        else:
            expected = READ.get(kind, ("warning", 20, 120) if kind.startswith("K") else ("warning", 40, 30))
        unit, up, height, body = FACTS.get(kind, (None, "y" if kind != "A2" else "-y", None, "human"))
        found = (entry["verdict"], entry.get("frames"), entry.get("fps"))
        if found[:2] != expected[:2] or (found[2] or 0) != pytest.approx(expected[2] or 0, rel=1e-3):
            wrong.append((name, expected, found))
        if expected[1] and ((entry["up"], entry["body"]) != (up, body) or (unit and entry["unit"] != unit)):
            wrong.append((name, (unit, up, body), (entry["unit"], entry["up"], entry["body"])))
        if height and entry["height"] != pytest.approx(height, abs=0.02):
            wrong.append((name, height, entry["height"]))
    assert not wrong


def test_all_but_skeletons_without_motion_are_read(reports):
    refused = {name for name, (report, _) in reports.items() if report.verdict == "error"}
    assert refused == {"J1_frames_0_real.bvh", "J2_no_motion_real.bvh"}


@pytest.mark.parametrize("kind", WORDS)
def test_what_is_odd_is_said(reports, kind):
    ((report, _),) = (entry for name, entry in reports.items() if name.startswith(f"{kind}_"))
    assert any(re.search(WORDS[kind], message) for message in report.messages), report.messages
