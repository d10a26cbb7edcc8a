"""The view that finds motion by words, from a link to its hits."""

from __future__ import annotations

import pytest

from core.demo import make_demo
from core.mocap.dataset import Dataset
from core.workspace import Workspace
from webapp.features.search import words_view


@pytest.fixture(scope="module")
def workspace(tmp_path_factory: pytest.TempPathFactory) -> Workspace:
    made = Workspace(tmp_path_factory.mktemp("words") / "workspace")
    demo = make_demo(minutes=1)
    made.add_dataset("demo", Dataset("demo", demo.clips))
    yield made
    made.close()


def test_hits_say_where_each_word_was_seen(workspace):
    dataset = workspace.open("demo")
    view = {"look": "words", "words": "walk"}
    hits = words_view.answer_of(workspace, dataset, view).hits
    shown = str(words_view.result(workspace, dataset, view))
    assert hits and shown.count("className='words-hit'") == len(hits)
    assert hits[0].segment.clip in shown and f"{100 * hits[0].score:.0f} %" in shown and "words-line" in shown


def test_whole_clips_come_where_the_link_asks_for_them(workspace):
    dataset = workspace.open("demo")
    hits = words_view.answer_of(workspace, dataset, {"words": "walk", "seen": "clip"}).hits
    assert {(hit.segment.clip, hit.segment.start) for hit in hits} == {(clip.name, 0) for clip in dataset.clips}


def test_what_is_not_known_or_not_there_is_said(workspace):
    dataset = workspace.open("demo")
    shown = str(words_view.result(workspace, dataset, {"words": "somersalt"}))
    assert "somersault" in shown and "Nothing shows this" in shown


def test_the_known_words_are_listed():
    shown = str(words_view.layout())
    assert "turn around" in shown and "Steps over the ground" in shown
