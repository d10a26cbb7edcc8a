"""Doubts of a clip: what is listed, what is drawn, what a click plays."""

from __future__ import annotations

import json

from core.mocap.dataset import Dataset
from core.mocap.reports import Finding
from tests.core.editing.figures import going
from webapp.features.clip import doctor
from webapp.features.clip.figures import curves as figures

FOUND = (
    Finding("jump", "LeftHand jumps by 2 m", 99, 101),
    Finding("sides", "what is called left lies on the right"),
    Finding("filled", "frames 0 to 20 filled", 0, 21),
)


def sent(component) -> list[dict]:
    """What the buttons of a component put into a store."""
    found = [component.to_plotly_json()["props"]["data-value"]] if hasattr(component, "data-value") else []
    children = getattr(component, "children", None) or []
    children = children if isinstance(children, list) else [children]
    return [json.loads(text) for text in found] + [v for c in children if not isinstance(c, str) for v in sent(c)]


def test_doubts_play_with_half_a_second_around():
    clip = going(("walk", 3.0))
    half = round(clip.fps / 2)
    assert doctor.around(FOUND[0], clip) == (99 - half, 101 + half)
    assert doctor.around(FOUND[2], clip) == (0, 21 + half) and doctor.around(FOUND[1], clip) is None
    dataset = Dataset("d", (clip,))
    (listed,) = doctor.panel(FOUND, clip, dataset)
    assert [row["start"] for row in sent(listed) if "action" not in row] == [0, 99 - half]
    assert len(listed.children) == 3 and "whole clip" in str(listed.children[0])
    repairs = [(row["action"], row["start"], row["end"]) for row in sent(listed) if "action" in row]
    assert repairs == [("mirror", 0, 0), ("cut", 0, 21), ("smooth", 0, 21), ("smooth", 99, 101), ("cut", 100, 180)]
    assert {row["version"] for row in sent(listed) if "action" in row} == {dataset.fingerprint}
    assert "Nothing odd" in str(doctor.panel((), clip, dataset))


def test_doubts_are_marked_on_the_time_line():
    clip = going(("walk", 3.0))
    (band,) = doctor.bands(FOUND, clip, "light")
    assert [(b.start, b.end) for b in band.blocks] == [(0, 21), (99, 101)] and [m.frame for m in band.marks] == [100]
    bar, marks = figures._band(0, band, "yaxis2", clip.fps)
    assert bar["meta"]["picks"] == [list(doctor.around(f, clip)) for f in (FOUND[2], FOUND[0])]
    assert marks["customdata"] == ["jump, frame 100"]
    assert doctor.bands(FOUND[1:2], clip, "dark") == []
