"""Files as people really have them: each is read, or refused, as the manifest says."""

from __future__ import annotations

import csv

import pytest

from core.inspection import inspect_file

# What the message must say, by the letter and number in front of a file's name.
WORDS = {
    "A1": "5 frames where .* says 3",
    "A2": "1 frame where .* says 1048",
    "A3": "41 frames where .* says 40",
    "A4": "39 frames where .* says 40",
    "B1": "displacements, added to OFFSET",
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
        return {row["file"]: inspect_file(folder / row["file"]) for row in csv.DictReader(file)}


def test_all_but_skeletons_without_motion_are_read(reports):
    refused = {name for name, report in reports.items() if report.verdict == "error"}
    assert refused == {"J1_frames_0_real.bvh", "J2_no_motion_real.bvh"}


@pytest.mark.parametrize("kind", WORDS)
def test_what_is_odd_is_said(reports, kind):
    import re

    (report,) = (report for name, report in reports.items() if name.startswith(f"{kind}_"))
    assert any(re.search(WORDS[kind], message) for message in report.messages), report.messages
