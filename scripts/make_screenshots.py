"""Take the pictures of the documentation: the app on the demo, in a headless browser.

usage: python -m scripts.make_screenshots [FOLDER]      (default: docs)

Serves a fresh workspace with the demo, waits for its motif graph, selects a motif, and writes motifs.png.
"""

from __future__ import annotations

import sys
import tempfile
from pathlib import Path

from playwright.sync_api import Page, sync_playwright

from core.analyses import DEMO, Request, run
from core.workspace import Workspace
from tests.browser.start import running, start_chromium
from webapp.app import create_app

SIZE = {"width": 1440, "height": 900}


def prepared(folder: Path) -> Workspace:
    """A workspace in ``folder`` with the demo and its motif graph."""
    workspace = Workspace(folder)
    run(workspace, Request(DEMO, "demo"))
    run(workspace, Request(DEMO, "motifs"))
    return workspace


def motifs(page: Page, address: str) -> bytes:
    """PNG of the Motifs page with a motif of several long motions playing."""
    page.goto(f"{address}/motifs?dataset={DEMO}")
    page.locator(".ag-row").first.wait_for()
    page.locator(".ag-row[row-index='3']").first.click()
    page.wait_for_function("window.motionscapeStage.figures > 1")
    page.evaluate("window.scrollTo(0, 0); document.querySelectorAll('*').forEach(e => { e.scrollTop = 0; })")
    page.wait_for_timeout(900)
    return page.screenshot()


def main(folder: Path) -> None:
    """Write the pictures into ``folder``."""
    folder.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as temporary, sync_playwright() as playwright:
        application = create_app(prepared(Path(temporary)).path).server
        with running(application) as address:
            browser = start_chromium(playwright)
            (folder / "motifs.png").write_bytes(motifs(browser.new_page(viewport=SIZE), address))
            browser.close()


if __name__ == "__main__":
    main(Path(sys.argv[1] if len(sys.argv) > 1 else "docs"))
