"""Take the pictures of the documentation: the app on the demo, in a headless browser.

usage: python -m scripts.make_screenshots [FOLDER] [NAME...]      (default: docs/images, all pictures)

Serves a fresh workspace with the demo and the results that the pages show, and writes library.png, motifs.png,
walk.png, sweeps.png, map.png, search.png, grammar.png, compose.png, clip.png, groups.png and boards.png, each with at
most 256 colours.
"""

from __future__ import annotations

import io
import sys
import tempfile
from collections.abc import Callable, Collection
from pathlib import Path

from PIL import Image
from playwright.sync_api import Page, sync_playwright

from core.analyses import DEMO, Request, run
from core.demo.planted import planted_groups
from core.retrieval.queries import whole_query
from core.workspace import Workspace
from core.workspace.boards import Block
from tests.browser.start import running, start_chromium
from webapp.app import create_app
from webapp.features.groups.comparisons import request_of

SIZE = {"width": 1440, "height": 900}
PATIENCE = 120_000  # milliseconds
AXES = ("kappa:200,500,1000,2000", "rho:0.5,1,2")
SEEDS = 2
PEOPLE = "people"


def prepared(folder: Path) -> Workspace:
    """A workspace in ``folder`` with the demo and what is shown of it."""
    workspace = Workspace(folder)
    run(workspace, Request(DEMO, "demo"))
    for method in ("motifs", "map", "grammar"):
        run(workspace, Request(DEMO, method))
    index = run(workspace, Request(DEMO, "search"))
    index.search(whole_query(workspace.open(DEMO).clips[0], 0, 60), level="interval")  # compiles its kernels
    compared_people(workspace)
    run(workspace, Request(DEMO, "sweep", {"axes": ";".join(AXES), "seeds": SEEDS}))
    return workspace


def library(page: Page) -> None:
    """The demo's clips with their thumbnails."""
    page.locator(".ag-row").first.wait_for()


def walk(page: Page) -> None:
    """A walk through the graph, playing."""
    page.wait_for_function("window.motionscape.stage.figures > 0")


def sweeps(page: Page) -> None:
    """Charts of a sweep and its suggestion."""
    page.locator("#sweep-table .ag-row").first.wait_for()
    page.locator(".js-plotly-plot .xy").first.wait_for()


def clip(page: Page) -> None:
    """Curves of a clip that plays."""
    page.locator(".js-plotly-plot .xy").first.wait_for()
    page.wait_for_function("window.motionscape.stage.figures > 0")


def compose(page: Page) -> None:
    """A new routine with its tree, playing."""
    page.locator("#compose-tree svg, .tree svg").first.wait_for()
    page.wait_for_function("window.motionscape.stage.figures > 0")


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


def groups(page: Page) -> None:
    """The answer in words, with examples of both groups playing."""
    page.locator(".groups-sentence").first.click()
    page.wait_for_function("window.motionscape.stage.figures > 1")


def compared_people(workspace: Workspace) -> None:
    """Keeps two groups of people, one of which holds the arms wider, and their comparison."""
    if PEOPLE not in {info.name for info in workspace.datasets()}:
        dataset, properties = planted_groups("wider", 8, pieces=12)
        workspace.add_dataset(PEOPLE, dataset)
        workspace.properties.put(workspace.info(PEOPLE).id, properties)
    run(workspace, request_of(workspace, PEOPLE, {"by": "group"}))


def boards(page: Page) -> None:
    """A board that two people have open: Ben answers Ana, and it appears in her browser."""
    page.locator(".block-motif").nth(2).click()
    page.wait_for_function("window.motionscape.stage.figures > 1")
    page.locator("[data-block=graph] .board-head").hover()
    page.locator("[data-block=graph]").get_by_role("button", name="Comments").click()
    other = page.context.browser.new_page(viewport=SIZE)
    other.goto(page.url)
    other.evaluate("localStorage.setItem('motionscape-name', 'Ben')")
    other.locator("[data-block=graph]").get_by_role("button", name="Comments").click()
    other.get_by_role("button", name="Answer").click()
    other.get_by_label("Answer").last.fill("Yes, in all but two. @Ana: shall we call it “run”?")
    other.locator(".boards-comment form button.primary").click()
    page.locator(".boards-said").nth(1).wait_for()
    other.close()
    page.locator(".board-block").first.hover()


