"""Four ways of making motion, as rows, as charts, and on the Stage."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from core.demo import make_demo
from core.synthesis.bakeoff import CONTENDERS, Bakeoff, Contender
from webapp.features.grammar import bakeoffs
from webapp.features.grammar.figures import bakeoff

NUMBERS = (0.5, 0.1, 80.0, 0.9, 12.0, 2.5, 6.0, 0.01, 0.05, 0.02)
FOUR = tuple(
    Contender(name, 10 * k, *(value * (1 + k / 10) for value in NUMBERS)) for k, name in enumerate(CONTENDERS, 1)
)


def test_every_contender_has_a_name_and_a_row_in_the_units_people_read():
    rows = bakeoff.rows(FOUR)
    assert [row["name"] for row in rows] == [bakeoff.NAMES[name] for name in CONTENDERS]
    assert all(bakeoff.HELP[name] for name in CONTENDERS)
    first = rows[0]
    assert first["accepted"] == pytest.approx(55) and first["skate"] == pytest.approx(1.1)
    assert first["bits"] == pytest.approx(88) and first["rules"] == 10
    assert {column["field"] for column in bakeoff.columns()} <= set(first)


def test_what_could_not_be_measured_is_empty_in_the_table_and_in_the_charts():
    without = replace(FOUR[3], seam_speed=math.nan, skate=math.nan)
    assert bakeoff.rows([without])[0]["skate"] is None
    figure = bakeoff.chart((*FOUR[:3], without), "dark")
    empty = [t for t in figure.data if t.type == "bar" and t.name == bakeoff.NAMES["motif walk"] and t.y[0] is None]
    assert len(empty) == 2


def test_the_charts_hold_what_the_table_holds():
    figure, rows = bakeoff.chart(FOUR, "light"), bakeoff.rows(FOUR)
    fields = ("accepted", "bits", "new", "blends", "seam_speed", "skate")
    for number, field in enumerate(fields):
        axis = "y" if number == 0 else f"y{number + 1}"
        bars = [t.y[0] for t in figure.data if t.type == "bar" and t.yaxis == axis]
        assert np.allclose(bars, [row[field] for row in rows])
    marks = {t.name: list(t.y) for t in figure.data if t.type == "scatter"}
    assert np.allclose(marks["Shuffled accepted"], [row["shuffled"] for row in rows])
    assert sum(bool(t.showlegend) for t in figure.data) == len(FOUR)


def test_the_stage_plays_all_or_one():
    clip = make_demo(minutes=0.3).clips[0]
    clips = tuple(replace(clip, name=name) for name in CONTENDERS[:3])
    found = Bakeoff(FOUR, clips, 12, 240)
    together = bakeoffs.stage_request(found, "abc123")
    assert [item["clip"] for item in together["items"]] == list(CONTENDERS[:3]) and together["layout"] == "side"
    assert together["dataset"] == "~bakeoff~abc123" and together["title"] == "3 ways side by side"
    alone = bakeoffs.stage_request(found, "abc123", "state machine")
    assert [item["label"] for item in alone["items"]] == ["Only what follows next"] and alone["layout"] == "overlay"
    assert alone["items"][0]["end"] == clip.n_frames
