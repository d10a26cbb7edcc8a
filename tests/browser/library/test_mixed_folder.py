"""A mixed folder dropped on the Library: imported in one go, and the pages say what they leave out."""

from __future__ import annotations

from playwright.sync_api import expect

from tests.browser.app import PATIENCE, address, demo_workspace, show, workspace
from tests.core.mocap.mixed_folder import ANIMALS, PEOPLE, mixed_folder

__all__ = ["address", "demo_workspace", "show", "workspace"]


def test_a_mixed_folder_is_dropped_imported_and_looked_at(show, workspace, tmp_path):
    files = sorted(mixed_folder(tmp_path / "files").iterdir())
    page = show("/library")
    page.evaluate(
        """(files) => {
            const transfer = new DataTransfer();
            for (const [name, text] of files) transfer.items.add(new File([text], name));
            const target = document.querySelector('#page');
            for (const kind of ['dragenter', 'dragover', 'drop'])
                target.dispatchEvent(new DragEvent(kind, { dataTransfer: transfer, bubbles: true, cancelable: true }));
        }""",
        [[file.name, file.read_text(encoding="latin-1")] for file in files],
    )
    expect(page.locator("#upload-list .upload-ok")).to_have_count(len(PEOPLE) + len(ANIMALS) + 2, timeout=PATIENCE)
    page.fill("#upload-name", "mixed")
    page.click("#upload-import")
    expect(page.locator(".dataset-card.chosen")).to_contain_text("mixed", timeout=PATIENCE)
    ups = {clip.name: clip.up for clip in workspace.open("mixed").clips}
    assert len(ups) == len(PEOPLE) + len(ANIMALS) + 2
    assert {name for name, up in ups.items() if up == "z"} == {"metres", "inches", "walk with Z up"}
    for path in ("motifs", "map", "grammar"):
        page.locator(f".nav-link[href='/{path}']").click()
        expect(page.locator(f"#{path}-left-out")).to_contain_text("3 clips left out")
    page.locator(".nav-link[href='/search']").click()
    expect(page.locator("#search-left-out")).to_contain_text("people (6 clips)")
