"""New routines in a real browser: by chance, changed part by part, undone, kept, saved, there after a reload."""

from __future__ import annotations

import re

import pytest
from playwright.sync_api import Page, expect

from tests.browser.app import address, demo_workspace, link_of, show, wait_for_stage
from tests.browser.grammar.app import (
    LINK,
    PATIENCE,
    actions_of,
    grammar_workspace,
    learned,
    wait_for_routine,
    workspace,
)
from tests.browser.grammar.test_grammar import base

__all__ = ["address", "demo_workspace", "grammar_workspace", "show", "workspace"]


def press(page: Page, name: str) -> None:
    page.locator(f'[data-compose="{name}"]').click()


def settled(page: Page) -> dict[str, str]:
    """Waits until what is shown is what the address says; gives that."""
    page.wait_for_function(
        "() => { const view = new URLSearchParams(location.search);"
        " return document.getElementById('compose-string').dataset.shown"
        " === ['sentence', 'pick', 'up'].map((key) => view.get(key) || '').join(' '); }",
        timeout=PATIENCE,
    )
    return link_of(page)


def wait_for_sentence(page: Page, actions: list[int]) -> None:
    page.wait_for_function(
        "actions => !document.querySelector('#compose-string.busy')"
        " && [...document.querySelectorAll('.compose-step .action-chip')].map((c) => c.dataset.action).join()"
        " === actions",
        arg=",".join(map(str, actions)),
        timeout=PATIENCE,
    )


SHORT = LINK + "&show=compose&sentence=random:1:12"


@pytest.mark.slow
def test_a_routine_by_chance_is_changed_part_by_part(show, workspace):
    found = learned(workspace)
    page = show(SHORT, viewport={"width": 1700, "height": 950})
    wait_for_routine(page)
    first = actions_of(page)
    assert found.grammar.accepts(first)
    expect(page.locator(".ms-band span").first).to_be_visible()
    page.wait_for_function("() => document.querySelector('.compose-step.lit')", timeout=PATIENCE)
    expect(page.locator("#compose-tree .tree-leaf")).to_have_count(len(first))
    expect(page.locator(".walk-meter")).to_have_count(3)

    _a_part_grows_and_shrinks(page, first)
    changed = _one_of_four_others_is_chosen(page, found, first)
    press(page, "undo")
    wait_for_sentence(page, first)
    press(page, "redo")
    wait_for_sentence(page, changed)
    page.keyboard.press("Control+z")
    wait_for_sentence(page, first)
    page.reload()
    wait_for_sentence(page, first)
    page.keyboard.press("Control+Shift+z")
    wait_for_sentence(page, changed)


def test_a_routine_is_saved_and_kept_in_the_library(show, workspace):
    page = show(SHORT)
    wait_for_routine(page)
    _it_is_saved(page, workspace, actions_of(page))
    page.locator("#grammar-show").get_by_text("Actions", exact=True).click()
    page.locator(".action-card").first.click()
    wait_for_stage(page, "Action 0")


def _a_part_grows_and_shrinks(page: Page, actions: list[int]) -> None:
    within = page.locator(".compose-step.within")
    page.locator(".compose-step .action-chip").nth(len(actions) // 2).click()
    expect(page).to_have_url(re.compile(f"pick={len(actions) // 2}"))
    settled(page)
    sizes = [within.count()]
    while page.locator('[data-compose="larger"]').is_enabled():
        up = int(link_of(page).get("up", "0"))
        press(page, "larger")
        expect(page).to_have_url(re.compile(f"up={up + 1}"))
        settled(page)
        sizes.append(within.count())
    assert sizes == sorted(sizes) and sizes[-1] == len(actions)
    expect(page.locator(".tree-chosen")).to_have_count(1)
    if len(sizes) > 1:
        press(page, "smaller")
        expect(within).to_have_count(sizes[-2])
        press(page, "larger")
        expect(within).to_have_count(sizes[-1])


def _one_of_four_others_is_chosen(page: Page, found, before: list[int]) -> list[int]:
    press(page, "others")
    cards = page.locator(".other-card")
    expect(cards.first).to_be_visible(timeout=PATIENCE)
    count = cards.count()
    assert 1 <= count <= 4
    wait_for_stage(page, f"{count} other way")
    assert page.evaluate("motionscape.stage.figures") == count and page.evaluate("motionscape.stage.layout") == "side"
    page.get_by_role("button", name="Use A").click()
    expect(page.locator("#compose-others")).to_be_hidden()
    settled(page)
    wait_for_routine(page)
    changed = actions_of(page)
    assert changed != before and found.grammar.accepts(changed)
    assert re.fullmatch(r"[\d.]+", link_of(page)["sentence"])
    return changed


def _it_is_saved(page: Page, workspace, actions: list[int]) -> None:
    motion = page.request.get(base(page) + page.locator("#compose-bvh").get_attribute("href"))
    assert motion.ok and motion.text().startswith("HIERARCHY")
    told = page.request.get(base(page) + page.locator("#compose-json").get_attribute("href"))
    assert told.ok
    page.locator("#compose-save").click()
    expect(page.locator("#compose-save-status")).to_have_text("Give it a name first.")
    page.locator("#compose-name").fill("first try")
    page.locator("#compose-save").click()
    expect(page.locator("#compose-save-status")).to_contain_text("Kept as “first try”", timeout=PATIENCE)
    kept = workspace.open("demo routines")
    frames = motion.text().split("Frames:")[1].split()[0]
    assert kept.names == ("first try",) and kept.clips[0].n_frames == int(frames)
    assert len(kept.labels) == len(actions)
    page.locator("#compose-save").click()
    expect(page.locator("#compose-save-status")).to_contain_text("already")


def test_a_link_to_a_routine_of_other_rules_says_so(show):
    page = show(LINK + "&show=compose&sentence=999.1.4")
    expect(page.locator("#compose-error")).to_contain_text("does not obey these rules", timeout=PATIENCE)
    page.locator("#compose-most").fill("10")
    press(page, "new")
    wait_for_routine(page)
    assert re.fullmatch(r"random:\d+:10", link_of(page)["sentence"])
    expect(page.locator("#compose-error")).to_be_hidden()


def test_the_first_look_brings_a_routine_by_chance(show):
    page = show(LINK + "&show=compose")
    expect(page).to_have_url(re.compile("sentence=random:1:40"), timeout=PATIENCE)
