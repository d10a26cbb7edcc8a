"""Comparing results and measuring stability in a real browser: one load a test, many controls."""

from __future__ import annotations

import json
import re

import pytest
from playwright.sync_api import expect

from core import analyses
from core.motifs.compare import compare
from tests.browser.app import (
    PATIENCE,
    address,
    click_in_graph,
    demo_workspace,
    show,
    wait_for_graph,
    wait_for_link,
    wait_for_stage,
    workspace,
)
from webapp.features.motifs.figures.compare import filters, sentence

__all__ = ["address", "demo_workspace", "show", "workspace"]

HERE = {"init": "random"}
OTHER = {"kappa": 300, "rho": 0.5, "init": "random"}


@pytest.fixture
def comparison(workspace):
    """Of the demo's result with one of other settings, which stands among the earlier results."""
    here = analyses.run(workspace, analyses.Request("demo", "motifs", HERE))
    there = analyses.run(workspace, analyses.Request("demo", "motifs", OTHER))
    return compare(here, there)


def choose(page, label: str) -> None:
    page.click("#compare-other")
    page.get_by_role("option", name=label, exact=True).click()


def rows(page) -> list[str]:
    return page.eval_on_selector_all(
        "#compare-table .ag-center-cols-container .ag-row", "rows => rows.map(row => row.getAttribute('row-id'))"
    )


def test_two_results_side_by_side(comparison, show):
    page = show("/motifs?dataset=demo&init=random")
    wait_for_graph(page)
    page.locator("#motif-view").get_by_text("Compare").click()
    expect(page.get_by_text("Nothing to compare with yet")).to_be_visible()
    choose(page, "kappa 300, rho 0.5, init random")
    expect(page.locator("#compare-sentence")).to_have_text(sentence(comparison))
    page.wait_for_url(re.compile(r"other=[^&]*kappa(:|%3A)300"))
    bars = page.locator("#compare-flow .flow-bar")
    expect(bars).to_have_count(len(comparison.a) + len(comparison.b) + 2)

    copied = page.locator("#compare-again").get_by_role("button", name="Copy as commands").get_attribute("data-copy")
    assert copied.count("motionscape motifs") == 2 and copied.endswith("compare a.json b.json --out comparison.json")

    _rows_play_beside_their_partners(page, comparison)
    _filters_list_one_kind(page, comparison)
    _new_motifs_play_alone(page, comparison)
    _bars_and_boxes_select_too(page, comparison)


def _rows_play_beside_their_partners(page, comparison) -> None:
    kept = next(fate for fate in comparison.a if fate.change == "kept")
    row = page.locator(f"#compare-table .ag-row[row-id='a{kept.motif}']")
    row.scroll_into_view_if_needed()
    row.locator(".ag-cell").first.click()
    wait_for_stage(page, f"Motif {kept.motif} and motif {kept.partners[0]}")
    assert page.evaluate("motionscape.stage.layout") == "side" and page.evaluate("motionscape.stage.figures") >= 4
    page.wait_for_function(
        "id => document.getElementById('motif-graph')._cyreg.cy.getElementById(id).hasClass('chosen')",
        arg=f"m{kept.motif}",
    )
    expect(page.locator(f"#compare-flow .flow-bar.chosen[data-motif='{kept.motif}']")).to_have_count(1)
    expect(page.locator("#compare-table .row-chosen")).to_have_attribute("row-id", f"a{kept.motif}")


def _filters_list_one_kind(page, comparison) -> None:
    for choice in filters(comparison)[1:]:
        page.locator("#compare-filter").get_by_text(choice["label"], exact=True).click()
        expect(page.locator("#compare-table .ag-center-cols-container .ag-row").first).to_be_visible()
        side = comparison.b if choice["value"] == "gained" else comparison.a
        wanted = {("b" if side is comparison.b else "a") + str(f.motif) for f in side if f.change == choice["value"]}
        page.wait_for_function(
            "wanted => [...document.querySelectorAll('#compare-table .ag-center-cols-container .ag-row')]"
            ".every(row => wanted.includes(row.getAttribute('row-id')))",
            arg=sorted(wanted),
        )
        assert rows(page)


