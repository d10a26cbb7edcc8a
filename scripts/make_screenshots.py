"""Take the pictures of the documentation: the app on the demo, in a headless browser.

usage: make_screenshots.py [FOLDER]      (default: docs)

Serves a fresh workspace with the demo, waits for its motif graph, selects a motif, and writes motifs.png.
"""

from __future__ import annotations

import sys
import tempfile
import threading
from pathlib import Path

from playwright.sync_api import Page, sync_playwright
from werkzeug.serving import make_server

from core.analyses import DEMO, Request, run
from core.workspace import Workspace
from webapp.app import create_app

SIZE = {"width": 1440, "height": 900}


def prepared(folder: Path) -> Workspace:
    """A workspace in ``folder`` with the demo and its motif graph."""
    workspace = Workspace(folder)
    run(workspace, Request(DEMO, "demo"))
    run(workspace, Request(DEMO, "motifs"))
    return workspace


def browser_path() -> str | None:
    """Debian's Chromium where it is, else None: Playwright's own."""
    debian = Path("/usr/bin/chromium")
    return str(debian) if debian.exists() else None


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
    with tempfile.TemporaryDirectory() as temporary, sync_playwright() as playwright:
        workspace = prepared(Path(temporary))
        server = make_server("127.0.0.1", 0, create_app(workspace.path).server, threaded=True)
        threading.Thread(target=server.serve_forever, daemon=True).start()
        browser = playwright.chromium.launch(executable_path=browser_path(), args=["--no-sandbox"])
        page = browser.new_page(viewport=SIZE)
        folder.mkdir(parents=True, exist_ok=True)
        (folder / "motifs.png").write_bytes(motifs(page, f"http://127.0.0.1:{server.port}"))
        browser.close()
        server.shutdown()


if __name__ == "__main__":
    main(Path(sys.argv[1] if len(sys.argv) > 1 else "docs"))
