"""Charts and sentences of compression."""

from __future__ import annotations

import pytest

from core.motifs.compressed_dataset import ALL, CLIP, MOTIF, REST, WAYS, Compression, Unit
from core.motifs.compression import METHODS, MOTION_PCA, OWN, OWN_PCA, POSE_PCA, Curves, Point, Step
from webapp.features.motifs.compression_view import read_step, rebuilt_request
from webapp.features.motifs.figures.compression import dataset_chart, dataset_sentence, motif_chart, motif_sentence


def curves(raw: int = 1000) -> Curves:
    return Curves(
        4,
        50,
        raw,
        {
            OWN: (Point(Step(1), 300, 8.0, 20.0), Point(Step(2), 600, 2.0, 9.0), Point(Step(4), 1010, 0.001, 0.01)),
            OWN_PCA: (Point(Step(2, 4), 90, 3.0, 12.0), Point(Step(4, 8), 200, 1.0, 6.0)),
            MOTION_PCA: (Point(Step(1), 310, 9.0, 22.0), Point(Step(3), 900, 1.0, 4.0)),
            POSE_PCA: (Point(Step(0, 4), 110, 4.0, 15.0), Point(Step(0, 8), 210, 1.5, 8.0)),
        },
    )


@pytest.mark.parametrize("scheme", ["light", "dark", None])
def test_a_line_a_method(scheme):
    figure = motif_chart(curves(), "cm", scheme)
    assert [trace.name for trace in figure.data] == list(METHODS.values())
    own = figure.data[0]
    assert list(own.x) == [30, 60, 101] and list(own.y) == [8.0, 2.0, 0.02]
    assert list(own.customdata[1][:3]) == [OWN, 2, 0]
    assert "2 motions" in own.customdata[1][3] and "60.0 %" in own.customdata[1][3]
    assert "1.2 kB" in own.customdata[1][3], "600 numbers of two bytes"
    pose = motif_chart(curves(), "pose", scheme)
    assert list(pose.data[0].y)[:2] == [20.0, 9.0] and "pose" in pose.layout.yaxis.title.text.lower()
    assert motif_chart(curves(), "nonsense", scheme).layout.yaxis.title.text == figure.layout.yaxis.title.text


def test_the_sentence_ranks_at_one_size_and_flatters_nobody():
    said = motif_sentence(curves())
    assert said == (
        "In 50 % of the size joints are off by 1.0 cm (own motions + PCA), 1.5 cm (PCA of postures), "
        "8.0 cm (own motions) and 9.0 cm (PCA of motions)."
    )
    assert "None" in motif_sentence(Curves(2, 10, 100, {OWN: (Point(Step(1), 90, 1.0, 1.0),)}))


def test_the_whole_data_set():
    clip = Curves(1, 50, 1000, {POSE_PCA: curves().points[POSE_PCA]})
    result = Compression(
        (
            Unit(MOTIF, "0", curves()),
            Unit(REST, "", clip),
            Unit(CLIP, "a", clip),
            Unit(CLIP, "b", clip),
            Unit(ALL, "", clip),
        )
    )
    figure = dataset_chart(result, "dark")
    assert [trace.name for trace in figure.data] == list(WAYS.values())
    said = dataset_sentence(result, 1.5)
    assert said.startswith("With a mean error of at most 1.5 cm in every part the dataset takes 21 %")
    assert all(name.split(": ")[-1] in said for name in WAYS.values())


def test_a_choice_of_the_menu_plays_the_motion_before_and_after():
    method, step = read_step("own-pca:4:12")
    assert (method, step) == (OWN_PCA, Step(4, 12))
    request = rebuilt_request("key", 3, method, step, 6, "dark")
    assert request["dataset"] == "~rebuilt~key~3~own-pca~4~12"
    assert [item["clip"] for item in request["items"]] == ["7 rebuilt", "7 original"]
    assert "motion 7" in request["title"] and "4 motions, 12 components" in request["title"]
