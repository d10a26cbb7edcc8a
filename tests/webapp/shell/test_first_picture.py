"""What the HTML of a page shows before any script has run."""

import json
import re

import pytest
from dash import dcc, html
from plotly.utils import PlotlyJSONEncoder

from core import analyses
from core.demo import make_demo
from core.workspace import Workspace
from webapp.app import create_app
from webapp.shell import first_picture
from webapp.ui.first_table import MOST_ROWS, first_table
from webapp.ui.tables import SECONDS, column


@pytest.fixture(scope="module")
def page(tmp_path_factory):
    workspace = Workspace(tmp_path_factory.mktemp("picture") / "workspace")
    workspace.add_dataset("demo & co", make_demo(minutes=0.5))
    analyses.run(workspace, analyses.Request("demo & co", "motifs"))
    client = create_app(workspace.path).server.test_client()
    return lambda address: client.get(address).get_data(as_text=True)


def shown(html_text):
    """The first picture in a page's HTML, or None."""
    found = re.search(r'<div id="first-picture".*?</template></div>', html_text, re.DOTALL)
    return found and found[0]


def drawn(component, draws=()):
    """The picture of a component that stands for a whole layout."""
    return first_picture.picture(json.loads(json.dumps(component, cls=PlotlyJSONEncoder)), "/map", (), dict(draws))


def test_the_library_shows_its_clips_as_links(page):
    picture = shown(page("/library?dataset=demo%20%26%20co"))
    clips = re.findall(r'<a class="clip-link ellipsis" href="([^"]+)">(\w+)</a>', picture)
    assert clips and all(f"clip={name}" in address for address, name in clips)
    assert 'data-until="clips-table"' in picture
    assert "demo &amp; co" in picture and "demo & co" not in picture


def test_the_motif_graph_is_drawn_with_a_link_for_each_box(page):
    picture = shown(page("/motifs?dataset=demo%20%26%20co&kappa=55"))
    assert picture and "first-graph" not in picture, "there is no result of these settings"
    picture = shown(page("/motifs?dataset=demo%20%26%20co"))
    boxes = re.findall(r'<a href="([^"]+)" aria-label="Motif (\d+)', picture)
    assert boxes and len(boxes) == picture.count("<rect")
    for address, number in boxes:
        other = shown(page(address.replace("&amp;", "&")))
        assert other and f"motif={number}" in address


def test_links_to_pages_keep_the_dataset_and_mark_where_one_is(page):
    picture = shown(page("/motifs?dataset=demo%20%26%20co"))
    links = re.findall(r'<a href="([^"]+)" id="nav-(\w+)"( aria-current="page")?', picture)
    assert len(links) > 7 and all(address.endswith("?dataset=demo%20%26%20co") for address, _, _ in links)
    assert [name for _, name, here in links if here] == ["motifs"]


def test_buttons_are_off_and_what_is_not_open_is_not_there(page):
    picture = shown(page("/library?dataset=demo%20%26%20co"))
    buttons = re.findall(r"<button[^>]*>", picture)
    assert buttons and all(" disabled" in button for button in buttons)
    assert "Add recordings" in picture and "New name" not in picture, "dialogs are closed"
    assert "report-table" not in picture, "the other tab is closed"


@pytest.mark.parametrize("address", ["/library?dataset=gone", "/motifs?kappa=-3", "/no-such-page"])
def test_a_link_with_problems_has_no_picture(page, address):
    assert shown(page(address)) is None


def test_text_and_attributes_are_escaped():
    bad = '"><script>alert(1)</script>'
    picture = drawn(html.Div([bad, html.Span(bad, title=bad, className=bad), dcc.Store(id="kept", data=bad)]))
    assert "<script" not in picture and "kept" not in picture


def test_styles_become_css():
    picture = drawn(html.Div("x", style={"maxWidth": 20, "color": "red"}, hidden=True))
    assert 'style="max-width:20px;color:red"' in picture and " hidden" in picture


def test_a_drawing_by_id_goes_before_one_by_kind():
    draws = {"Div": lambda props, link: "kind", "special": lambda props, link: f"id of {link}"}
    assert "id of /map" in drawn(html.Div(id="special"), draws.items())


def test_a_table_has_its_first_rows_as_the_grid_writes_them():
    columns = [column("clip", "Clip", 80), column("seconds", "Seconds", 60, **SECONDS), column("x", "X", 9, hide=True)]
    rows = [{"clip": f"<{k}>", "seconds": k / 3 if k else None, "x": "hidden"} for k in range(MOST_ROWS + 5)]
    table = first_table({"id": "t", "columnDefs": columns, "rowData": rows})
    assert table.count("<tr>") == MOST_ROWS + 1 and "hidden" not in table
    assert '<td>&lt;1&gt;</td><td class="number">0.3</td>' in table
    assert '<td>&lt;0&gt;</td><td class="number">–</td>' in table
