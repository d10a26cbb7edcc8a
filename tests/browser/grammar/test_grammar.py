"""The Grammar page in a real browser: learned, looked at, played, named, saved, there after a reload."""

from __future__ import annotations

import csv
import io
import json
import re
from dataclasses import replace
from urllib.parse import urlsplit

from playwright.sync_api import Page, expect

from core.mocap.dataset import Dataset
from tests.browser.app import address, demo_workspace, setting, show, wait_for_link, wait_for_stage
from tests.browser.grammar.app import LINK, PATIENCE, grammar_workspace, learned, wait_for_string, workspace

__all__ = ["address", "demo_workspace", "grammar_workspace", "show", "workspace"]


def choose_view(page: Page, name: str) -> None:
    page.locator("#grammar-show").get_by_text(name, exact=True).click()


def test_from_nothing_to_actions_and_back_to_a_link(show, workspace):
    page = show("/grammar?dataset=demo")
    expect(page.locator("#grammar-status")).to_contain_text("No actions yet", timeout=PATIENCE)
    page.locator(".settings-title").click()
    setting(page, "n_terminals").fill("9")
    setting(page, "min_seconds").fill("0")
    page.click("#grammar-run")
    expect(page.locator("#grammar-form")).to_contain_text("Expected a number from 0.1 to 10")
    setting(page, "min_seconds").fill("0.5")
    page.click("#grammar-run")
    wait_for_string(page)
    wait_for_link(page, **{"grammar-n_terminals": "9"})
    expect(page.locator(".action-card")).to_have_count(9)
    expect(page.locator("#grammar-status")).to_be_empty()
    page.reload()
    wait_for_string(page)
    expect(page.locator(".action-card")).to_have_count(9)
    page.get_by_role("button", name="Earlier results").click()
    page.locator(".menu-title", has_text="n terminals 14").click()
    expect(page.locator(".action-card")).to_have_count(14, timeout=PATIENCE)
    wait_for_link(page, **{"grammar-n_terminals": "14"})


def test_every_piece_plays_and_the_cursor_moves_along(show, workspace):
    found = learned(workspace)
    page = show(LINK)
    wait_for_string(page)
    blocks = page.locator(".string-block")
    expect(blocks).to_have_count(sum(map(len, found.terminals.segments)))
    cards = page.locator(".action-card")
    expect(cards).to_have_count(found.terminals.n_terminals)
    expect(page.locator(".action-strip").first).to_have_js_property("complete", True)

    action = max(range(found.terminals.n_terminals), key=lambda k: len(found.terminals.segments[k]))
    count = len(found.terminals.segments[action])
    cards.nth(action).click()
    wait_for_stage(page, f"Action {action}: ")
    expect(page.locator("#action-count")).to_contain_text(f"{count} times")
    expect(page.locator(".occurrence")).to_have_count(min(count, 60))
    expect(page.locator(".string-block.same")).to_have_count(count)
    assert page.evaluate("motionscape.stage.figures") == min(count, 24)

    page.locator(".occurrence").nth(1).click()
    wait_for_stage(page, f"Action {action}, 2 of {count}")
    segment = found.terminals.segments[action][1]
    shown = page.evaluate("motionscape.stage.frameOf(0)")
    assert (shown["clip"], shown["start"], shown["end"]) == tuple(segment)
    expect(page.locator('.string-block[aria-pressed="true"]')).to_have_count(1)
    wait_for_link(page, action=str(action), segment="1")
    cursor = "[...document.querySelectorAll('.string-now')].find((n) => n.style.display)?.style.left"
    before = page.wait_for_function(cursor).json_value()
    page.wait_for_function(f"left => ({cursor} ?? left) !== left", arg=before)

    clip = page.locator(".string-clip").first
    clip.click()
    name = clip.get_attribute("data-clip")
    wait_for_stage(page, name)
    expect(page.locator(".ms-band span")).to_have_count(len(found.terminals.occurrences[name]))
    width = "document.getElementById('grammar-string').scrollWidth"
    before = page.evaluate(width)
    page.get_by_role("button", name="Show less time, larger").click()
    assert page.evaluate(width) > 1.5 * before
    page.get_by_role("button", name="Show more time").click()
    assert page.evaluate(width) == before
    # with the keyboard from piece to piece
    first = page.locator(".string-blocks").first.locator(".string-block")
    first.nth(0).focus()
    page.keyboard.press("ArrowRight")
    page.keyboard.press("Enter")
    wait_for_stage(page, f"Action {first.nth(1).get_attribute('data-action')}, ")
    page.reload()
    wait_for_string(page)
    wait_for_stage(page, f"Action {first.nth(1).get_attribute('data-action')}, ")


def test_labels_that_come_meanwhile_are_shown(show, workspace, tmp_path):
    page = show(LINK)
    wait_for_string(page)
    clip = workspace.open("demo").names[0]
    (tmp_path / "labels.csv").write_text(f"clip,start_frame,end_frame,action\n{clip},0,60,waiting here\n")
    workspace.add_labels("demo", tmp_path / "labels.csv")
    expect(page.locator(".string-label", has_text="waiting here")).to_have_count(1, timeout=PATIENCE)


