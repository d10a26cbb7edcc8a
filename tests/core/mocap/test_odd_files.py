"""Recordings as people have them: odd in ways that leave no doubt what is meant; each is made from a plain one."""

from __future__ import annotations

import re

import numpy as np
import pytest

from core.mocap.asfamc import read_amc, read_asf
from core.mocap.bvh import read_bvh, read_bvh_clips
from core.mocap.dataset import open_dataset
from core.mocap.errors import RecordingError
from core.mocap.kinematics import joint_positions
from tests.core.mocap import samples

N = 30  # frames


def _long_bvh(n: int = N) -> str:
    """samples.BVH with more frames, the chest turning all the while."""
    head = samples.BVH[: samples.BVH.index("MOTION")]
    rows = [f"0.5 {90 + k} {2 * k}.25 {6 * k % 360 - 180}.5 -2 0.5 {3 * k}.75 0.0 0.25 -4 {k} 0" for k in range(n)]
    return head + f"MOTION\nFrames: {n}\nFrame Time: 0.0333333\n" + "\n".join(rows) + "\n"


L = _long_bvh()
HEAD, ROWS = L[: L.index("0.5 90")], L[L.index("0.5 90") :]


def _read(tmp_path, content: str | bytes, **options):
    path = tmp_path / "a.bvh"
    path.write_bytes(content.encode() if isinstance(content, str) else content)
    return read_bvh(path, **options)


SAME = {  # reads as if nothing were odd
    "rows on one line": HEAD + ROWS.replace("\n", " ") + "\n",
    "rows of two lines": HEAD + re.sub(r"( \S+){6}\n", lambda m: "\n" + m.group().strip() + "\n", ROWS),
    "numbers over any lines": HEAD + re.sub(r"((?:\S+ ){7}\S+) ", r"\1\n", ROWS.replace("\n", " ")) + "\n",
    "motion head on one line": L.replace("MOTION\nFrames: 30\nFrame", "MOTION Frames: 30 Frame"),
    "head in another order": L.replace("Frames: 30\nFrame Time: 0.0333333\n", "Frame Time: 0.0333333\nFrames: 30\n"),
    "labels without spaces": L.replace("Frames: 30\nFrame Time: ", "FRAMES:30\nFrameTime:"),
    "frames with a point": L.replace("Frames: 30", "Frames: 30.0"),
    "everything on one line": " ".join(L.split()),
    "channels over two lines": L.replace("Zposition Zrot", "Zposition\n      Zrot"),
    "name on the next line": L.replace("JOINT Chest", "JOINT\n\n   Chest"),
    "offset over two lines": L.replace("OFFSET 0 20 0", "OFFSET 0\n 20 0"),
    "comments": "# made by\n// 2024 { not a brace\n" + L.replace("OFFSET 0 20 0", "OFFSET 0 20 0 # chest"),
    "comments among the rows": L.replace("\n0.5 95", "\n# a remark\n0.5 95"),
    "EndSite": L.replace("End Site", "EndSite"),
    "End Site with a number": L.replace("End Site", "End Site7"),
    "END_SITE": L.replace("End Site", "END_SITE"),
    "small letters": L.replace("HIERARCHY", "hierarchy").replace("ROOT", "root").replace("JOINT", "Joint"),
    "short channel names": re.sub(r"([XYZ])(pos|rot)\w+", r"\1\2", L),
    "keyword and number joined": L.replace("OFFSET 9 -4", "OFFSET+9 -4").replace("CHANNELS 3", "CHANNELS3", 1),
    "braces on the line": L.replace("\n{", " {").replace("\n  {", "{"),
    "decimal commas": L.replace(".", ",").replace("0,0333333", "0.0333333"),
    "decimal commas everywhere": L.replace(".", ","),
    "commas between numbers": HEAD + "\n".join(",".join(row.split()) for row in ROWS.strip().split("\n")) + "\n",
}

