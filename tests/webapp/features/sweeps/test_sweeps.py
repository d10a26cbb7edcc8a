"""The Sweeps page without a browser: what links and forms mean, what charts and tables hold, what stands where."""

from __future__ import annotations

import json
import shlex
from dataclasses import replace

import numpy as np
import pytest

from core import analyses
from core.errors import ParameterError
from core.motifs.axes import points_of, sweepable
from core.motifs.parameters import MotifParameters
from core.motifs.suggestion import CLEAR, UNSURE, Suggestion
from core.motifs.sweep_table import SweepTable
from core.workspace import Workspace
from tests.core.motifs.recordings import recurring
from webapp.cli import main
from webapp.features.sweeps import layout, reading
from webapp.features.sweeps.callbacks import Shown, shown_sweep
from webapp.features.sweeps.commands import sweep_parameters
from webapp.features.sweeps.figures import charts
from webapp.features.sweeps.figures import rows as sweep_rows
from webapp.features.sweeps.figures.measures import MEASURES, PAIRS, pairs_of
from webapp.shell import links, results, settings

AXES = {"kappa": (50, 100, 200), "rho": (0.2, 1.0)}
POINTS = points_of(MotifParameters(), AXES, 3)
CHOSEN = Suggestion({"kappa": 100, "rho": 1.0}, (1, 1), CLEAR, "because")


def entry(k: int, **more: float) -> dict[str, float]:
    return {
        "coverage": 0.9 - k / 100, "average_frame_error": 30.0 - k, "mean_pose_distance": 100.0, "n_motifs": 10.0 + k,
        "mean_motions": 5.0, "mean_frames": 40.0, "kappa": 50.0, "seconds": 1.0, **more,
    }  # fmt: skip


TABLE = SweepTable(AXES, 3, [entry(k) for k in range(18)])
LINKS = charts.link_array(TABLE, POINTS, lambda p: f"/motifs?kappa={p.kappa}&rho={p.rho:g}&seed={p.seed}")


def test_a_view_without_a_sweep_means_the_papers_ranges():
    form = reading.form_of(None, {})
    assert form == reading.Form("kappa", "50, 100, 200, 500, 1000, 2000", "rho", "0.2, 0.5, 1, 2, 5", "3")
    short = recurring(0)
    assert reading.form_of(short, None).x_values == "50, 100"
    assert reading.form_of(None, {"x": "rho:1,2"}).y_name == reading.NO_AXIS


@pytest.mark.parametrize(
    "view",
    [
        {"x": "kappa:50,auto", "y": "rho:0.2,1", "seeds": "5"},
        {"x": "adjacency:radius,spheres", "y": "none", "seeds": "1"},
        {"x": "min_letters:3,5", "y": "gamma:1.35", "seeds": "3"},
    ],
)
def test_a_view_goes_through_the_form_and_the_link_unchanged(view):
    form = reading.form_of(None, view)
    assert reading.view_of(form) == view and reading.problems_of(form) == {}
    link = links.format_link(links.View("sweeps", "demo", view={"gamma": "2", **view}))
    back, problems = links.parse(*link.split("?", 1))
    assert dict(back.view) == {"gamma": "2", **view} and problems == ()


@pytest.mark.parametrize(
    ("change", "field", "said"),
    [
        ({"x_values": "50, x"}, "x", "'x' cannot be used"),
        ({"x_values": ""}, "x", "at least one value"),
        ({"y_values": "0.1"}, "y", "from 0.2 to 5"),
        ({"y_name": "kappa"}, "y", "another setting"),
        ({"x_values": ",".join(f"{k}.0000000" for k in range(100, 140))}, "x", "cannot hold that many values"),
        ({"seeds": "0"}, "seeds", "1 to 20"),
        ({"seeds": "many"}, "seeds", "1 to 20"),
        ({"x_name": "nonsense"}, "x", "No parameter"),
    ],
)
def test_the_form_says_what_is_wrong_and_where(change, field, said):
    form = reading.form_of(None, {})._replace(**change)
    assert said in reading.problems_of(form)[field]
    with pytest.raises(ParameterError):
        reading.sweep_of(form, {})


def test_the_sweep_keeps_the_other_settings_but_not_the_seed():
    form = reading.form_of(None, {"x": "kappa:50,100", "y": "none", "seeds": "2"})
    sweep = reading.sweep_of(form, {"gamma": "2", "seed": "7", "kappa": "900", "nonsense": "1"})
    assert [(p.kappa, p.gamma, p.seed) for p in sweep.points()] == [
        (50, 2.0, 0),
        (50, 2.0, 1),
        (100, 2.0, 0),
        (100, 2.0, 1),
    ]
    assert json.loads(sweep.base) == {"gamma": 2.0, "init": "random"}  # several seeds


def test_an_old_value_of_an_axis_does_not_get_in_the_way():
    form = reading.form_of(None, {"x": "min_letters:5,10", "y": "max_letters:15,30", "seeds": "1"})
    assert len(reading.sweep_of(form, {"min_letters": "29"}).points()) == 4


