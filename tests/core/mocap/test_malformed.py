"""Every file of the collection of bad and odd inputs gets its verdict."""

from __future__ import annotations

import csv

import numpy as np
import pytest

from core.inspection import inspect_file
from core.mocap.asfamc import read_amc, read_asf
from core.mocap.bvh import read_bvh
from core.mocap.errors import RecordingError
from core.mocap.kinematics import joint_positions

# Rows of strictness "policy" where the other answer is chosen: what is there is clear, so it is read, and a warning
# says what was odd.
OTHER_VERDICT = {
    "utf16_le_bom.bvh": "the encoding is known",
    "utf16_le_bom.amc": "the encoding is known",
    "two_roots.bvh": "each skeleton is a clip",
    "motion_keyword_missing.bvh": "Frames: begins the motion as well",
    "truncated_mid_frame.bvh": "the whole frames are read",
    "truncated_mid_frame.amc": "the whole frames are read",
    "truncated_mid_number.amc": "the whole frames are read",
    "frame_time_zero.bvh": "30 frames a second, or as said",
    "frames_lie_more.bvh": "the frames that are there are read",
    "rows_after_end_garbage.bvh": "the text is left out",
    "limits_count.asf": "limits are not used",
}
# Their skeleton, by their names, is truncated.asf beside them, and not the one that is given.
OTHER_SKELETON = {"truncated_mid_frame.amc", "truncated_mid_number.amc"}
# Accepted, and inspection must say why one should look.
MUST_WARN = {"ok_large_offset_1e6.bvh"}


def _rows(folder):
    with (folder / "manifest.csv").open(newline="") as file:
        return list(csv.DictReader(file))


def _read(folder, row):
    path = folder / row["file"]
    if row["format"] == "asf":
        return read_asf(path)
    return read_amc(path, read_asf(folder / row["companion"])) if row["format"] == "amc" else read_bvh(path)


def test_every_file_of_the_manifest_gets_its_verdict(shared_data):
    folder = shared_data / "malformed"
    wrong = []
    for row in _rows(folder):
        expected = "ok" if row["file"] in OTHER_VERDICT else row["expected"]
        try:
            _read(folder, row)
            found, message = "ok", ""
        except RecordingError as error:
            found, message = "error", str(error)
        if found != expected:
            wrong.append(f"{row['file']}: {found} instead of {expected}: {row['problem']} {message}")
        elif message and (row["file"] not in message or "\n" in message or len(message) > 300):
            wrong.append(f"{row['file']}: message is no short line with the file's name: {message!r}")
    assert not wrong, "\n".join(wrong)


def test_every_file_of_the_manifest_can_be_inspected(shared_data):
    folder = shared_data / "malformed"
    for row in _rows(folder):
        report = inspect_file(folder / row["file"], skeleton=folder / row["companion"] if row["companion"] else None)
        warned = (MUST_WARN | OTHER_VERDICT.keys()) - OTHER_SKELETON
        expected = "warning" if row["file"] in warned else row["expected"]
        assert report.verdict == expected, report
        assert row["file"] not in OTHER_VERDICT or row["strictness"] == "policy"
        assert report.messages or report.verdict == "ok"


def test_faults_in_a_line_name_the_line(shared_data):
    lines = {
        "extra_value_in_row.bvh": 30,
        "value_hex.bvh": 30,
        "frames_not_integer.bvh": 26,
        "channels_count_lie.bvh": 9,
        "bad_axis_order.asf": 43,
    }
    for file, line in lines.items():
        with pytest.raises(RecordingError) as caught:
            (read_asf if file.endswith("asf") else read_bvh)(shared_data / "malformed" / file)
        assert caught.value.line == line
        assert str(caught.value).startswith(f"{file}:{line}: ")


def test_odd_but_good_files_equal_the_plain_ones(shared_data):
    folder = shared_data / "malformed"
    plain = joint_positions(read_bvh(folder / "ok_baseline.bvh"))
    for name in (
        "bom_utf8",
        "crlf",
        "cr_only",
        "mixed_eol",
        "tabs",
        "blank_lines",
        "trailing_spaces",
        "nonascii_names",
    ):
        np.testing.assert_array_equal(joint_positions(read_bvh(folder / f"ok_{name}.bvh")), plain, err_msg=name)
    everywhere = folder / "ok_positions_on_every_joint.bvh"
    if everywhere.exists():
        np.testing.assert_allclose(joint_positions(read_bvh(everywhere)), plain, atol=1e-6)
    asf = read_asf(folder / "ok_skeleton.asf")
    plain = joint_positions(read_amc(folder / "ok_motion.amc", asf))
    for name in ("crlf", "cr_only", "bom_utf8", "blank_lines", "extra_comments", "no_final_newline"):
        np.testing.assert_array_equal(joint_positions(read_amc(folder / f"ok_{name}.amc", asf)), plain, err_msg=name)
    radians = read_asf(folder / "ok_angle_rad.asf")
    np.testing.assert_allclose(joint_positions(read_amc(folder / "ok_motion.amc", radians)), plain, atol=1e-6)
