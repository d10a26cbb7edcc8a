"""A report: blocks of a data set as one HTML file that opens from disk, plays, and asks no network for anything."""

from __future__ import annotations

import base64
import json
import time
from collections.abc import Sequence
from html import escape
from importlib.metadata import PackageNotFoundError, version
from typing import Any, NamedTuple

from core.export.packed_motion import PackedMotion, pack_motion
from core.mocap.dataset import Dataset
from core.mocap.posture_drawing import drawn_positions
from core.progress import Report as Progress
from core.progress import silent
from core.workspace import Workspace
from webapp.features.boards.parts import OVERVIEW, Part, fill, segments_of
from webapp.shell.assets import PARTS, assets_folder
from webapp.shell.routes import Interval
from webapp.stage.motion_routes import motion_header

MOST_BYTES = 5_000_000  # of the whole file, where its drawings leave room for motion
LEAST_MOTION = 300_000  # bytes of motion that are packed even beside large drawings
POLICY = "default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; img-src data:"


class ReportFile(NamedTuple):
    """The text of the file; what it could not show, a sentence each; and what it says of its motion."""

    html: str
    left_out: tuple[str, ...]
    motion: str

    @property
    def size(self) -> int:
        """Bytes of the file."""
        return len(self.html.encode())


def make_report(
    workspace: Workspace, name: str, parts: Sequence[Part] = OVERVIEW, title: str = "", report: Progress = silent
) -> ReportFile:
    """The report of the data set ``name``. Raises WorkspaceError where there is none, Cancelled from ``report``."""
    dataset = workspace.open(name)
    filled = []
    for k, part in enumerate(parts):
        report("drawing", k / len(parts))
        filled.append(fill(workspace, dataset, part))
    shown = [one for one in filled if one.content is not None]
    content: dict[str, Any] = {
        "title": title or f"{name}: overview",
        "dataset": name,
        "made": time.strftime("%Y-%m-%d %H:%M"),
        "version": _version(),
        "parts": [
            {"kind": p.kind, "title": p.title, "note": p.note, "columns": p.columns, "content": one.content}
            for one in shown
            for p in [one.part]
        ],
    }
    frame = _page(content, "", "")
    room = max(LEAST_MOTION, (MOST_BYTES - len(frame.encode()) - 20_000) * 3 // 4)
    packed = pack_motion(dataset, segments_of(shown, dataset), room, report)
    words = motion_words(packed)
    content["motion"] = {"bodies": _bodies(dataset, packed), "pieces": _pieces(packed), "words": words}
    html = _page(content, base64.b64encode(packed.data).decode(), words)
    return ReportFile(html, tuple(one.problem for one in filled if one.content is None), words)


def motion_words(packed: PackedMotion) -> str:
    """What a report says of its motion: how much, at what rate, how far off."""
    if not packed.pieces:
        return "It holds no motion."
    steps = sorted({piece.step for piece in packed.pieces})
    kept = "all frames" if steps == [1] else f"every {' or '.join(map(str, steps))}th frame"
    words = (
        f"It holds {kept}, rounded to millimetres: a joint lies at most {1000 * packed.error:.1f} mm from where it was "
        "recorded"
    )
    if steps != [1]:
        words += (
            f", and between those frames, which are joined by straight lines, at most {1000 * packed.between:.0f} mm"
        )
    words += "."
    if packed.left_out:
        words += f" {len(packed.left_out):,} stretches of motion found no room and do not play."
    return words


def _bodies(dataset: Dataset, packed: PackedMotion) -> dict[str, Any]:
    bodies = {}
    for clip in (dataset.clip(name) for name in dict.fromkeys(p.segment.clip for p in packed.pieces)):
        _, body, measured = drawn_positions(clip, 0, 1)
        bodies[clip.name] = motion_header(Interval(dataset, clip, 0, clip.n_frames), 1, clip.n_frames, body, measured)
    return bodies


def _pieces(packed: PackedMotion) -> list[dict[str, Any]]:
    return [
        {**p.segment._asdict(), "step": p.step, "frames": p.frames, "unit": p.unit, "origin": p.origin}
        for p in packed.pieces
    ]


def _page(content: dict[str, Any], motion: str, words: str) -> str:
    parts = assets_folder() / PARTS
    script, styles = ((parts / f"report.{kind}").read_text(encoding="utf-8") for kind in ("js", "css"))
    title, made = escape(content["title"]), escape(f"{content['dataset']} · {content['made']}")
    return f"""<!doctype html>
<html lang="en" data-mantine-color-scheme="light">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="{POLICY}">
<title>{title}</title>
<style>{styles}</style>
</head>
<body>
<main class="report">
<header class="report-top">
<h1>{title}</h1><span class="muted">{made}</span><button class="report-scheme" type="button">Dark</button>
</header>
<div class="report-blocks"></div>
<footer class="report-foot">
<p>{escape(words)}</p><p>Made by Motionscape {escape(content["version"])}. This file needs no network.</p>
</footer>
</main>
<aside class="report-player" aria-label="Player"></aside>
<script type="application/json" data-part="report">{_in_script(content)}</script>
<script type="text/plain" data-part="motion">{motion}</script>
<script>{script}</script>
</body>
</html>
"""


def _in_script(content: dict[str, Any]) -> str:
    """JSON that cannot end the script that it stands in."""
    text = json.dumps(content, ensure_ascii=False, separators=(",", ":"))
    return text.replace("<", "\\u003c")


def _version() -> str:
    try:
        return version("motionscape")
    except PackageNotFoundError:
        return ""
