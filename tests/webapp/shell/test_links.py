"""Links: what one sees, there and back; broken ones never raise."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

import webapp.features  # noqa: F401  registers the pages
from core import analyses
from webapp.shell import settings
from webapp.shell.feature import features
from webapp.shell.links import STAGE_KEYS, View, format_link, page_of, parse, view_keys, without_selection

SETTINGS = ("kappa", "rho", "adjacency")
NAMES = st.text(st.characters(exclude_categories=("Cs", "Cc")), min_size=1, max_size=40)
NUMBERS = st.integers(0, 10**6)
SELECTIONS = st.one_of(
    st.just({}),
    st.fixed_dictionaries({"motif": NUMBERS}, optional={"motion": NUMBERS}),
    st.builds(lambda a, b: {"edge": f"{a}-{b}"}, st.integers(0, 999), st.integers(0, 999)),
    st.builds(lambda name, start, n: {"clip": name, "start": start, "end": start + n + 1}, NAMES, NUMBERS, NUMBERS),
    st.builds(lambda name: {"clip": name}, NAMES),
    st.fixed_dictionaries({"action": NUMBERS}, optional={"segment": NUMBERS}),
    st.builds(lambda name: {"clip": name, "as": "actions"}, NAMES),
)
VIEWS = st.builds(
    View,
    st.sampled_from(sorted(view_keys())),
    NAMES,
    SELECTIONS,
    st.dictionaries(st.sampled_from(["time", "camera"]), st.sampled_from(["1.5", "0.6,-0.2,3,0,1,0,1"])),
    st.dictionaries(st.sampled_from(SETTINGS), st.sampled_from(["200", "0.5", "spheres"])),
)


def split(link: str) -> tuple[str, str]:
    path, _, query = link.partition("?")
    return path, f"?{query}" if query else ""


@given(VIEWS)
def test_a_link_gives_its_view_back(view: View):
    assert parse(*split(format_link(view))) == (view, ())


@given(st.text(max_size=60), st.text(max_size=300))
def test_any_text_is_read_without_raising(path: str, query: str):
    view, problems = parse(path, query)
    assert view.page in view_keys()
    assert all(isinstance(problem, str) and problem.endswith(".") for problem in problems)


def test_no_setting_is_named_like_what_a_link_says_of_a_selection():
    taken = {"dataset", "clip", "start", "end", "as", *STAGE_KEYS}
    names = {parameter.name for method in analyses.METHODS for parameter in analyses.parameters(method)}
    assert names & taken == set()


def test_half_characters_do_not_break_a_link():
    assert format_link(View("library", "\ud800", {"clip": "a\udfff"})) == "/library?dataset=%3F&clip=a%3F"


def test_the_root_is_the_library_and_unknown_pages_are_named():
    assert page_of("/") == "library" and page_of("/motifs/") == "motifs" and page_of("/admin") is None
    assert "admin" in parse("/admin", "")[1][0]


def test_what_cannot_be_understood_is_left_out_and_said():
    view, problems = parse("/motifs", "?dataset=demo&motif=three&kappa=200&colour=red")
    assert view == View("motifs", "demo", view={"kappa": "200"})
    assert any("motif" in problem for problem in problems) and any("colour" in problem for problem in problems)
    view, problems = parse("/map", "?keys=3-4,a-b&drawn=1.5-2,3&region=x&within=0.5")
    assert view.view == {"within": "0.5"} and len(problems) == 3
    assert parse("/map", "?keys=3-4,12-0&region=7")[1] == parse("/map", "?drawn=1.5-2,3-0.4")[1] == ()


def test_an_interval_needs_both_ends_in_order():
    assert parse("/library", "?clip=a&start=3")[0].selection == {"clip": "a"}
    assert parse("/library", "?clip=a&start=9&end=3")[0].selection == {"clip": "a"}
    assert parse("/library", "?clip=a&start=3&end=9")[0].selection == {"clip": "a", "start": 3, "end": 9}


def test_several_motifs_are_marked_together():
    assert parse("/motifs", "?motifs=3-7-12")[0].selection == {"motifs": "3-7-12"}
    for wrong in ("3-", "a-b", "-".join(["1"] * 500)):
        view, problems = parse("/motifs", f"?motifs={wrong}")
        assert view.selection == {} and "3-7-9" in problems[0]


def test_only_what_we_know_colours_a_clip():
    assert parse("/grammar", "?clip=a&as=actions")[0].selection == {"clip": "a", "as": "actions"}
    assert parse("/grammar", "?clip=a&as=ghosts")[0].selection == {"clip": "a"}


def test_a_flood_is_refused():
    assert parse("/library", "?dataset=" + "x" * 5000)[1] == ("The link is too long.",)
    many = "&".join(f"a{i}=1" for i in range(150))
    assert "could not be read" in parse("/library", f"?{many}")[1][0]


def test_nothing_selected_keeps_the_rest():
    view = View("motifs", "demo", {"motif": 3}, {"time": "1"}, {"rho": "2", "view": "compare", "other": "rho:3"})
    assert without_selection(view) == View("motifs", "demo", view={"rho": "2"})


def test_a_key_of_a_link_means_one_thing():
    """The parameters of the motifs stand in the links of all pages, so no page may call anything the same."""
    everywhere = tuple(parameter.name for parameter in analyses.parameters("motifs"))
    taken = {"dataset", *STAGE_KEYS, *everywhere}
    for feature in features():
        assert view_keys()[feature.path][: len(everywhere)] == everywhere
        assert not taken & set(feature.keys.names)
        assert not taken & {key for name in feature.methods if name != "motifs" for key in settings.keys(name)}
