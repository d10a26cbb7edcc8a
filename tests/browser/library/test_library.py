"""The Library page in a real browser: clips, uploads good and bad, rename, delete and undo."""

from __future__ import annotations

import re
import zipfile
from pathlib import Path

import numpy as np
import pytest
from playwright.sync_api import Page, expect

from core import analyses
from core.mocap.bvh import write_bvh
from core.workspace import Workspace
from tests.browser.app import (
    PATIENCE,
    address,
    canvas_sum,
    demo_workspace,
    show,
    wait_for_link,
    wait_for_stage,
    wait_until_moved,
    workspace,
)
from tests.browser.start import running
from tests.webapp.generated import walk
from webapp.app import create_app

__all__ = ["address", "demo_workspace", "show", "workspace"]


@pytest.fixture
def recordings(tmp_path: Path) -> list[Path]:
    """Two good files, one cut off in the middle of its skeleton, one without a number in its rows, one that is no
    recording."""
    folder = tmp_path / "recordings"
    folder.mkdir()
    for name in ("stroll", "rush"):
        write_bvh(folder / f"{name}.bvh", walk(name, seconds=1.0))
    whole = (folder / "stroll.bvh").read_text()
    (folder / "cut.bvh").write_text(whole[: whole.index("MOTION") // 2])
    start = whole.index("\n", whole.index("Frame Time:"))
    (folder / "nan.bvh").write_text(whole[:start] + re.sub(r"\S+", "nan", whole[start:]))
    (folder / "notes.pdf").write_text("hello")
    return sorted(folder.iterdir())


def choose(page: Page, files: list[Path]) -> None:
    page.click("#upload-open")
    with page.expect_file_chooser() as chooser:
        page.get_by_role("button", name="Choose files").click()
    chooser.value.set_files(files)


def test_a_clip_plays_by_mouse_and_by_keyboard(show):
    page = show("/library")
    row = page.locator("#clips-table .ag-row").first
    row.click()
    name = row.get_attribute("row-id")
    wait_for_stage(page, name)
    wait_until_moved(page, canvas_sum(page))
    expect(row).to_have_class(re.compile("row-chosen"))
    second = page.locator("#clips-table .ag-row").nth(1)
    second.locator(".ag-cell").first.focus()
    page.keyboard.press("Enter")
    wait_for_stage(page, second.get_attribute("row-id"))
    page.wait_for_function(
        """() => {
            const strip = document.querySelector('#clips-table img.filmstrip');
            return strip?.complete && strip.naturalWidth > 50;
        }"""
    )


def test_good_files_are_kept_and_bad_ones_explained(show, recordings, workspace):
    page = show("/library")
    choose(page, recordings)
    expect(page.locator("#upload-list .upload-ok")).to_have_count(4)
    expect(page.locator("#upload-summary")).to_contain_text("1 PDF left out")
    page.fill("#upload-name", "Morning session")
    page.click("#upload-import")
    expect(page.locator(".dataset-card.chosen")).to_contain_text("Morning session", timeout=PATIENCE)
    expect(page.locator(".dataset-card.chosen")).to_contain_text("2 not read")
    page.get_by_role("tab", name="Import report").click()
    report = page.locator("#report-table .ag-center-cols-container")
    expect(report).to_contain_text("cut.bvh")
    expect(report).to_contain_text("nan.bvh")
    page.get_by_text("Not read 2").click()
    expect(page.locator("#report-table .ag-center-cols-container .ag-row")).to_have_count(2)
    assert sorted(workspace.open("Morning session").names) == ["rush", "stroll"]
    assert not list((workspace.path / "uploads").iterdir())


def drop(page: Page, target: str, name: str, content: str) -> None:
    """Drops a file on the first element that ``target`` selects."""
    page.evaluate(
        """([selector, name, text]) => {
            const transfer = new DataTransfer();
            transfer.items.add(new File([text], name));
            const target = document.querySelector(selector);
            for (const kind of ['dragenter', 'dragover', 'drop'])
                target.dispatchEvent(new DragEvent(kind, { dataTransfer: transfer, bubbles: true, cancelable: true }));
        }""",
        [target, name, content],
    )


def test_what_is_dropped_is_uploaded(show, recordings):
    page = show("/library")
    drop(page, "#page", "dropped.bvh", next(path for path in recordings if path.stem == "rush").read_text())
    expect(page.locator("#upload-list .upload-ok")).to_contain_text("dropped.bvh")
    expect(page.locator("#upload-name")).to_have_value("dropped")
    expect(page.locator("#upload-target")).to_have_value("A new dataset")
    drop(page, "#drop-zone", "more.csv", "clip,action\ndropped,rush\n")
    expect(page.locator("#upload-list .upload-ok")).to_have_count(2)
    expect(page.locator("#upload-import")).to_be_enabled()


def test_recordings_and_labels_come_to_a_dataset_and_go_again(show, recordings, workspace):
    before, graph = workspace.info("demo"), analyses.stored(workspace, analyses.Request("demo", "motifs"))
    archive = recordings[0].parent / "more.zip"
    with zipfile.ZipFile(archive, "w", zipfile.ZIP_DEFLATED) as packed:
        for path in recordings:
            packed.write(path, f"in/{path.name}")
        packed.writestr("in/index.csv", "clip,content,take\nrush,hurry,1\nnobody,wait,1\n")
    page = show("/library")
    page.get_by_role("button", name="More for demo").click()
    page.get_by_role("menuitem", name="Add recordings or labels").click()
    expect(page.locator("#upload-target")).to_have_value("demo")
    with page.expect_file_chooser() as chooser:
        page.get_by_role("button", name="Choose files").click()
    chooser.value.set_files([archive])
    expect(page.locator("#upload-import")).to_have_text("Add")
    page.click("#upload-import")
    page.get_by_role("link", name="See the report").click(timeout=PATIENCE)
    rows = page.locator("#report-table .ag-center-cols-container .ag-row")
    expect(rows).to_have_count(6)  # the archive, four recordings, the index; not those that were there
    expect(page.locator("#report-table")).to_contain_text("nobody (line 3)")
    expect(page.locator(".dataset-card.chosen")).to_contain_text("2 not read")
    wait_for_link(page, files="added")
    assert {"rush", "stroll"} < set(workspace.open("demo").names) and workspace.info("demo").labels == before.labels + 1
    page.get_by_role("button", name="Undo").click()
    expect(page.locator(".dataset-card.chosen")).to_contain_text("All files read")
    assert workspace.info("demo").fingerprint == before.fingerprint
    drop(
        page,
        ".dataset-card",
        "mine.csv",
        f"clip,start_frame,end_frame,action\n{workspace.open('demo').names[0]},0,9,x\n",
    )
    expect(page.locator("#upload-target")).to_have_value("demo")
    expect(page.locator("#upload-list .upload-ok")).to_have_count(1)
    page.locator("#upload-labels").get_by_text("Replace").click()
    page.click("#upload-import")
    expect(page.locator(".dataset-card.chosen")).to_contain_text("1 label", timeout=PATIENCE)
    assert [label.action for label in workspace.open("demo").labels] == ["x"]
    assert analyses.stored(workspace, analyses.Request("demo", "motifs")) is graph  # labels are not motion


def test_clips_are_removed_and_opened_by_mouse_and_by_keyboard(show, workspace):
    before = workspace.info("demo")
    first, second = workspace.open("demo").names
    page = show("/library")
    boxes = page.locator("#clips-table .ag-row .choice-cell input")
    boxes.first.click()
    expect(page.locator("#clips-chosen")).to_contain_text("1 clip chosen")
    assert page.evaluate("motionscape.stage.status") == "empty"  # a box chooses, it does not play
    page.keyboard.press("ArrowDown")
    page.keyboard.press("Space")
    expect(page.locator("#clips-chosen")).to_contain_text("2 clips chosen")
    page.get_by_role("button", name="Remove").click()
    expect(page.get_by_text("These are all its clips")).to_be_visible()
    boxes.nth(1).click()
    page.get_by_role("button", name="Remove").click()
    expect(page.locator("#clips-table .ag-center-cols-container .ag-row")).to_have_count(1, timeout=PATIENCE)
    assert workspace.open("demo").names == (second,)
    page.get_by_role("button", name="Undo").click()
    expect(page.locator("#clips-table .ag-center-cols-container .ag-row")).to_have_count(2)
    assert workspace.info("demo").fingerprint == before.fingerprint
    page.click("#trash-open")
    expect(page.locator("#trash-list")).to_contain_text("before its last change")
    page.keyboard.press("Escape")
    expect(page.locator("#trash-list")).not_to_be_visible()
    page.locator("#clips-table .ag-cell[col-id=clip]").nth(1).focus()
    page.keyboard.press("Enter")
    page.wait_for_url(f"**/clip?dataset=demo&clip={second}*")
    wait_for_stage(page, second)
    page.go_back()
    page.locator(f"#clips-table a.clip-link[data-clip='{first}']").click()
    page.wait_for_url(f"**/clip?dataset=demo&clip={first}*")


def test_only_bad_files_end_in_a_clear_message(show, tmp_path):
    bad = tmp_path / "bad.bvh"
    bad.write_text("this is no motion")
    page = show("/library")
    choose(page, [bad])
    expect(page.locator("#upload-import")).to_be_enabled()
    page.click("#upload-import")
    failed = page.locator(".job-failed")
    expect(failed).to_contain_text("bad.bvh", timeout=PATIENCE)
    failed.get_by_role("button", name="Dismiss").click()
    expect(failed).to_have_count(0)


def test_files_that_are_too_large_are_refused_before_they_are_sent(open_page, workspace, tmp_path, monkeypatch):
    monkeypatch.setenv("MOTIONSCAPE_MAX_FILE_MB", "1")
    (tmp_path / "big.bvh").write_bytes(b"x" * (2 << 20))
    with running(create_app(workspace.path).server) as address:
        page = open_page(f"{address}/library")
        expect(page.locator("h1")).to_be_visible()
        choose(page, [tmp_path / "big.bvh"])
        expect(page.locator("#drop-zone")).to_contain_text("1 MB a file")
        expect(page.locator("#upload-list .upload-error")).to_contain_text("too large: 2.0 MB")
        expect(page.locator("#upload-import")).to_be_disabled()
        page.context.close()  # before its server goes


def test_rename_delete_and_undo(show, workspace):
    page = show("/library")
    page.get_by_role("button", name="More for demo").click()
    page.get_by_role("menuitem", name="Rename").click()
    page.fill("#rename-name", "a/b")
    page.click("#rename-save")
    expect(page.locator("#rename-problem")).to_contain_text("cannot have this name")
    page.fill("#rename-name", "first steps")
    page.click("#rename-save")
    expect(page.locator(".dataset-card")).to_contain_text("first steps")
    wait_for_link(page, dataset="first steps")
    page.get_by_role("button", name="More for first steps").click()
    page.get_by_role("menuitem", name="Delete").click()
    expect(page.get_by_text("No recordings yet")).to_be_visible()
    assert workspace.datasets() == []
    page.get_by_role("button", name="Undo").click()
    expect(page.locator(".dataset-card.chosen")).to_contain_text("first steps")
    page.get_by_role("button", name="More for first steps").click()
    page.get_by_role("menuitem", name="Delete").click()
    expect(page.get_by_text("No recordings yet")).to_be_visible()
    page.click("#trash-open")
    page.get_by_role("button", name="Restore").click()
    expect(page.locator(".dataset-card.chosen")).to_contain_text("first steps")
    assert [info.name for info in workspace.datasets()] == ["first steps"]


def test_an_empty_workspace_offers_the_demo(open_page, tmp_path):
    workspace = Workspace(tmp_path / "empty")
    with running(create_app(workspace.path).server) as address:
        page = open_page(f"{address}/")
        page.get_by_role("button", name="Open the demo").click()
        job = page.locator(".job", has_text="Demo: demo")
        expect(job).to_be_visible()
        job.get_by_role("button", name="Cancel").click()
        expect(job).to_have_count(0)
        assert workspace.jobs.list()[0].state == "cancelled"
        page.context.close()


def test_features_of_a_dataset_are_computed_and_downloaded(show):
    page = show("/library?dataset=demo")
    with page.expect_download(timeout=PATIENCE) as download:
        page.get_by_label("More for demo").click()
        page.get_by_role("menuitem", name="Features (npz)").click()
    with np.load(download.value.path(), allow_pickle=False) as found:
        assert len(found["frames"]) == len(found["poses"]) > 500 and set(found["splits"]) == {"train", "test"}