NOTED = {  # reads the same, and says what was odd: the kind of the finding, words of its message
    "UTF-16": (L.encode("utf-16"), "encoding", "UTF-16"),
    "UTF-16 without a mark": (L.encode("utf-16-be"), "encoding", "UTF-16"),
    "no MOTION": (L.replace("MOTION\n", ""), "head", "MOTION is missing"),
    "more rows than said": (L.replace("Frames: 30", "Frames: 3"), "frames", "30 frames .* says 3"),
    "fewer rows than said": (L.replace("Frames: 30", "Frames: 900000000000"), "frames", "30 frames .* says 9000"),
    "said to have none": (L.replace("Frames: 30", "Frames: 0"), "frames", "says 0"),
    "text after the frames": (L + "; THE END 1 2 3\nand more\n", "text", "line 58"),
    "glued numbers": (L.replace("5 -2 0.5", "5-2 0.5"), "glued", "frame 0 and 29 more"),
    "time is zero": (L.replace("0.0333333", "0"), "rate", "30 frames per second"),
}


@pytest.mark.parametrize("what", SAME)
def test_odd_ways_to_write_a_recording_change_nothing(tmp_path, what):
    plain, odd = _read(tmp_path, L), _read(tmp_path, SAME[what])
    assert SAME[what] != L and not odd.findings
    assert odd.skeleton == plain.skeleton and odd.fps == plain.fps
    np.testing.assert_array_equal(joint_positions(odd), joint_positions(plain))


@pytest.mark.parametrize("what", NOTED)
def test_what_is_clear_is_read_and_said(tmp_path, what):
    content, kind, words = NOTED[what]
    plain, odd = _read(tmp_path, L), _read(tmp_path, content)
    assert content != L and [finding.kind for finding in odd.findings] == [kind]
    assert re.search(words, odd.findings[0].message)
    assert odd.skeleton == plain.skeleton and odd.fps == plain.fps
    np.testing.assert_array_equal(joint_positions(odd), joint_positions(plain))


ROW_9 = ROWS.split("\n")[9]
LOST = {
    "nan": ROW_9.replace("-2", "nan"),
    "a C library's nan": ROW_9.replace("-2", "-1.#IND"),
    "infinity": ROW_9.replace("-2", "-Infinity"),
    "null": ROW_9.replace("-2", "null"),
    "a number missing": ROW_9.replace(" -2", ""),
    "a number too many": ROW_9 + " 7",
}


@pytest.mark.parametrize("what", LOST)
def test_a_damaged_row_is_filled_from_its_neighbours_and_marked(tmp_path, what):
    content = L.replace(ROW_9, LOST[what])
    plain, odd = _read(tmp_path, L), _read(tmp_path, content)
    (finding,) = odd.findings
    assert (finding.kind, finding.start, finding.end) == ("filled", 9, 10)
    assert "line 37" in finding.message
    others = np.arange(N) != 9
    np.testing.assert_array_equal(odd.rotations[others], plain.rotations[others])
    # the motion is even, so the middle of the neighbours is where the frame was; the chest passes -180 degrees unharmed
    np.testing.assert_allclose(joint_positions(odd)[9], joint_positions(plain)[9], atol=2e-3)


def test_frames_at_either_end_repeat_the_nearest_and_runs_are_one_finding(tmp_path):
    rows = ROWS.strip().split("\n")
    rows[:2] = [row.replace("-2", "nan") for row in rows[:2]]
    rows[-1] = rows[-1].replace("-2", "nan")
    odd = _read(tmp_path, HEAD + "\n".join(rows))
    assert [(f.start, f.end) for f in odd.findings] == [(0, 2), (29, 30)]
    positions = joint_positions(odd)
    np.testing.assert_array_equal(positions[0], positions[2])
    np.testing.assert_array_equal(positions[29], positions[28])