def shared_board(workspace: Workspace) -> str:
    """The id of a board with a question of Ana's."""
    words = "## Routines\n\nWhich movements do all three people share?\n\n- **name** the motifs\n- check the kicks"
    blocks = [
        Block("graph", "graph", 0, 0, 7, 7, {"title": "Motif graph"}),
        Block("figures", "numbers", 7, 0, 5, 3, {"options": {"figures": "clips,n_motifs,coverage"}}),
        Block("words", "text", 7, 3, 5, 4, {"options": {"markdown": words}}),
        Block("tracks", "tracks", 0, 7, 7, 5, {"title": "Labels and motifs over time"}),
        Block("map", "map", 7, 7, 5, 5, {"title": "Motion map"}),
    ]
    board = workspace.boards.create("What recurs", blocks, "Ana")
    workspace.boards.set_filters(board.id, {"dataset": DEMO}, "Ana")
    workspace.comments.add(f"board:{board.id}/block:graph", "Is this one the run, @Ben?", "Ana")
    return board.id


def pictures(workspace: Workspace) -> dict[str, tuple[str, Callable[[Page], None]]]:
    """Name -> link and what is done there. The map's keys and the query are postures and frames of one kick."""
    kick = next(label for label in workspace.open(DEMO).labels if label.action == "kick")
    demo_map = run(workspace, Request(DEMO, "map"))
    nodes = demo_map.nodes_of(kick.clip)
    scale = demo_map.fps / demo_map.clip_fps[demo_map.clips.index(kick.clip)]
    frames = [round((kick.start + share * (kick.end - kick.start)) * scale) for share in (0.15, 0.5)]
    keys = ",".join("-".join(map(str, nodes[frame])) for frame in frames)
    return {
        "library": (f"/library?dataset={DEMO}", library),
        "motifs": (f"/motifs?dataset={DEMO}", motifs),
        "walk": (f"/motifs?dataset={DEMO}&side=walk&walk=random:15:7", walk),
        "sweeps": (f"/sweeps?dataset={DEMO}&x={AXES[0]}&y={AXES[1]}&seeds={SEEDS}", sweeps),
        "map": (f"/map?dataset={DEMO}&keys={keys}&within=0.40", motion_map),
        "search": (f"/search?dataset={DEMO}&query={kick.clip}:{kick.start}-{kick.end}", search),
        "grammar": (f"/grammar?dataset={DEMO}", grammar),
        "compose": (f"/grammar?dataset={DEMO}&show=compose&sentence=random:7:8", compose),
        "boards": (f"/boards?dataset={DEMO}&board={shared_board(workspace)}", boards),
        "groups": (f"/groups?dataset={PEOPLE}&by=group", groups),
        "clip": (f"/clip?dataset={DEMO}&clip={kick.clip}", clip),
    }


def small(screenshot: bytes) -> bytes:
    """A PNG with at most 256 colours: about a third of the size, with no difference that one sees."""
    with Image.open(io.BytesIO(screenshot)) as image, io.BytesIO() as file:
        image.convert("RGB").quantize(256).save(file, "PNG", optimize=True)
        return file.getvalue()


def main(folder: Path, names: Collection[str] = ()) -> None:
    """Write the pictures of these names (all where none is given) into ``folder``."""
    folder.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as temporary, sync_playwright() as playwright:
        workspace = prepared(Path(temporary))
        application = create_app(workspace.path).server
        with running(application) as address:
            browser = start_chromium(playwright)
            for name, (link, arrange) in pictures(workspace).items():
                if names and name not in names:
                    continue
                page = browser.new_page(viewport=SIZE)
                page.set_default_timeout(PATIENCE)
                page.goto(f"{address}{link}")
                arrange(page)
                page.evaluate(
                    "window.scrollTo(0, 0); document.querySelectorAll('*').forEach(e => { e.scrollTop = 0; })"
                )
                page.wait_for_timeout(1500)
                page.mouse.move(SIZE["width"] / 2, 4)
                (folder / f"{name}.png").write_bytes(small(page.screenshot()))
                page.close()
            browser.close()


if __name__ == "__main__":
    main(Path(sys.argv[1] if len(sys.argv) > 1 else "docs/images"), sys.argv[2:])
