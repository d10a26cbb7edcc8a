"""Jobs in a real browser: progress, cancel, run again, reload in the middle, a second tab, a dead worker."""

from __future__ import annotations

import psutil
import pytest
from playwright.sync_api import Page, expect

from core import analyses
from tests.browser.app import (
    PATIENCE,
    address,
    demo_workspace,
    setting,
    show,
    wait_for_graph,
    wait_for_link,
    workspace,
)
from tests.core.workspace.test_jobs import wait_for
from webapp import jobs

__all__ = ["address", "demo_workspace", "show", "workspace"]
SLOW = {"minutes": 30}  # a demo that takes minutes to make: plenty of time to look, and it is cancelled in the end


def find_anew(page: Page, seed: int = 7) -> None:
    """Asks for a graph that is not there yet."""
    page.get_by_role("button", name="Settings").click()
    setting(page, "seed").fill(str(seed))
    page.click("#motifs-run")


def slow_job(workspace):
    return jobs.start(workspace, analyses.Request("long", "demo", SLOW))


def test_progress_is_seen_and_the_graph_comes_by_itself(show, workspace, monkeypatch):
    monkeypatch.setattr(jobs.launching, "launch", lambda path: None)  # this test is the worker, at its own pace
    page = show("/motifs")
    wait_for_graph(page)
    find_anew(page)
    expect(page.locator(".job-title", has_text="Motif graph: demo")).to_be_visible()
    job = workspace.jobs.claim(workspace.jobs.newest_queued())
    words, bar = page.locator(".running .job-words"), page.locator(".running .job-progress div")
    workspace.jobs.progress(job.id, "poses", 0.25)
    expect(page.locator(".running")).to_contain_text("Finding motifs")
    expect(words).to_have_text("computing postures")
    expect(bar).to_have_attribute("style", "width: 25%;")
    page.evaluate("window.awaited = document.querySelector('.running')")
    workspace.jobs.progress(job.id, "matching", 0.5)
    expect(words).to_have_text("looking for repetitions")
    expect(bar).to_have_attribute("style", "width: 50%;")
    assert page.evaluate("awaited.isConnected")  # it is the same all the time, and can be clicked
    analyses.execute(workspace, job)
    wait_for_graph(page)
    wait_for_link(page, seed="7")
    expect(page.locator(".job")).to_have_count(0)
    page.get_by_role("button", name="Earlier results").click()
    page.get_by_role("menuitem", name="Default settings").click()
    wait_for_link(page, seed=None)


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
    expect(page.locator(".job")).to_have_count(0)
    assert workspace.jobs.get(job.id).state == "cancelled"
    again = slow_job(workspace)
    assert again.id != job.id
    expect(page.locator(".job", has_text="Demo: long")).to_be_visible()


@pytest.mark.slow
def test_a_reload_and_a_second_tab_see_the_same_job(show, workspace, address):
    page = show("/motifs")
    slow_job(workspace)
    expect(page.locator(".job")).to_be_visible()
    page.reload()
    expect(page.locator(".job", has_text="Demo: long")).to_be_visible()
    second = show("/library")
    expect(second.locator(".job", has_text="Demo: long")).to_be_visible()
    second.locator(".job").get_by_role("button", name="Cancel").click()
    expect(page.locator(".job")).to_have_count(0)


@pytest.mark.slow
def test_the_button_works_after_a_reload_in_the_middle_of_a_search(show, workspace):
    page = show("/motifs")
    wait_for_graph(page)
    find_anew(page, seed=11)
    wait_for_link(page, seed="11")
    page.reload()
    wait_for_graph(page)
    expect(page.locator("#motifs-run")).to_be_enabled()
    wait_for_link(page, seed="11")


def test_a_dead_worker_is_noticed_and_can_be_replaced(show, workspace):
    page = show("/library")
    job = slow_job(workspace)
    expect(page.locator(".job", has_text="Demo: long")).to_be_visible()
    psutil.Process(wait_for(lambda: workspace.jobs.get(job.id).pid, 60)).kill()
    # it starts by itself, once
    again = wait_for(lambda: next((new for new in workspace.jobs.list(9) if new.alive and new.id != job.id), None), 60)
    assert again.key == job.key
    psutil.Process(wait_for(lambda: workspace.jobs.get(again.id).pid, 60)).kill()
    failed = page.locator(".job-failed", has_text="Demo: long")
    expect(failed).to_contain_text("worker stopped")
    failed.get_by_role("button", name="Try again").click()
    expect(page.locator(".job:not(.job-failed)", has_text="Demo: long")).to_be_visible(timeout=PATIENCE)