def test_every_setting_has_values_to_begin_with():
    for parameter in sweepable():
        form = reading.form_of(None, {})._replace(x_name=parameter.name, y_name=reading.NO_AXIS)
        assert reading.problems_of(form._replace(x_values=reading.usual_values(None, parameter.name))) == {}


def test_the_copied_command_and_script_are_the_same_sweep(tmp_path):
    form = reading.form_of(None, {"x": "kappa:50,auto", "y": "rho:0.2,1", "seeds": "2"})
    sweep = reading.sweep_of(form, {"adjacency": "spheres", "min_seconds": "0.7"})
    recipes = reading.recipes_of(tmp_path / "my space", "walks & runs", sweep)
    words = shlex.split(recipes["Copy as command"])
    assert words[:3] == ["motionscape", "sweep", f"{tmp_path}/my space/walks & runs"]
    asked = main._parser(words[1:]).parse_args(words[1:])
    assert sweep_parameters(asked) == sweep
    names = {}
    script = (
        recipes["Copy as Python"].replace("dataset = ", "dataset = 0 and ").replace("points = sweep(", "points = tell(")
    )
    exec(script, names | {"tell": lambda *given, **more: names.update(given=given, more=more) or []})
    _, base, axes = names["given"]
    assert points_of(base, axes, **names["more"]) == sweep.points()


def test_a_shown_sweep_links_to_the_motifs_page(tmp_path):
    workspace = Workspace(tmp_path / "space")
    workspace.add_dataset("moves", recurring(0))
    shown = shown_sweep(workspace, "moves", {"gamma": "2", "x": "kappa:20,30", "y": "none", "seeds": "2"})
    assert isinstance(shown, Shown) and (shown.table.n_ready, shown.table.shape) == (0, (2, 2))
    assert shown.link(shown.sweep.points()[1]) == "/motifs?dataset=moves&kappa=20&gamma=2&seed=1&init=random"
    fine = shown_sweep(workspace, "moves", {"x": "rho:0.3333333333333333", "y": "none", "seeds": "1"})
    assert fine.link(fine.sweep.points()[0]).endswith("&rho=0.3333333333333333"), "to the very result"
    assert shown_sweep(workspace, None, {}) is None


AWKWARD = [
    {"x": "rho:1.2345678,0.30000000000000004,0.2", "y": "kappa:auto,19999", "seeds": "2", "analysis_fps": "29.97"},
    {"x": "reach:0.0010000000000000002,0.1", "y": "strictness:0.1,0.7071067811865476", "seeds": "1", "kappa": "12345"},
    {"x": "min_letters:3,12", "y": "gamma:1.0000000000000002,3.9999999999999996", "seeds": "1", "max_letters": "12"}
    | {"min_letters": "29"},
    {"x": "adjacency:radius,spheres", "y": "none", "seeds": "20", "rho": "1.2345678", "hold": "1e-3"},
]


@pytest.mark.parametrize("view", AWKWARD)
def test_the_link_of_every_point_opens_its_own_result(tmp_path, view):
    workspace = Workspace(tmp_path / "space")
    workspace.add_dataset("moves & more", recurring(0))
    shown = shown_sweep(workspace, "moves & more", view)
    fingerprint, points = shown.dataset.fingerprint, shown.sweep.points()
    assert len({shown.link(point) for point in points}) == len(points)
    for point in points:
        path, _, query = shown.link(point).partition("?")
        opened, problems = links.parse(path, query)
        kept, refused = settings.usable(opened.page, opened.view)
        assert (problems, refused) == ((), ()) and kept == dict(opened.view)
        request = settings.request_of("motifs", opened.dataset, kept)
        assert analyses.key(workspace, request) == analyses.point_key(fingerprint, point)


def test_the_link_of_every_point_finds_what_the_sweep_stored(tmp_path):
    workspace = Workspace(tmp_path / "space")
    workspace.add_dataset("moves", recurring(0))
    view = {"x": "rho:1.2345678,0.30000000000000004", "y": "kappa:20,25", "seeds": "1", "analysis_fps": "29.97"}
    shown = shown_sweep(workspace, "moves", view)
    analyses.run(workspace, reading.request_of("moves", shown.sweep))
    for point in shown.sweep.points():
        opened, _ = links.parse(*shown.link(point).split("?", 1))
        graph = results.motif_graph(workspace, opened.dataset, opened.view)
        assert graph is not None and graph.parameters["rho"] == point.rho and graph.parameters["kappa"] == point.kappa


def test_lines_hold_every_point_with_its_link_and_the_spread():
    figure = charts.lines(TABLE, LINKS, "kappa", {"rho": 1.0}, PAIRS["error-coverage"], CHOSEN, "light")
    low, high, middle, dots = figure.data[:4]
    assert list(low.x) == [50, 100, 200] and len(figure.data) == 8
    numbers = TABLE.along("average_frame_error", "kappa", {"rho": 1.0})
    assert np.allclose(low.y, numbers.min(1)) and np.allclose(high.y, numbers.max(1))
    assert np.allclose(middle.y, np.median(numbers, 1))
    assert len(dots.y) == 9 and dots.customdata[1] == "/motifs?kappa=50&rho=1&seed=1"
    assert "seed 1" in dots.text[1] and figure.data[7].yaxis == "y2" and max(figure.data[7].y) > 50, (
        "coverage in percent"
    )
    assert [shape.x0 for shape in figure.layout.shapes] == [100]
    elsewhere = charts.lines(TABLE, LINKS, "kappa", {"rho": 0.2}, PAIRS["motifs"], CHOSEN, "dark")
    assert not elsewhere.layout.shapes, "the suggestion lies at another rho"


