"""ASF and AMC: what is tolerated, what is refused and how."""

from __future__ import annotations

import gzip

import numpy as np
import pytest

from core.mocap.asfamc import read_amc, read_asf
from core.mocap.bvh import read_bvh, write_bvh
from core.mocap.errors import RecordingError
from core.mocap.kinematics import joint_positions
from tests.core.mocap import samples


def _asf(tmp_path, content: str | bytes = samples.ASF, name: str = "a.asf"):
    path = tmp_path / name
    path.write_bytes(content.encode() if isinstance(content, str) else content)
    return read_asf(path)


def _amc(tmp_path, content: str | bytes, asf=None, name: str = "a.amc", **options):
    path = tmp_path / name
    path.write_bytes(content.encode() if isinstance(content, str) else content)
    return read_amc(path, asf or _asf(tmp_path), **options)


def test_a_joint_is_the_start_of_a_bone(tmp_path):
    skeleton = _asf(tmp_path).skeleton
    assert skeleton.names == ("root", "hipjoint", "femur", "foot", "foot_end", "back", "back_end")
    assert skeleton.parents == (-1, 0, 1, 2, 3, 0, 5)
    assert [n for n, end in zip(skeleton.names, skeleton.end_sites, strict=True) if end] == ["foot_end", "back_end"]
    unit = 0.0254 / 0.45
    assert skeleton.unit == pytest.approx(unit)
    np.testing.assert_allclose(skeleton.offsets[:3], np.array([[0, 0, 0], [0, 0, 0], [1.2, -1.6, 0]]) * unit, atol=1e-6)
    np.testing.assert_allclose(skeleton.offsets[6], [0, 9 * unit, 0], atol=1e-6)


def test_a_plain_motion(tmp_path):
    clip = _amc(tmp_path, samples.AMC)
    assert (clip.name, clip.fps, clip.n_frames) == ("a", 120.0, 3)
    np.testing.assert_allclose(clip.root_positions[0], np.array([1, 17.1, 2]) * 0.0254 / 0.45, rtol=1e-6)
    assert _amc(tmp_path, samples.AMC, fps=60).fps == 60
    with pytest.raises(ValueError):
        _amc(tmp_path, samples.AMC, fps=0)


SAME = {
    "byte-order mark": lambda t: b"\xef\xbb\xbf" + t.encode(),
    "CRLF": lambda t: t.replace("\n", "\r\n").encode(),
    "CR": lambda t: t.replace("\n", "\r").encode(),
    "blank lines and tabs": lambda t: t.replace("\n", " \n\n\t").encode(),
    "comments": lambda t: t.replace("\n", "\n# a word\n").encode(),
    "no newline at the end": lambda t: t.rstrip("\n").encode(),
}


@pytest.mark.parametrize("how", SAME)
def test_odd_forms_of_the_same_files(tmp_path, how):
    plain = joint_positions(_amc(tmp_path, samples.AMC))
    asf = _asf(tmp_path, SAME[how](samples.ASF), "b.asf")
    np.testing.assert_array_equal(joint_positions(_amc(tmp_path, SAME[how](samples.AMC), asf, "b.amc")), plain)


def test_gzip(tmp_path):
    asf = _asf(tmp_path, gzip.compress(samples.ASF.encode()), "a.asf.gz")
    clip = _amc(tmp_path, gzip.compress(samples.AMC.encode()), asf, "a.amc.gz")
    np.testing.assert_array_equal(clip.rotations, _amc(tmp_path, samples.AMC).rotations)
    assert clip.name == "a"


def test_bones_may_come_in_any_order_and_frames_may_start_anywhere(tmp_path):
    plain = _amc(tmp_path, samples.AMC)
    lines = samples.AMC.split("\n")
    lines[10:13] = lines[12], lines[10], lines[11]
    assert lines != samples.AMC.split("\n")
    np.testing.assert_array_equal(_amc(tmp_path, "\n".join(lines)).rotations, plain.rotations)
    for k in (3, 2, 1):
        later = "\n".join(lines).replace(f"\n{k}\n", f"\n{k + 499}\n")
        lines = later.split("\n")
    np.testing.assert_array_equal(_amc(tmp_path, later).rotations, plain.rotations)


