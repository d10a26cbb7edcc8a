"""The page's HTML: scripts that it loads at once, what it brings along, what comes later."""

import ast
import json
import re
from pathlib import Path

import dash
import pytest
from plotly.offline import get_plotlyjs_version

import webapp
from core import analyses
from core.demo import make_demo
from core.workspace import Workspace
from webapp.app import create_app
from webapp.shell import loading
from webapp.shell.feature import features

PLOTLY = Path(webapp.__file__).parents[1] / "assets" / "bundle" / loading.PLOTLY
IN_THE_BUNDLE = {"Scatter", "Bar", "Heatmap", "Box", "Histogram", "Histogram2d", "Contour", "Violin", "Image", "Pie"}


@pytest.fixture(scope="module")
def html(tmp_path_factory):
    client = create_app(tmp_path_factory.mktemp("space") / "workspace").server.test_client()
    return lambda path: client.get(path).get_data(as_text=True)


def data(page, name):
    return json.loads(re.search(rf'<script id="{name}" type="application/json">(.*?)</script>', page, re.DOTALL)[1])


def scripts(page):
    return re.findall(r'<script src="([^"]+)"', page)


def ahead(page):
    return re.findall(r'<link rel="preload" as="script" href="([^"]+)"', page)


def test_a_page_loads_the_frame_at_once_and_the_renderer_last(html):
    names = [re.split(r"[@./]", source.rpartition("/")[2])[0] for source in scripts(html("/library"))]
    assert names[:3] == ["react", "react-dom", "prop-types"]
    assert set(names[3:]) == {
        *("dash_mantine_components", "motionscape", "dash_renderer"),
        *("dash_core_components", "dash_core_components-shared", "dash_html_components"),
    }
    assert names.index("motionscape") < names.index("dash_renderer")


def test_the_layout_and_the_callbacks_come_with_the_page(html):
    page = html("/library")
    assert data(page, "first-layout")["props"]["id"] == "mantine"
    assert {"page.children", "dataset-cards.children"} <= {one["output"] for one in data(page, "first-dependencies")}


def test_a_page_fetches_ahead_what_it_begins_with(html):
    assert [address.rpartition("/")[2].partition(".")[0] for address in ahead(html("/library"))] == [
        *("dash_ag_grid", "async-community")
    ]
    assert ahead(html("/")) == ahead(html("/library?dataset=demo"))
    assert any("dash_cytoscape" in address for address in ahead(html("/motifs")))
    assert any("plotly-cartesian" in address for address in ahead(html("/map")))
    assert ahead(html("/search")) == ahead(html("/no-such-page")) == []


def test_every_kind_that_a_feature_shows_is_known(html):
    assert set(data(html("/library"), "loading")["pages"]) == {feature.path for feature in features()}


def test_libraries_for_later_have_their_address_and_components(html):
    suites = data(html("/library"), "loading")["suites"]
    assert {name: suite["components"] for name, suite in suites.items()} == {
        "dash_ag_grid": ["AgGrid"],
        "dash_cytoscape": ["Cytoscape"],
    }
    assert all(f"/{name}/{name}.v" in suite["source"] for name, suite in suites.items())


def test_no_other_component_of_these_libraries_is_used():
    used = set()
    for path in Path(webapp.__file__).parent.rglob("*.py"):
        tree = ast.parse(path.read_text(encoding="utf-8"))
        aliases = {
            alias.asname or alias.name: alias.name
            for node in ast.walk(tree)
            if isinstance(node, ast.Import)
            for alias in node.names
            if alias.name in loading.LATER
        }
        for node in ast.walk(tree):
            if isinstance(node, ast.Attribute) and getattr(node.value, "id", "") in aliases:
                used.add((aliases[node.value.id], node.attr))
            if isinstance(node, ast.ImportFrom):
                assert node.module not in (*loading.LATER, "dash.dash_table"), path
    assert used == {(name, component) for name, components in loading.LATER.items() for component in components}


def test_another_dash_that_writes_its_scripts_otherwise_is_refused():
    with pytest.raises(RuntimeError, match=re.escape(f"Dash {dash.__version__} writes 0 scripts of /dash_table/")):
        loading.split_scripts('<script src="/bundle.js"></script>')


def test_text_cannot_end_the_script_that_holds_it(html):
    page = html("/library?dataset=</script><script>alert(1)</script>")
    assert "<script>alert" not in page
    assert loading._data("x", json.dumps("</script>")).count("</script>") == 1


def test_plotly_is_not_older_than_the_charts_that_are_made_for_it():
    head = PLOTLY.open(encoding="utf-8").read(200)
    served = re.search(r"plotly.js \(cartesian - minified\) v([\d.]+)", head)[1]
    number = [tuple(map(int, version.split("."))) for version in (served, get_plotlyjs_version())]
    assert number[0] >= number[1], "take the version of plotly.js that plotly.py brings into assets/package.json"