def test_lines_bear_words_gaps_and_one_point():
    table = SweepTable({"kappa": ("auto", 50, 100)}, 1, [entry(0), None, entry(2)])
    points = points_of(MotifParameters(), table.axes)
    addresses = charts.link_array(table, points, lambda p: f"/{p.kappa}")
    found = Suggestion({"kappa": 50}, (1,), UNSURE, "")
    figure = charts.lines(table, addresses, "kappa", {}, PAIRS["error-coverage"], found, None)
    assert figure.layout.shapes[0].x0 == 1, "the second word of the axis"
    assert list(figure.data[3].x) == ["auto", "100"] and figure.layout.xaxis.type == "category"
    assert list(figure.data[3].customdata) == ["/auto", "/100"] and "seed" not in figure.data[3].text[0]


def test_the_map_shows_medians_and_leads_to_the_most_typical_seed():
    figure = charts.heat(TABLE, LINKS, "coverage", CHOSEN, "dark")
    cells = figure.data[0]
    assert np.allclose(np.array(cells.z).T, 100 * TABLE.middle("coverage"))
    assert cells.customdata[1][2] == "/motifs?kappa=200&rho=1&seed=1"
    assert (figure.layout.annotations[0].x, figure.layout.annotations[0].y) == (1, 1)
    gaps = SweepTable(AXES, 3, [None] * 3 + [entry(k) for k in range(15)])
    figure = charts.heat(gaps, charts.link_array(gaps, POINTS, lambda p: "x"), "n_motifs", CHOSEN, None)
    assert figure.data[0].text[0][0] == "" and figure.data[0].customdata[0][0] == ""
    assert charts.typical_seed(np.array([1.0, 9.0, np.nan, 4.0])) == 3


def test_the_table_has_a_row_a_point_that_is_there():
    part = SweepTable(AXES, 3, [entry(k, purity=0.5, f1_majority=0.25) if k != 4 else None for k in range(18)])
    addresses = charts.link_array(part, POINTS, lambda p: f"/{p.kappa}")
    rows = sweep_rows.rows(part, POINTS, addresses)
    assert [row["key"] for row in rows] == [str(k) for k in range(18) if k != 4]
    assert rows[0]["coverage"] == 90 and rows[0]["purity"] == 50 and rows[0]["href"] == "/50" and rows[0]["rho"] == 0.2
    fields = [column["field"] for column in sweep_rows.columns(part)]
    assert fields[:4] == ["open", "kappa", "rho", "seed"] and set(MEASURES) <= set(fields)
    assert "purity" not in [column["field"] for column in sweep_rows.columns(TABLE)]
    assert "labels" in pairs_of(part) and "labels" not in pairs_of(TABLE)


def text_of(component) -> str:
    return json.dumps(component.to_plotly_json(), default=lambda o: o.to_plotly_json())


def test_what_stands_in_place_of_charts():
    assert "Go to the library" in text_of(layout.status(None, None, 0, 0))
    assert "Press Run sweep" in text_of(layout.status("moves", None, 0, 9))
    assert "kappa: bad" in text_of(layout.status("moves", None, 0, 0, "kappa: bad"))
    assert layout.status("moves", None, 9, 9) is None
    assert "3 of 9 points are there" in text_of(layout.status("moves", None, 3, 9))


def test_what_jobs_leave_is_said(tmp_path):
    workspace = Workspace(tmp_path / "space")
    job = workspace.jobs.submit("k", {"method": "sweep"}, "Sweep: moves")
    assert "Cancel" in text_of(layout.status("moves", job, 0, 9))
    assert "sweep-running" in text_of(layout.status("moves", job, 3, 9))
    gone = replace(job, state="cancelled")
    assert "The sweep was cancelled" in text_of(layout.status("moves", gone, 0, 9))
    assert "was cancelled. 3 of 9" in text_of(layout.status("moves", gone, 3, 9))
    broken = replace(job, state="failed", error="Out of memory.")
    assert all("Out of memory." in text_of(layout.status("moves", broken, n, 9)) for n in (0, 3))


def test_a_suggestion_that_is_not_clear_says_so():
    assert "No clear suggestion" not in text_of(layout.suggestion(CHOSEN, "/motifs", True))
    unsure = text_of(layout.suggestion(replace(CHOSEN, verdict=UNSURE), "/motifs", False))
    assert "No clear suggestion so far" in unsure and "because" in unsure
    assert "Open it" not in text_of(layout.suggestion(Suggestion({}, (), "none", "too few"), "", True))
