"""The coverage report in words, rows and a chart."""

from __future__ import annotations

from core.mocap.clip import Segment
from core.motifs.redundancy import ClipContent, Copies, RarePosture, Redundancy
from tests.webapp.features.motifs.test_timeline import graph
from tests.webapp.generated import walkers
from webapp.features.motifs.figures.redundancy import clip_rows, copy_entries, kept_chart, rare_entries
from webapp.features.motifs.report_view import body, sentence

SHARES = {"coverage": 0.5, "copies": 0.25}
METRICS = SHARES | {"distinct_seconds": 5.0, "seconds": 8.0, "kept_clips": 1.0, "kept_seconds": 4.0}
CLIPS = (ClipContent("walk", 4.0, 0.9, 4.0, 0.98, True), ClipContent("stroll", 4.0, 0.1, 0.1, 1.0, False))
REPORT = Redundancy(METRICS, CLIPS, (Copies(0, (1, 0)),), (RarePosture("walk", 239, 4.2),), {})


def test_the_sentence_says_what_to_keep():
    assert sentence(REPORT) == (
        "50 % of all frames are in motifs; 25 % are near-duplicates of a motion kept. "
        "1 of 2 clips (4 of 8 s) hold 95 % of what is distinct. 1 clip is mostly unique."
    )


def test_rows_and_chart_tell_the_same():
    assert [(row["clip"], row["keep"], row["kind"]) for row in clip_rows(REPORT)] == [
        ("walk", "yes", ""),
        ("stroll", "–", "mostly unique"),
    ]
    (line,) = kept_chart(REPORT, "dark").data
    assert list(line.x) == [0, 4.0, 8.0] and list(line.y) == [0, 98.0, 100.0]


def test_copies_and_rare_postures_can_be_played():
    dataset = walkers(("walk", "stroll"), seconds=4.0, fps=60.0)
    found = graph((Segment("walk", 0, 60), Segment("stroll", 60, 120)))
    (group,) = copy_entries(REPORT, found, dataset)
    assert group["motions"] == [
        ("stroll 0:01.0", {"motif": 0, "motion": 1}),
        ("walk 0:00.0", {"motif": 0, "motion": 0}),
    ]
    (rare,) = rare_entries(REPORT, dataset)
    assert rare["selection"] == {"clip": "walk", "start": 194, "end": 240} and "start=239" in rare["icons"]["dark"]
    assert "Rare postures" in str(body(REPORT, found, dataset, "light"))
