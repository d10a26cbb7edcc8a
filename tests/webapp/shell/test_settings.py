"""Settings of pages with a method of their own: from a link to a request and back."""

from __future__ import annotations

import json

import pytest
from hypothesis import given
from hypothesis import strategies as st

import webapp.features  # noqa: F401  registers the pages
from core.parameters import Parameter
from webapp.shell import links, settings
from webapp.shell.feature import features
from webapp.shell.identifiers import Pattern
from webapp.ui.method_page import MethodPage, status
from webapp.ui.parameter_form import parameter_form, read_form

PAGE = "map"
TEXTS = {"grid": st.builds("{}x{}".format, st.integers(2, 100), st.integers(2, 100))}
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


def values_of(parameter: Parameter) -> st.SearchStrategy:
    """Values that a parameter may have, awkward ones among them."""
    offered = [st.sampled_from(parameter.words)] if parameter.words else []
    low, high = parameter.minimum, parameter.maximum
    for kind in parameter.kinds:
        if kind is bool:
            offered.append(st.booleans())
        elif kind is int:
            offered.append(st.integers(low, high))
        elif kind is float:
            offered.append(st.floats(low, high, allow_nan=False, allow_infinity=False))
        elif kind is str and not parameter.words:
            offered.append(st.just(parameter.default or ""))
    return st.one_of(offered)


@pytest.mark.parametrize("name", sorted(settings.methods()))
@given(data=st.data())
def test_settings_go_through_a_link_unchanged(name, data):
    """For every method: settings -> link -> settings is the identity."""
    known = settings.parameters(name)
    texts = TEXTS if name == PAGE else {}
    offered = {p.name: texts[p.name] if p.name in texts else values_of(p) for p in known}
    values = data.draw(st.fixed_dictionaries({}, optional=offered))
    page = next(feature.path for feature in features() if name in feature.methods)
    link = links.format_link(links.View(page, "demo", view=settings.in_link(name, values)))
    view, problems = links.parse(*link.split("?", 1))
    read = settings.request_of(name, "demo", view.view).parameters
    defaults = {p.name: p.default for p in known}
    assert problems == () and json.dumps(defaults | read) == json.dumps(defaults | values)
    assert settings.read_list(name, settings.write_list(name, values)) == settings.in_link(name, values)


def test_settings_that_stand_in_all_links_have_the_parameters_own_names():
    assert (
        settings.keys("motifs") == tuple(p.name for p in settings.parameters("motifs")) == settings.keys_on_every_page()
    )
    assert settings.in_link("motifs", {"kappa": 200, "rho": 2.0, "gamma": 1.5}) == {"kappa": "200", "rho": "2"}
    assert settings.texts("motifs", {"view": "report", "rho": "2"}) == {"rho": "2"}


def test_what_does_not_go_together_is_said_and_left_out():
    view = {"kappa": "60", "min_letters": "20", "max_letters": "10", "view": "report"}
    assert "min_letters (20) must not exceed max_letters (10)" in settings.refused("motifs", view)[0]
    kept, problems = settings.usable("motifs", view)
    assert kept == {"kappa": "60", "min_letters": "20", "view": "report"} and problems == settings.refused(
        "motifs", view
    )
    assert settings.usable("sweeps", view) == (view, ()), "a sweep along one of them puts another value in its place"
    assert settings.usable("motifs", {"min_letters": "40", "max_letters": "60"})[1] == ()
    assert settings.usable("motifs", {"min_letters": "40", "seed": "3"})[0] == {"seed": "3"}


def test_a_link_leaves_defaults_and_what_cannot_be_used_out():
    kept, problems = settings.usable(
        "map", {"rho": "1", "kappa": "many", "map-sigma": "-3", "keys": "3-4", "seed": "07"}
    )
    assert kept == {"keys": "3-4", "seed": "7"}
    assert len(problems) == 2 and "kappa" in problems[0] + problems[1] and "sigma" in problems[0] + problems[1]


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
    view = {"map-grid": "31x31", "view": "timeline", "kappa": "60"}
    assert settings.of_other_pages("motifs", view) == {"map-grid": "31x31"}
    assert settings.of_other_pages("map", view) == {}


PARAMETERS = (
    Parameter("many", 3, (int,), minimum=1, maximum=9, label="How many"),
    Parameter("name", "any", (str,)),
    Parameter("kept", True, (bool,)),
    Parameter("way", "fast", (), ("fast", "slow"), advanced=True),
)


def test_every_kind_of_parameter_has_a_control_that_is_read_back():
    shown = parameter_form(PARAMETERS, {"kept": False, "many": 5}, Pattern("some-setting", "name"))
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
