"""Damaged files: every reader refuses them in its own words or reads them. benchmarks/fuzz_readers.py tries many."""

from __future__ import annotations

import random

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from benchmarks.fuzz_readers import BVH, Readers, mutated, read_one
from core.errors import MotionscapeError
from core.mocap.bvh import read_bvh_clips
from core.mocap.number_words import numbers_in

POINTS = (".c3d", ".glb", ".mot", ".mvnx", ".trc", ".csv", ".txt", ".json", ".npy", ".npz")
FORMATS = (".bvh", ".bvh.gz", ".asf", ".amc", "_inspected.bvh", "_labels.csv", "_body.json", ".zip", *POINTS)
FEW = settings(max_examples=40, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])


@pytest.fixture(scope="module")
def readers(tmp_path_factory):
    return Readers(tmp_path_factory.mktemp("fuzz"))


@pytest.mark.parametrize("ending", FORMATS)
@given(seed=st.integers(0, 2**32))
@FEW
def test_mutants_are_read_or_refused_in_words(readers, ending, seed):
    read, seeds = readers.by_format[ending]
    path = readers.folder / f"mutant{ending}"
    path.write_bytes(mutated(seeds[seed % len(seeds)], random.Random(seed)))
    assert read_one(read, path) in ("read", "refused")
    path.unlink(missing_ok=True)


@given(st.binary(max_size=300), st.sampled_from(FORMATS))
@FEW
def test_any_bytes_are_read_or_refused_in_words(readers, content, ending):
    path = readers.folder / f"bytes{ending}"
    path.write_bytes(content)
    assert read_one(readers.by_format[ending][0], path) in ("read", "refused")
    path.unlink(missing_ok=True)


WORDS = st.sampled_from(["0", "1.5", "-2e3", "nan", "0-7", "1,5", "x", "#", "{", "}", "1e999", "MOTION", "", "\n"])


@given(st.lists(WORDS, max_size=140), st.integers(0, 20))
@FEW
def test_what_is_read_is_finite_and_in_step(tmp_path_factory, words, stated):
    head = BVH[: BVH.index("Frames:")]
    path = tmp_path_factory.getbasetemp() / "words.bvh"
    path.write_text(head + f"Frames: {stated}\nFrame Time: .1\n" + " ".join(words))
    try:
        (clip,) = read_bvh_clips(path)
    except MotionscapeError:
        return
    assert np.isfinite(clip.rotations).all() and np.isfinite(clip.root_positions).all()
    np.testing.assert_allclose(np.linalg.norm(clip.rotations, axis=-1), 1, atol=1e-5)
    assert clip.n_frames == stated or any(finding.kind == "frames" for finding in clip.findings)


@given(st.lists(st.floats(-1e6, 1e6, allow_nan=False).map(lambda x: f"{x:+.3f}"), min_size=1, max_size=5))
@FEW
def test_glued_numbers_come_apart_where_signs_tell(words):
    assert numbers_in("".join(words)) == [float(word) for word in words]