def _new_motifs_play_alone(page, comparison) -> None:
    new = [fate.motif for fate in comparison.b if fate.change == "gained"]
    assert new, "choose another result for this test: this one has no new motif"
    page.locator("#compare-filter").get_by_text(f"New {len(new)}", exact=True).click()
    page.locator(f"#compare-table .ag-row[row-id='b{new[0]}'] .ag-cell").first.click()
    wait_for_stage(page, f"Motif {new[0]}, only in the other result")
    wait_for_link(page, gained=str(new[0]), motif=None)


def _bars_and_boxes_select_too(page, comparison) -> None:
    one, two = comparison.a[0], comparison.a[1]
    bar = page.locator(f"#compare-flow .flow-bar[data-side='a'][data-motif='{one.motif}']")
    bar.focus()
    page.keyboard.press("Enter")
    wait_for_stage(page, f"Motif {one.motif}")
    page.locator("#motif-graph").scroll_into_view_if_needed()
    click_in_graph(page, f"m{two.motif}")
    wait_for_stage(page, f"Motif {two.motif} and" if two.partners else f"Motif {two.motif}, only here")


@pytest.mark.slow
def test_a_step_away_is_computed_and_the_link_shows_it_again(workspace, show):
    analyses.run(workspace, analyses.Request("demo", "motifs", {"analysis_fps": 15}))
    page = show("/motifs?dataset=demo&analysis_fps=15&view=compare&motif=0")
    wait_for_graph(page)
    choose(page, "Same, seed 1")
    expect(page.locator("#compare-sentence")).to_contain_text("of all motion lies", timeout=PATIENCE)
    said = page.locator("#compare-sentence").inner_text()
    wait_for_stage(page, "Motif 0")
    page.reload()
    expect(page.locator("#compare-sentence")).to_have_text(said)
    expect(page.locator("#compare-other")).to_have_value("analysis fps 15, seed 1, init random")
    page.wait_for_function("motionscape.stage.layout === 'side'")


@pytest.mark.slow
def test_stability_is_measured_shown_and_hidden(workspace, show, tmp_path):
    analyses.run(workspace, analyses.Request("demo", "motifs", {"analysis_fps": 15}))
    page = show("/motifs?dataset=demo&analysis_fps=15")
    wait_for_graph(page)
    page.click("#stability-button")
    page.fill("#stability-repetitions", "1")
    page.click("#stability-show")
    expect(page.locator("#stability-legend")).to_be_visible(timeout=PATIENCE)
    found = analyses.stored(
        workspace, analyses.Request("demo", "stability", {"analysis_fps": 15, "repetitions": 1, "noise_degrees": 2})
    )
    assert found is not None
    wait_for_link(page, stability="1,2")
    page.wait_for_function("document.getElementById('motif-graph')._cyreg.cy.nodes('.rated').length > 0")
    drawn = page.evaluate(
        "document.getElementById('motif-graph')._cyreg.cy.nodes('.rated')"
        ".map(node => [node.data('motif'), node.data('stability')])"
    )
    assert dict(map(tuple, drawn)) == pytest.approx(
        dict(zip(found.motifs, found.overall.tolist(), strict=True)), abs=1e-3
    )
    with page.expect_download() as download:
        page.get_by_text("Save the figures (JSON)").click()
    download.value.save_as(tmp_path / "stability.json")
    assert json.loads((tmp_path / "stability.json").read_text())["repeats"]
    copied = page.get_by_role("button", name="Copy as command").get_attribute("data-copy")
    assert copied.startswith("motionscape stability ") and "--analysis-fps 15.0 --repetitions 1" in copied
    page.keyboard.press("Escape")

    page.evaluate("dash_clientside.set_props('selection', {data: {motif: 0}})")
    expect(page.locator("#stability-words")).to_contain_text(f"Motif 0: {found.overall[0]:.0%}".replace("%", " %"))
    cell = page.locator("#motif-table .ag-row[row-id='0'] [col-id='stability']")
    expect(cell).to_contain_text(f"{round(100 * round(float(found.overall[0]), 3))} %")

    page.click("#stability-button")
    page.click("#stability-hide")
    expect(page.locator("#stability-legend")).to_be_hidden()
    expect(page.locator("#motif-table [col-id='stability']")).to_have_count(0)
    page.wait_for_function("document.getElementById('motif-graph')._cyreg.cy.nodes('.rated').length === 0")
    wait_for_link(page, stability=None)
