"""What an analysis may take: refused before it starts, or ended with words, never by taking the machine down."""

from __future__ import annotations

import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import pytest

from core.demo import make_demo
from core.errors import ParameterError
from core.machine import MEMORY, TooLarge, check_fits, free_bytes, in_gigabytes
from core.mocap.storage import writing_dataset
from core.motifs.build import MotifParameters, find_motifs
from core.motifs.matching import Matcher
from tests.core.motifs.test_samples import repetitive
from tests.toy_method import make_dataset

ROOT = Path(__file__).resolve().parents[2]


def test_what_may_be_taken_is_what_is_free_or_what_the_variable_says(monkeypatch):
    monkeypatch.delenv(MEMORY, raising=False)
    assert 1e7 < free_bytes() < 1e14
    monkeypatch.setenv(MEMORY, "2.5")
    assert free_bytes() == 2.5e9
    for wrong in ("much", "-1", "0", "nan", "inf"):
        monkeypatch.setenv(MEMORY, wrong)
        with pytest.raises(ParameterError, match="number of gigabytes"):
            free_bytes()


def test_an_analysis_that_is_too_large_says_how_large_and_what_to_do(monkeypatch):
    monkeypatch.setenv(MEMORY, "2")
    check_fits(1.9e9, "It", "Take less.")
    with pytest.raises(TooLarge, match=r"It would take about 2\.1 GB of memory, and 2\.0 GB may be used\. Take less\."):
        check_fits(2.1e9, "It", "Take less.")
    assert in_gigabytes(2e6) == "2 MB"


def test_matching_everything_is_refused_before_it_begins_and_samples_are_not(monkeypatch):
    demo, began = make_demo(minutes=2), []
    monkeypatch.setattr(
        Matcher, "all", lambda *given, find=Matcher.all, **named: began.append(1) or find(*given, **named)
    )
    monkeypatch.setenv(MEMORY, "0.0002")
    exact = MotifParameters(kappa=200, sample=0)
    for parameters in (exact, replace(exact, sample=500, seeding="random")):
        with pytest.raises(TooLarge, match="Leave sample at its default"):
            find_motifs(demo, parameters)
    assert not began
    assert find_motifs(demo, replace(exact, sample=500)).motifs


def test_the_expected_memory_is_about_what_the_matches_take():
    _, matcher, rule = repetitive()
    matches = matcher.all(rule)
    arrays = (matches.starts, matches.ends, matches.costs)
    assert matcher.expected_bytes(rule) == pytest.approx(2 * sum(array.nbytes for array in arrays), rel=0.2)


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="only Linux counts what a process has asked for")
def test_a_process_that_wants_more_than_there_is_gets_an_error_it_can_tell():
    code = (
        "import numpy as np; from core.machine import limit_memory; limit_memory()\n"
        "try:\n    np.ones(400_000_000 // 8)\nexcept MemoryError:\n    print('told')\n"
        "np.ones(1_000_000); print('goes on')"
    )
    environment = {MEMORY: "0.2", "PYTHONPATH": str(ROOT)}
    done = subprocess.run([sys.executable, "-c", code], env=environment, capture_output=True, text=True)
    assert done.stdout.split("\n") == ["told", "goes on", ""], done.stderr


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="only Linux counts what a process has asked for")
def test_a_dataset_larger_than_the_memory_can_be_opened(tmp_path):
    dataset = make_dataset()
    with writing_dataset(tmp_path / "big", "big") as writer:
        for clip in dataset.clips:
            writer.add(clip)
        writer._file.truncate(400_000_000)  # the rest of the file is empty, and takes no room
        writer._written = (400_000_000 - 128) // 4
    code = (
        "from core.mocap.storage import load_dataset; from core.machine import limit_memory; limit_memory()\n"
        f"print(load_dataset({str(tmp_path / 'big')!r}).n_frames)"
    )
    environment = {MEMORY: "0.2", "PYTHONPATH": str(ROOT)}
    done = subprocess.run([sys.executable, "-c", code], env=environment, capture_output=True, text=True)
    assert done.stdout == f"{dataset.n_frames}\n", done.stderr[-400:]
