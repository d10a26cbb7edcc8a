"""Settings of pages with a method of their own: from a link to a request and back."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from core.parameters import Parameter
from webapp.shell import settings
from webapp.shell.identifiers import Pattern
from webapp.ui.method_page import MethodPage, status
from webapp.ui.parameter_form import parameter_form, read_form

PAGE = "map"
VALUES = st.fixed_dictionaries(
    {},
    optional={
        "grid": st.builds("{}x{}".format, st.integers(2, 100), st.integers(2, 100)),
        "samples": st.integers(50, 100_000),
        "sigma": st.floats(0.2, 5.0),
        "training": st.sampled_from(["batch", "online"]),
    },
)


@given(VALUES)
def test_the_view_of_settings_gives_the_same_request_back(values):
    view = settings.view_of(PAGE, values)
    assert set(view) == {f"map-{p.name}" for p in settings.parameters(PAGE)}
    defaults = {p.name: p.default for p in settings.parameters(PAGE)}
    assert defaults | settings.request_of(PAGE, "demo", view).parameters == defaults | values
    assert settings.refused(PAGE, view) == ()


def test_defaults_take_their_keys_out():
    assert set(settings.view_of(PAGE, {"grid": "30x30"}).values()) == {""}
    assert settings.view_of(PAGE, {"grid": "31x31"})["map-grid"] == "31x31"


def test_what_cannot_be_used_is_said_and_left_at_its_default():
    view = {"map-sigma": "-3", "map-grid": "31x31", "keys": "3-4"}
    assert settings.request_of(PAGE, "demo", view).parameters == {"grid": "31x31"}
    assert len(settings.refused(PAGE, view)) == 1 and "sigma" in settings.refused(PAGE, view)[0]
    assert settings.refused("motifs", view) == ()
    assert "grid must look like" in settings.refused(PAGE, {"map-grid": "11y11"})[0]


def test_a_link_to_one_page_leaves_the_settings_of_others():
    view = {"map-grid": "31x31", "view": "timeline"}
    assert settings.of_other_pages("motifs", view) == {"map-grid": "31x31"}
    assert settings.of_other_pages("map", view) == {}


PARAMETERS = (
    Parameter("many", 3, (int,), minimum=1, maximum=9),
    Parameter("name", "any", (str,)),
    Parameter("kept", True, (bool,)),
    Parameter("way", "fast", (), ("fast", "slow"), advanced=True),
)


def test_every_kind_of_parameter_has_a_control_that_is_read_back():
    shown = parameter_form(
        PARAMETERS, {"kept": False, "many": 5}, Pattern("some-setting", "name"), {"many": "How many"}
    )
    found = {part.id["name"]: part for part in shown._traverse() if isinstance(getattr(part, "id", None), dict)}
    assert set(found) == {"many", "name", "kept", "way"}
    assert found["kept"].value == "false" and found["many"].value == 5 and found["way"].value == "fast"
    assert "How many" in str(found["many"].label)
    ids, values = [part.id for part in found.values()], [part.value for part in found.values()]
    assert read_form(PARAMETERS, ids, values) == ({"many": 5, "name": "any", "kept": False, "way": "fast"}, {})
    assert read_form(PARAMETERS, [{"name": "many"}], [12]) == ({}, {"many": "Expected a whole number from 1 to 9."})


@pytest.mark.parametrize(("dataset", "words"), [(None, "No dataset yet"), ("demo", "No motion map yet")])
def test_the_status_says_what_to_do(dataset, words):
    of = MethodPage(PAGE, "Motion map", "Build map", "Building the map", "map", "It shows postures.")
    assert words in str(status(of, dataset, None, False))
    assert status(of, dataset, None, True) is None
