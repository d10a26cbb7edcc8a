"""What the page of a method says of clips whose bodies cannot be compared, and which settings it stands for."""

from __future__ import annotations

import pytest

from core.mocap.dataset import Dataset
from core.workspace import Workspace
from tests.core.mocap.odd_clips import dog, spider, walking
from webapp.features.search.layout import METHOD
from webapp.ui.method_page import chosen_values, left_out_words


@pytest.fixture(scope="module")
def workspace(tmp_path_factory):
    """A workspace with people alone, and with people and animals."""
    space = Workspace(tmp_path_factory.mktemp("space"))
    space.add_dataset("people", Dataset("people", (walking("a"), walking("b", speed=1.0))))
    space.add_dataset("mixed", Dataset("mixed", (walking("a"), dog("rex"), spider("web"))))
    return space


@pytest.mark.parametrize("page", ["motifs", "map", "grammar"])
def test_clips_of_other_kinds_are_named(workspace, page):
    words = left_out_words(workspace, page, "mixed")
    assert words.startswith("2 clips left out") and "rex" in words and "web" in words and words.endswith(".")
    assert "--clips" not in words
    assert left_out_words(workspace, page, "people") == left_out_words(workspace, page, "gone") == ""
    assert left_out_words(workspace, page, None) == ""


def test_a_search_names_the_kinds_that_it_keeps_apart(workspace):
    words = left_out_words(workspace, "search", "mixed")
    assert "people (1 clip)" in words and words.count("(1 clip)") == 3
    assert left_out_words(workspace, "search", "people") == ""


def test_settings_that_the_page_sets_in_another_way_come_from_the_link():
    """The estimate of a search looked at the default method, whatever the link said."""
    view = {"search-method": "parts"}
    assert chosen_values(METHOD, [], [], view) == ({"method": "parts"}, {})
    both = {"analysis_fps": 15, "method": "parts"}
    assert chosen_values(METHOD, [{"name": "analysis_fps"}], [15], view) == (both, {})