def test_a_flip_through_half_a_turn_is_filled_the_short_way(tmp_path):
    rows = ROWS.strip().split("\n")
    turned = [row.split() for row in rows]
    for k, row in enumerate(turned):
        row[3] = str((170 + k * 2.5 + 180) % 360 - 180)  # over 180 degrees after four frames
    turned[4][4] = "nan"
    odd = _read(tmp_path, HEAD + "\n".join(" ".join(row) for row in turned))
    turned[4][4] = "-2"
    plain = _read(tmp_path, HEAD + "\n".join(" ".join(row) for row in turned))
    assert np.abs((odd.rotations[4, 0] * plain.rotations[4, 0]).sum()) > 1 - 1e-5


def test_semicolons_between_numbers_with_points_or_commas(tmp_path):
    plain = _read(tmp_path, HEAD + ROWS)
    for rows in (ROWS.replace(" ", ";"), ROWS.replace(".", ",").replace(" ", ";")):
        odd = _read(tmp_path, HEAD + rows)
        np.testing.assert_array_equal(joint_positions(odd), joint_positions(plain))
        assert any("semicolons" in note for note in odd.notes)


def test_too_many_damaged_rows_are_refused(tmp_path):
    rows = ROWS.strip().split("\n")
    rows[::4] = [row.replace("-2", "nan") for row in rows[::4]]
    with pytest.raises(RecordingError, match="8 of 30 frames are damaged, the first is frame 0: 'nan'"):
        _read(tmp_path, HEAD + "\n".join(rows))
    with pytest.raises(RecordingError, match="a frame of 13 numbers; expected 12"):
        _read(tmp_path, HEAD + ROWS.replace("\n", " 1\n"))
    nothing = " ".join(["nan"] * 12) + "\n"
    with pytest.raises(RecordingError, match="1 of 1 frames are damaged, the first is frame 0: 'nan'"):
        _read(tmp_path, HEAD + nothing)
    with pytest.raises(RecordingError, match="more than 20% of the frames are damaged, the first is frame 30: 'nan'"):
        _read(tmp_path, HEAD + ROWS.rstrip("\n") + "\n" + nothing * 50)
    lead_in = _read(tmp_path, HEAD + nothing * 30 + ROWS.rstrip("\n") + ("\n" + rows[1]) * 100)  # lost in the beginning
    assert next((f.start, f.end) for f in lead_in.findings if f.kind == "filled") == (0, 30)


@pytest.mark.parametrize("end", [-3, -12, -40])
def test_a_cut_last_row_is_left_out(tmp_path, end):
    odd = _read(tmp_path, L.rstrip()[:end])
    assert odd.n_frames == N - 1 and [f.kind for f in odd.findings] == ["cut", "frames"]
    np.testing.assert_array_equal(odd.rotations, _read(tmp_path, L).rotations[: odd.n_frames])


def test_a_decimal_comma_among_points_is_named(tmp_path):
    with pytest.raises(RecordingError, match="decimal comma"):
        _read(tmp_path, L.replace("2.25", "2,25", 1))


def test_a_skeleton_without_motion_is_called_that(tmp_path):
    for text in (L[: L.index("MOTION")], L[: L.index("Frames")], HEAD, HEAD.replace("Frames: 30", "Frames: 0")):
        with pytest.raises(RecordingError, match="a skeleton without motion"):
            _read(tmp_path, text)


def test_a_rate_that_is_given_stands_in_for_the_files(tmp_path):
    for text in (L, L.replace("0.0333333", "0"), L.replace("Frame Time: 0.0333333\n", "")):
        clip = _read(tmp_path, text, fps=50.0)
        assert clip.fps == 50 and not clip.findings


def test_scale_channels_are_left_out(tmp_path):
    text = L.replace("CHANNELS 6", "CHANNELS 9").replace(
        "Zposition Zrotation Xrotation Yrotation", "Zposition Xscale Zrotation Yscale Xrotation Yrotation Zscale"
    )
    rows = [row.split() for row in ROWS.strip().split("\n")]
    scaled = [[*row[:3], "1", row[3], "1.1", *row[4:6], "0.9", *row[6:]] for row in rows]
    odd = _read(tmp_path, text[: text.index("0.5 90")] + "\n".join(map(" ".join, scaled)))
    assert any("scale channels of Hips" in note for note in odd.notes)
    np.testing.assert_array_equal(joint_positions(odd), joint_positions(_read(tmp_path, L)))