def test_radians(tmp_path):
    plain = joint_positions(_amc(tmp_path, samples.AMC))
    words = samples.ASF.replace("angle deg", "angle rad")
    for line in ("axis 10 -30 20", "axis -90 7.62852e-016 20"):
        angles = [repr(float(np.radians(float(w)))) for w in line.split()[1:]]
        words = words.replace(line, "axis " + " ".join(angles))
    np.testing.assert_allclose(joint_positions(_amc(tmp_path, samples.AMC, _asf(tmp_path, words))), plain, atol=1e-6)
    lines = samples.AMC.replace(":DEGREES", ":RADIANS").split("\n")
    for k, line in enumerate(lines):
        name, *values = line.split() or [""]
        keep = 3 if name == "root" else 0
        if values and name[0].isalpha():
            turned = [repr(float(np.radians(float(v)))) for v in values[keep:]]
            lines[k] = " ".join([name, *values[:keep], *turned])
    np.testing.assert_allclose(joint_positions(_amc(tmp_path, "\n".join(lines))), plain, atol=1e-6)


A, M = samples.ASF, samples.AMC
BAD_ASF = {
    "empty": ("", "empty"),
    "binary": (bytes(range(256)), "no text"),
    "BVH inside": (samples.BVH, "'HIERARCHY'"),
    "no bones": (A[: A.index(":bonedata")] + A[A.index(":hierarchy") :], ":bonedata"),
    "no hierarchy": (A[: A.index(":hierarchy")], ":hierarchy"),
    "circle": (A.replace("hipjoint femur\n    femur foot", "femur foot\n    foot femur"), "does not hang"),
    "own child": (A.replace("femur foot", "foot foot"), "'foot'"),
    "two parents": (A.replace("femur foot", "femur foot\n    back foot"), "two parents"),
    "unknown in the hierarchy": (A.replace("femur foot", "femur foot tail"), "'tail'"),
    "not in the hierarchy": (A.replace("    femur foot\n", ""), "'foot' does not hang"),
    "no length": (A.replace("     length 7.2\n", ""), "no length"),
    "no direction": (A.replace("     direction 0 0 1\n", ""), "no direction"),
    "no name": (A.replace("     name femur\n", ""), "without a name"),
    "name twice": (A.replace("name foot", "name femur"), "second bone"),
    "bad order": (A.replace("axis 10 -30 20 XYZ", "axis 10 -30 20 XYY"), "'XYY'"),
    "bad dof": (A.replace("dof rx rz", "dof rx rq"), "'rq'"),
    "dof twice": (A.replace("dof rx rz", "dof rx rx"), "twice"),
    "nan": (A.replace("length 7.2", "length nan"), "'nan'"),
    "negative": (A.replace("length 7.2", "length -7.2"), "-7.2"),
    "absurd": (A.replace("length 7.2", "length 1e300"), "out of range"),
    "direction of no length": (A.replace("direction 0 0 1", "direction 0 0 0"), "no direction"),
    "cut in a bone": (A[: A.index("dof rx rz")], "cut off"),
    "two numbers for a direction": (A.replace("direction 0 0 1", "direction 0 0"), "2 values"),
    "unit zero": (A.replace("length 0.45", "length 0"), "length unit"),
    "unit of angle": (A.replace("angle deg", "angle gon"), "'gon'"),
    "endless name": (A.replace("name femur", "name " + "x" * 100_000), "too long"),
}


@pytest.mark.parametrize("what", BAD_ASF)
def test_bad_skeletons_are_refused_in_one_line(tmp_path, what):
    content, words = BAD_ASF[what]
    with pytest.raises(RecordingError) as caught:
        _asf(tmp_path, content)
    message = str(caught.value)
    assert words in message and message.startswith("a.asf") and "\n" not in message and len(message) < 250


