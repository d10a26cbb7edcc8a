"""Take the pictures of the documentation: the app on the demo, in a headless browser.

usage: python -m scripts.make_screenshots [FOLDER]      (default: docs/images)

Serves a fresh workspace with the demo and the results that the pages show, and writes motifs.png, map.png, search.png
and grammar.png.
"""

from __future__ import annotations

import sys
import tempfile
from collections.abc import Callable
from pathlib import Path

from playwright.sync_api import Page, sync_playwright

from core.analyses import DEMO, Request, run
from core.workspace import Workspace
from tests.browser.start import running, start_chromium
from webapp.app import create_app

SIZE = {"width": 1440, "height": 900}
PATIENCE = 120_000  # milliseconds


def prepared(folder: Path) -> Workspace:
    """A workspace in ``folder`` with the demo and what is shown of it."""
    workspace = Workspace(folder)
    run(workspace, Request(DEMO, "demo"))
    for method in ("motifs", "map", "search", "grammar"):
        run(workspace, Request(DEMO, method))
    return workspace


def motifs(page: Page) -> None:
    """A motif of several long motions playing."""
    page.locator(".ag-row").first.wait_for()
    page.locator(".ag-row[row-index='3']").first.click()
    page.wait_for_function("window.motionscape.stage.figures > 1")


def motion_map(page: Page) -> None:
    """A key posture chosen and its first hit played."""
    page.wait_for_function("window.motionscape.map.state?.hits?.length > 0")
    page.locator("#map-play-all").click()
    page.wait_for_function("window.motionscape.stage.figures > 0")


def search(page: Page) -> None:
    """Hits of a stretch, and the first beside the query."""
    page.locator(".search-hit.explained").first.wait_for()
    page.locator(".search-open").nth(1).click()
    page.wait_for_function("window.motionscape.stage.figures > 1")


def grammar(page: Page) -> None:
    """An action with all its occurrences."""
    page.locator("#action-cards button, #action-cards [data-value]").nth(5).click()
    page.wait_for_function("window.motionscape.stage.figures > 1")


def pictures(workspace: Workspace) -> dict[str, tuple[str, Callable[[Page], None]]]:
    """Name -> link and what is done there. The map's keys and the query are postures and frames of one kick."""
    kick = next(label for label in workspace.open(DEMO).labels if label.action == "kick")
    found = run(workspace, Request(DEMO, "map"))
    nodes = found.nodes_of(kick.clip)
    scale = found.fps / found.clip_fps[found.clips.index(kick.clip)]
    at = [round((kick.start + share * (kick.end - kick.start)) * scale) for share in (0.15, 0.5)]
    keys = ",".join("-".join(map(str, nodes[frame])) for frame in at)
    return {
        "motifs": (f"/motifs?dataset={DEMO}", motifs),
        "map": (f"/map?dataset={DEMO}&keys={keys}&within=0.40", motion_map),
        "search": (f"/search?dataset={DEMO}&query={kick.clip}:{kick.start}-{kick.end}", search),
        "grammar": (f"/grammar?dataset={DEMO}", grammar),
    }


def main(folder: Path) -> None:
    """Write the pictures into ``folder``."""
    folder.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as temporary, sync_playwright() as playwright:
        workspace = prepared(Path(temporary))
        application = create_app(workspace.path).server
        with running(application) as address:
            browser = start_chromium(playwright)
            for name, (link, arrange) in pictures(workspace).items():
                page = browser.new_page(viewport=SIZE)
                page.set_default_timeout(PATIENCE)
                page.goto(f"{address}{link}")
                arrange(page)
                page.evaluate(
                    "window.scrollTo(0, 0); document.querySelectorAll('*').forEach(e => { e.scrollTop = 0; })"
                )
                page.wait_for_timeout(1500)
                page.mouse.move(SIZE["width"] / 2, 4)
                (folder / f"{name}.png").write_bytes(page.screenshot())
                page.close()
            browser.close()


if __name__ == "__main__":
    main(Path(sys.argv[1] if len(sys.argv) > 1 else "docs/images"))