def test_several_roots_are_several_clips(tmp_path):
    prop = "ROOT Ball\n{\nOFFSET 0 0 0\nCHANNELS 3 Xposition Yposition Zposition\nEnd Site\n{\nOFFSET 0 10 0\n}\n}\n"
    head = HEAD.replace("MOTION", prop + "MOTION")
    rows = [f"{row} {k} 5 0" for k, row in enumerate(ROWS.strip().split("\n"))]
    path = tmp_path / "a.bvh"
    path.write_text(head + "\n".join(rows))
    person, ball = read_bvh_clips(path)
    assert (person.name, ball.name) == ("a", "a Ball")
    assert person.findings[0].kind == ball.findings[0].kind == "roots"
    np.testing.assert_array_equal(joint_positions(person), joint_positions(_read(tmp_path, L)))
    np.testing.assert_allclose(ball.root_positions[:, 0] / ball.skeleton.unit, np.arange(N), rtol=1e-6)
    path.write_text(head + "\n".join(rows))
    assert open_dataset(path).names == ("a", "a Ball")


def test_positions_that_are_displacements_are_added_to_offset(tmp_path):
    """All joints have position channels that stay at 0: a body in one point, or displacements."""
    bones = "".join(
        f"JOINT j{k}\n{{\nOFFSET {k} 10 0\nCHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation\n"
        for k in range(1, 5)
    )
    root = "HIERARCHY\nROOT Hips\n{\nOFFSET 0 90 0\nCHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation "
    head = root + "Yrotation\n" + bones + "}\n" * 5 + "MOTION\nFrames: 4\nFrame Time: .1\n"

    def rows(*places: str) -> str:
        return "".join(
            " ".join(["0 1 0 0 0 0", *(f"{place} 0 {10 * k} 0" for place in places)]) + "\n" for k in range(4)
        )

    odd = _read(tmp_path, head + rows("0 0 0", "0 0 0.01", "0 0 0", "0 0 0"))
    assert [f.kind for f in odd.findings][:1] == ["displacements"]
    plain = _read(tmp_path, head + rows("1 10 0", "2 10 0.01", "3 10 0", "4 10 0"))
    assert "displacements" not in [f.kind for f in plain.findings]
    np.testing.assert_allclose(odd.skeleton.offsets, plain.skeleton.offsets, atol=1e-6)
    np.testing.assert_allclose(odd.root_positions[0, 1] / odd.skeleton.unit, 91, rtol=1e-5)


SIX = "CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation"


@pytest.mark.parametrize(
    ("movement", "added"),
    [
        ([[0, 0, 0], [0, 0, 0]], True),  # two joints alone have position channels
        ([[3, 0, 0], [0, 2, 0]], True),  # stretched for a while, by more than a tenth of the bone
        ([[0, 20, 0], [9, -4, 0]], False),  # OFFSET once more
        ([[0, 24, 0], [9, -3, 1]], False),  # places that move
    ],
)
def test_displacements_of_some_joints_are_told_from_places(tmp_path, movement, added):
    head = HEAD.replace("CHANNELS 3 Zrotation Xrotation Yrotation", SIX, 1)
    head = head.replace("CHANNELS 3 Yrotation Xrotation Zrotation", SIX, 1)
    rows = []
    for k in range(N):
        chest, leg = ([value * (k % 3 == 0) for value in place] if added else place for place in movement)
        rows.append(" ".join(map(str, [0, 90, k, 0, 0, 0, *chest, 0, 0, 0, *leg, 0, 0, 0])))
    clip = _read(tmp_path, head + "\n".join(rows) + "\n")
    assert ("displacements" in {finding.kind for finding in clip.findings}) == added
    heights = joint_positions(clip)[1] / clip.skeleton.unit
    where = dict(zip(clip.skeleton.names, heights - heights[0], strict=True))
    np.testing.assert_allclose(where["LeftLeg"], [9, -4, 0] if added else movement[1], atol=1e-3)