def test_a_name_is_kept_and_seen_everywhere(show, workspace):
    page = show(LINK + "&action=3")
    wait_for_string(page)
    field = page.locator("#action-name")
    expect(field).to_have_value("", timeout=PATIENCE)
    expect(page.locator("#action-title")).to_have_text("Action 3")
    field.fill("<b>side</b> step")
    page.keyboard.press("Enter")
    expect(page.locator("#action-name-status")).to_have_text("Saved.")
    expect(page.locator(".action-card").nth(3).locator("b")).to_have_text("<b>side</b> step")
    expect(page.locator('.string-block[data-action="3"]').first).to_have_text("<b>side</b> step")
    page.reload()
    wait_for_string(page)
    expect(page.locator("#action-name")).to_have_value("<b>side</b> step", timeout=PATIENCE)
    wait_for_stage(page, "<b>side</b> step")
    choose_view(page, "What follows what")
    chips = page.locator('#grammar-rules .action-chip[data-action="3"]')
    expect(chips.first).to_have_text("<b>side</b> step")


def test_rules_and_how_a_routine_is_built(show, workspace):
    found = learned(workspace)
    page = show(LINK + "&show=rules")
    wait_for_string(page)
    expect(page.locator(".phrase-card")).to_have_count(len(found.grammar.nonterminals))
    expect(page.locator(".phrase-card").first).to_contain_text("A routine")
    inside = page.locator(".phrase-chip").first
    if inside.count():
        name = inside.text_content()
        inside.click()
        expect(page.locator(".phrase-card:focus h3")).to_have_text(name)
    page.locator("#grammar-rules .action-chip").first.click()
    wait_for_stage(page, "Action ")

    choose_view(page, "Routines")
    rows = page.locator(".routine-row")
    expect(rows).to_have_count(len(found.sentences), timeout=PATIENCE)
    last = len(found.sentences) - 1
    rows.nth(last).click()
    expect(page.locator("#routine-title")).to_have_text(f"Routine {last + 1}")
    sentence = found.sentences[last]
    expect(page.locator("#routine-tree .tree-leaf")).to_have_count(len(sentence.terminals))
    phrase = page.locator("#routine-tree .tree-phrase").first
    phrase.click()
    page.wait_for_function("() => document.querySelectorAll('.ms-band span').length > 0")
    wait_for_link(page, **{"as": "actions", "routine": str(last) if last else None})
    page.wait_for_function("() => document.querySelector('#routine-tree .tree-leaf.lit')", timeout=PATIENCE)
    phrase.focus()
    page.keyboard.press("ArrowDown")
    assert page.evaluate("document.activeElement.dataset.path") == "0"

    drawing = page.request.get(base(page) + page.locator("#routine-svg").get_attribute("href"))
    assert drawing.ok and drawing.text().startswith("<svg") and "var(" not in drawing.text()
    with page.expect_download() as saved:
        page.locator(".tree-png[data-link=routine-svg]").click()
    assert saved.value.path().read_bytes().startswith(b"\x89PNG")


def base(page: Page) -> str:
    parts = urlsplit(page.url)
    return f"{parts.scheme}://{parts.netloc}"


def test_what_is_saved_is_what_is_shown(show, workspace):
    found = learned(workspace)
    page = show(LINK)
    wait_for_string(page)
    page.get_by_role("button", name="Download").click()
    expect(page.locator("a[role=menuitem]")).to_have_count(3)
    links = [item.get_attribute("href") for item in page.locator("a[role=menuitem]").all()]
    everything, pieces, rules = (page.request.get(base(page) + link) for link in links)
    document = json.loads(everything.text())
    assert len(document["terminals"]) == found.terminals.n_terminals
    assert document["sentences"] == [list(sentence.terminals) for sentence in found.sentences]
    assert len(list(csv.reader(io.StringIO(pieces.text())))) == 1 + sum(map(len, found.terminals.segments))
    assert len(list(csv.reader(io.StringIO(rules.text())))) == 1 + len(found.grammar.rules)
    for label, beginning in (("Copy as command", "motionscape grammar"), ("Copy as Python", "from core import")):
        text = page.get_by_role("menuitem", name=label).get_attribute("data-copy")
        assert text.startswith(beginning) and "14" in text


def test_links_that_make_no_sense_say_so(show):
    page = show(LINK.replace("14", "0") + "&action=2")
    expect(page.locator(".mantine-Notification-root").first).to_contain_text("n_terminals", timeout=PATIENCE)
    page.goto(base(page) + LINK + "&action=99")
    expect(page.locator(".mantine-Notification-root").first).to_contain_text(
        "no action 99; it has 14", timeout=PATIENCE
    )
    expect(page).to_have_url(re.compile("grammar-n_terminals=14"))


def test_a_result_goes_when_its_recordings_change_elsewhere(show, workspace):
    page = show(LINK)
    wait_for_string(page)
    clip = workspace.open("demo").clips[0]
    workspace.add_clips("demo", Dataset("demo", (replace(clip, name="one more"),)))
    expect(page.locator("#grammar-status")).to_contain_text("No actions yet", timeout=PATIENCE)
    expect(page.locator(".action-card")).to_have_count(0)