BAD_AMC = {
    "empty": ("", None, "empty"),
    "binary": (bytes(range(256)) * 9, 1, "no text"),
    "BVH inside": (samples.BVH, 1, "'HIERARCHY'"),
    "head only": (M[: M.index("1\n")], None, "no frames"),
    "unknown bone": (M.replace("back 4", "tail 4"), 11, "'tail' is not in a.asf"),
    "bone twice": (M.replace("foot 22 4", "back 4 5 6"), 13, "twice"),
    "bone missing": (M.replace("foot 22 4\n", ""), 9, "'foot'"),
    "too many values": (M.replace("foot 22 4", "foot 22 4 5"), 13, "3 values for 'foot'; expected 2"),
    "no values": (M.replace("foot 22 4", "foot"), 13, "0 values"),
    "endless line": (M.replace("foot 22 4", "foot" + " 1" * 100_000), 13, "100000 values"),
    "inf": (M.replace("22 4", "inf 4"), 9, "1 of 3 frames"),
    "overflow": (M.replace("22 4", "1e999 4"), 13, "'1e999'"),
    "text": (M.replace("22 4", "22 4x"), 13, "'4x'"),
    "number skipped": (M.replace("\n3\n", "\n4\n"), 14, "'4'; expected the frame number 3"),
    "number repeated": (M.replace("\n3\n", "\n2\n"), 14, "expected the frame number 3"),
    "number negative": (M.replace("\n1\n", "\n-1\n"), 4, "'-1'"),
    "number huge": (M.replace("\n2\n", "\n2000000000\n"), 9, "'2000000000'"),
    "number broken": (M.replace("\n2\n", "\n2.5\n"), 9, "'2.5'"),
    "two numbers": (M.replace("\n2\n", "\n2 2\n"), 9, "frame number"),
}


@pytest.mark.parametrize("what", BAD_AMC)
def test_bad_motions_are_refused_in_one_line(tmp_path, what):
    content, line, words = BAD_AMC[what]
    with pytest.raises(RecordingError) as caught:
        _amc(tmp_path, content)
    message = str(caught.value)
    assert words in message and message.startswith("a.amc") and "\n" not in message and len(message) < 250
    if line is not None:
        assert caught.value.line == line, message


def test_a_motion_for_another_skeleton_is_refused(tmp_path):
    text = samples.ASF.replace("dof rx rz\n    limits (-90.0 90.0)\n           (-90.0 90.0)", "dof rx")
    other = _asf(tmp_path, text)
    with pytest.raises(RecordingError, match=r"2 values for 'foot'; expected 1, as a\.asf says"):
        _amc(tmp_path, samples.AMC, other)


def test_every_cut_of_a_motion_is_read_whole_or_refused(tmp_path):
    asf = _asf(tmp_path)
    for end in range(len(M)):
        try:
            clip = _amc(tmp_path, M[:end], asf)
        except RecordingError:
            continue
        whole = M[:end].count("foot")
        assert clip.n_frames == whole or (clip.n_frames == whole - 1 and clip.findings[0].kind == "cut"), end


def test_the_order_of_axes_decides_the_order_of_rotations(tmp_path):
    """Axis order ZYX: about Z first, then Y, then X, all fixed; against plain matrices."""
    from tests.core.mocap.oracle import turn

    text = samples.ASF.replace("axis 10 -30 20 XYZ", "axis 10 -30 20 ZYX")
    clip = _amc(tmp_path, samples.AMC, _asf(tmp_path, text))
    # values of an axis stand in the order x y z, whatever the order of rotation
    c = turn("X", 10) @ turn("Y", -30) @ turn("Z", 20)
    local = c @ turn("X", -10) @ turn("Y", 5) @ turn("Z", 15) @ np.linalg.inv(c)
    w, x, y, z = clip.rotations[0, clip.skeleton.index("femur")].astype(float)
    first = [1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)]
    last = [2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)]
    np.testing.assert_allclose(local[:3, 0], first, atol=1e-6)
    np.testing.assert_allclose(local[:3, 2], last, atol=1e-6)


def test_a_motion_written_as_bvh_reads_back(tmp_path):
    clip = _amc(tmp_path, samples.AMC)
    write_bvh(tmp_path / "a.bvh", clip)
    back = read_bvh(tmp_path / "a.bvh", unit=clip.skeleton.unit)
    assert back.skeleton.names == clip.skeleton.names
    np.testing.assert_allclose(joint_positions(back), joint_positions(clip), atol=1e-5)


def test_a_real_motion_written_as_bvh_reads_back(tmp_path, shared_data):
    folder = shared_data / "cmu/asfamc"
    clip = read_amc(folder / "02/02_03.amc", read_asf(folder / "02/02.asf"))
    write_bvh(tmp_path / "a.bvh", clip)
    back = read_bvh(tmp_path / "a.bvh")
    assert back.skeleton == clip.skeleton
    np.testing.assert_allclose(joint_positions(back), joint_positions(clip), atol=1e-4)