A, M = samples.ASF, samples.AMC


def _long_amc(n: int = 20) -> str:
    head, frame = M[: M.index("1\n")], M[M.index("1\n") + 2 : M.index("\n2\n") + 1]
    return head + "".join(f"{k + 1}\n{frame}" for k in range(n))


def _amc(tmp_path, asf: str = A, amc: str = ""):
    (tmp_path / "a.asf").write_text(asf)
    (tmp_path / "a_01.amc").write_text(amc or _long_amc())
    return read_amc(tmp_path / "a_01.amc", read_asf(tmp_path / "a.asf"))


ODD_ACCLAIM = {  # skeleton, motion, kind of the finding or None
    "units on one line": (re.sub(r":units\s+mass (\S+)\s+length (\S+)", r":units mass \1 length \2", A), "", None),
    "comment behind a value": (A.replace("length 7.2", "length 7.2 # cm"), "", None),
    "capitals": (A.upper(), _long_amc().upper(), None),
    "capitals in the motion": (A, _long_amc().upper(), None),
    "capitals in the hierarchy": (A[: A.index(":hier")] + A[A.index(":hier") :].upper(), "", None),
    "too few limits": (A.replace("           (-90.0 90.0)\n", "", 1), "", "limits"),
    "direction rounded": (A.replace("direction 0 0 1", "direction 0 0 0.9"), "", "direction"),
    "an unknown word": (A.replace("length 7.2", "length 7.2\n     colour red"), "", None),
    "a bone more in the motion": (A, _long_amc().replace("foot", "tail 1 2\nfoot"), "extra"),
    "a bone that may stretch": (A.replace("dof rx rz", "dof rx rz l"), "", "dof"),
}


@pytest.mark.parametrize("what", ODD_ACCLAIM)
def test_odd_ways_to_write_acclaim_change_nothing(tmp_path, what):
    asf, amc, kind = ODD_ACCLAIM[what]
    plain, odd = _amc(tmp_path), _amc(tmp_path, asf, amc)
    assert (asf, amc) != (A, "") and [finding.kind for finding in odd.findings] == ([kind] if kind else [])
    assert [name.lower() for name in odd.skeleton.names] == list(plain.skeleton.names)
    np.testing.assert_allclose(joint_positions(odd), joint_positions(plain), atol=1e-6)


def test_a_bone_that_a_frame_lacks_is_held(tmp_path):
    text = _long_amc().replace("\n8\n", "\n8\n#")  # comments the first line of frame 8: its root
    moved = text.replace("\n7\nroot 0", "\n7\nroot 5")
    odd = _amc(tmp_path, amc=moved)
    (finding,) = odd.findings
    assert (finding.kind, finding.start, finding.end) == ("filled", 7, 8) and "'root'" in finding.message
    np.testing.assert_array_equal(odd.root_positions[7], odd.root_positions[6])


def test_a_bone_that_no_frame_has_stays_unturned(tmp_path):
    odd = _amc(tmp_path, amc=re.sub(r"foot .*\n", "", _long_amc()))
    assert odd.findings[0].kind == "missing" and odd.n_frames == 20


@pytest.mark.parametrize("end", [-10, -14, -20])
def test_a_motion_cut_in_its_last_frame_loses_that_frame(tmp_path, end):
    odd = _amc(tmp_path, amc=_long_amc().rstrip()[:end])
    assert odd.n_frames == 19 and [f.kind for f in odd.findings] == ["cut"]


def test_values_that_are_none_are_filled(tmp_path):
    lines = _long_amc().split("\n")
    at = lines.index("9") + 1
    lines[at] = lines[at].replace("17.1", "nan")
    odd = _amc(tmp_path, amc="\n".join(lines))
    assert [(f.kind, f.start, f.end) for f in odd.findings] == [("filled", 8, 9)]
    assert np.isfinite(joint_positions(odd)).all()
