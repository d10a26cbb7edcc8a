"""Jobs in a real browser: progress, cancel, run again, reload in the middle, a second tab, a dead worker."""

from __future__ import annotations

import time

import psutil
from playwright.sync_api import Error, Page, expect

from core import analyses
from tests.browser.app import PATIENCE, address, demo_workspace, setting, show, wait_for_graph, workspace

__all__ = ["address", "demo_workspace", "show", "workspace"]
SLOW = {"minutes": 30}  # a demo that takes minutes to make: plenty of time to look, and it is cancelled in the end


def find_anew(page: Page, seed: int = 7) -> None:
    """Asks for a graph that is not there yet."""
    page.get_by_role("button", name="Settings").click()
    setting(page, "seed").fill(str(seed))
    page.click("#find-motifs")


def progress_is_seen(page: Page, seed: int) -> bool:
    """Asks for a graph, and whether the page shows how that goes on, in one and the same box."""
    setting(page, "seed").fill(str(seed))
    page.click("#find-motifs")
    try:
        page.locator(".job-title", has_text="Motif graph: demo").wait_for(timeout=15_000)
        page.get_by_text("Finding motifs", exact=True).wait_for(timeout=5_000)
        words = page.locator(".running .job-words")
        page.evaluate("window.awaited = document.querySelector('.running')")
        expect(words).not_to_have_text(words.inner_text(timeout=5_000), timeout=15_000)
        return page.evaluate("awaited.isConnected")  # it is the same all the time, and can be clicked
    except (AssertionError, Error):
        return False


def slow_job(workspace):
    from webapp import jobs

    return jobs.start(workspace, analyses.Request("long", "demo", SLOW))


def test_progress_is_seen_and_the_graph_comes_by_itself(show, workspace):
    page = show("/motifs")
    wait_for_graph(page)
    page.get_by_role("button", name="Settings").click()
    # a search is short: a page on a busy machine may look only when it is over
    seed = next((seed for seed in (7, 8, 9, 10) if progress_is_seen(page, seed)), None)
    assert seed, "no progress was seen in four searches"
    wait_for_graph(page)
    assert f"seed={seed}" in page.url
    expect(page.locator(".job")).to_have_count(0, timeout=15_000)
    page.get_by_role("button", name="Earlier results").click()
    page.get_by_role("menuitem", name="Default settings").click()
    page.wait_for_function("!location.search.includes('seed')")


def test_cancel_and_run_again(show, workspace):
    page = show("/library")
    job = slow_job(workspace)
    row = page.locator(".job", has_text="Demo: long")
    cancel = row.get_by_role("button", name="Cancel")
    cancel.focus()
    expect(row.locator(".job-percent")).to_contain_text("%", timeout=PATIENCE)
    page.evaluate(
        "dash_clientside.set_props('notices', {sendNotifications: ['a', 'b', 'c'].map(title => "
        "({action: 'show', title, message: 'Long. '.repeat(99), autoClose: false}))})"
    )
    expect(page.get_by_role("alert")).to_have_count(3)
    expect(cancel).to_be_focused()  # the row is the same as before it moved on
    cancel.click()  # and no notice lies over it
    expect(page.locator(".job")).to_have_count(0, timeout=20_000)
    assert workspace.jobs.get(job.id).state == "cancelled"
    again = slow_job(workspace)
    assert again.id != job.id
    expect(page.locator(".job", has_text="Demo: long")).to_be_visible(timeout=15_000)


def test_a_reload_and_a_second_tab_see_the_same_job(show, workspace, address):
    page = show("/motifs")
    slow_job(workspace)
    expect(page.locator(".job")).to_be_visible(timeout=15_000)
    page.reload()
    expect(page.locator(".job", has_text="Demo: long")).to_be_visible(timeout=20_000)
    second = show("/library")
    expect(second.locator(".job", has_text="Demo: long")).to_be_visible(timeout=20_000)
    second.locator(".job").get_by_role("button", name="Cancel").click()
    expect(page.locator(".job")).to_have_count(0, timeout=20_000)


def test_the_button_works_after_a_reload_in_the_middle_of_a_search(show, workspace):
    page = show("/motifs")
    wait_for_graph(page)
    find_anew(page, seed=11)
    page.wait_for_function("location.search.includes('seed=11')")
    page.reload()
    wait_for_graph(page)
    expect(page.locator("#find-motifs")).to_be_enabled()
    assert "seed=11" in page.url


def test_a_dead_worker_is_noticed_and_can_be_replaced(show, workspace):
    page = show("/library")
    job = slow_job(workspace)
    expect(page.locator(".job", has_text="Demo: long")).to_be_visible(timeout=15_000)
    deadline = time.monotonic() + 20
    while workspace.jobs.get(job.id).pid is None and time.monotonic() < deadline:
        time.sleep(0.1)
    psutil.Process(workspace.jobs.get(job.id).pid).kill()
    failed = page.locator(".job-failed", has_text="Demo: long")
    expect(failed).to_contain_text("worker stopped", timeout=20_000)
    failed.get_by_role("button", name="Try again").click()
    expect(page.locator(".job:not(.job-failed)", has_text="Demo: long")).to_be_visible(timeout=PATIENCE)