def test_charts_are_of_kinds_that_this_plotly_draws():
    used = set()
    for path in Path(webapp.__file__).parent.rglob("*.py"):
        used |= set(re.findall(r"\bgo\.([A-Z]\w+)\(", path.read_text(encoding="utf-8"))) - {"Figure", "Layout"}
    assert used and used <= IN_THE_BUNDLE


@pytest.fixture(scope="module")
def demo(tmp_path_factory):
    """Pages of a workspace with a dataset, by address."""
    workspace = Workspace(tmp_path_factory.mktemp("demo") / "workspace")
    workspace.add_dataset("demo", make_demo(minutes=0.3))
    client = create_app(workspace.path).server.test_client()
    return lambda path: client.get(path).get_data(as_text=True)


def first_values(page):
    """The properties of the first layout's components, by id."""
    found = {}

    def walk(node):
        if isinstance(node, list):
            for child in node:
                walk(child)
        elif isinstance(node, dict) and "props" in node:
            if isinstance(node["props"].get("id"), str):
                found[node["props"]["id"]] = node["props"]
            walk(node["props"].get("children"))

    walk(data(page, "first-layout"))
    return found


def test_the_first_layout_shows_what_the_link_names(demo):
    shown = first_values(demo("/motifs?dataset=demo&kappa=60&motif=3&time=1.5"))
    assert shown["url"]["pathname"] == "/motifs"
    assert shown["url"]["search"] == "?dataset=demo&kappa=60&motif=3&time=1.5"
    assert shown["dataset"]["data"] == "demo"
    assert "60" in shown["view"]["data"].values()
    assert shown["selection"]["data"] == {"motif": 3}
    assert "motif-result" in shown and "dataset-detail" not in shown
    assert shown["revision"]["data"] and shown["jobs-seen"]["data"]["revision"] == shown["revision"]["data"]


def test_the_bare_address_shows_the_library_of_the_first_dataset(demo):
    shown = first_values(demo("/"))
    assert (shown["url"]["pathname"], shown["url"]["search"]) == ("/", "")
    assert shown["dataset"]["data"] == "demo" and "dataset-detail" in shown


@pytest.mark.parametrize("address", ["/library?dataset=gone", "/motifs?kappa=-3", "/no-such-page"])
def test_a_link_with_problems_is_opened_by_the_browser_which_is_told_of_them(demo, address):
    shown = first_values(demo(address))
    assert "pathname" not in shown["url"] and not shown["page"]["children"]
    assert shown["revision"]["data"]


def test_one_page_does_not_change_the_next(demo):
    demo("/clip?dataset=demo")
    assert "clip-graph" not in first_values(demo("/library"))


def test_values_for_components_that_do_not_exist_are_refused():
    with pytest.raises(KeyError, match="nowhere"):
        loading.filled('{"props": {"id": "page"}}', {"nowhere": {"data": 1}})


@pytest.fixture(scope="module")
def results(tmp_path_factory):
    """The client of an app whose dataset has a motif graph and a map."""
    workspace = Workspace(tmp_path_factory.mktemp("results") / "workspace")
    workspace.add_dataset("demo", make_demo(minutes=0.5))
    for method in ("motifs", "map"):
        analyses.run(workspace, analyses.Request("demo", method))
    return create_app(workspace.path).server.test_client()


SHOWN_AT_FIRST = {  # page -> a place that is filled, and stores whose callback comes at the start (none: no trigger)
    "library": ("dataset-detail.children", []),
    "motifs": ("motif-result.children", ["motifs-result-key.data"]),
    "map": ("map-graph.figure", ["map-known.data"]),
}


def answer(client, page, output, changed):
    """What the server answers to the callback with this output, asked by a browser that shows ``page``."""
    values = first_values(page)
    callback = next(one for one in data(page, "first-dependencies") if output in one["output"])
    names = callback["output"].strip(".").split("...")
    parts = {
        kind: [one | {"value": values[one["id"]].get(one["property"])} for one in callback[kind]]
        for kind in ("inputs", "state")
    }
    outputs = [dict(zip(("id", "property"), name.split("."), strict=True)) for name in names]
    body = {"output": callback["output"], "outputs": outputs, "changedPropIds": changed, **parts}
    return client.post("/_dash-update-component", json=body)


@pytest.mark.parametrize("path", SHOWN_AT_FIRST)
def test_what_came_with_the_page_is_not_sent_again(results, path):
    output, changed = SHOWN_AT_FIRST[path]
    name, prop = output.split(".")
    page = results.get(f"/{path}?dataset=demo").get_data(as_text=True)
    assert first_values(page)[name][prop]
    response = answer(results, page, output, changed)
    assert response.status_code == 204 or name not in response.get_json()["response"]
    again = answer(
        results, re.sub(r'("id": "(?:motifs-drawn|map-painted|detail-shown)")[^}]*', r"\1", page), output, changed
    )
    assert name in again.get_json()["response"], "without what the page brought it is sent"


def test_a_page_without_a_result_brings_none(results):
    page = results.get("/motifs?dataset=demo&kappa=77").get_data(as_text=True)
    assert not first_values(page)["motif-result"].get("children")
