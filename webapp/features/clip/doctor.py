"""What was found odd about the clip: in words with repairs, and as marks on the time line that play on click."""

from __future__ import annotations

from collections.abc import Sequence

from dash import Dash, Input, html, set_props
from dash.development.base_component import Component

from core import requests
from core.editing.repairs import Repair, repairs_for
from core.errors import MotionscapeError
from core.mocap.clip import Clip
from core.mocap.dataset import Dataset
from core.mocap.reports import Finding
from core.workspace import Workspace
from webapp.features.clip.figures import curves as figures
from webapp.features.clip.names import CLIP_REPAIR
from webapp.jobs import changes
from webapp.shell.buttons import sends
from webapp.shell.messages import notice
from webapp.shell.names import NOTICES, SELECTION
from webapp.ui.doubts import kind_words
from webapp.ui.tables import clock

AROUND = 0.5  # seconds that are played before and after what was found
_SHORT = 0.02  # share of the clip below which a stretch is too narrow to be seen, and gets a mark
_MOST_REPAIRED = 100  # findings that have buttons
HINTS = {
    "fill": "The shortest way from the frame before to the frame behind",
    "smooth": "Evens out these frames and a third of a second around",
    "cut": "Labels move along with the frames that stay",
    "turn": "Turns the clip so that this axis of its file points up",
    "rescale": "Reads the lengths of the file in another unit",
    "mirror": "Turns the clip over, so that left is left again",
}
COLOURS = {"light": "#b3701a", "dark": "#e9b866"}


def around(finding: Finding, clip: Clip) -> tuple[int, int] | None:
    """The frames that are played for a finding, with half a second on either side; None where it names no frames."""
    if finding.start is None:
        return None
    room = max(round(AROUND * clip.fps), 1)
    end = finding.end if finding.end is not None else finding.start + 1
    return max(finding.start - room, 0), min(end + room, clip.n_frames)


def bands(findings: Sequence[Finding], clip: Clip, scheme: str) -> list[figures.Band]:
    """Findings at their frames, in as few bands as possible; none where none names frames."""
    blocks = [
        figures.Block(finding.start, _end(finding), kind_words(finding.kind), COLOURS[scheme], around(finding, clip))
        for finding in findings
        if finding.start is not None
    ]
    short = _SHORT * clip.n_frames
    return [
        figures.Band(
            "Doubts" if band.title else "",
            band.blocks,
            tuple(
                figures.Mark((block.start + block.end) // 2, "diamond", block.colour, block.text)
                for block in band.blocks
                if block.end - block.start <= short
            ),
        )
        for band in figures.lanes("Doubts", blocks)
    ]


def _end(finding: Finding) -> int:
    return finding.end if finding.end is not None else (finding.start or 0) + 1


def panel(findings: Sequence[Finding], clip: Clip, dataset: Dataset) -> list[Component]:
    """All findings in words, in the order of their frames; those of the whole clip first. Beside each its repairs.

    dataset: the one that the clip is in.
    """
    if not findings:
        return [html.Div("Nothing odd was found in this clip.", className="muted")]
    ordered = sorted(findings, key=lambda finding: -1 if finding.start is None else finding.start)
    rows = []
    for k, finding in enumerate(ordered):
        repairs = repairs_for(clip, finding, findings) if k < _MOST_REPAIRED else ()
        buttons = [_repair_button(repair, clip, dataset) for repair in repairs]
        rows.append(html.Li([_row(finding, clip), html.Div(buttons, className="doubt-repairs for-editors")]))
    return [html.Ul(rows, className="doubt-list", tabIndex="0")]


def _repair_button(repair: Repair, clip: Clip, dataset: Dataset) -> Component:
    what: dict[str, object] = {"dataset": dataset.name, "version": dataset.fingerprint, "clip": clip.name}
    what |= {"action": repair.action, "start": repair.start, "end": repair.end, "value": repair.value}
    return html.Button(
        repair.words, className="doubt-repair", title=HINTS[repair.action], **sends(CLIP_REPAIR, what, every_time=True)
    )


def _row(finding: Finding, clip: Clip) -> Component:
    words = [
        html.Span(kind_words(finding.kind), className="verdict verdict-warning doubt-kind"),
        html.Span(finding.message[:1].upper() + finding.message[1:], className="doubt-words"),
    ]
    played = around(finding, clip)
    if played is None or finding.start is None:
        return html.Div([*words, html.Span("whole clip", className="muted doubt-frames")], className="doubt")
    frames = (
        f"frame {finding.start}"
        if _end(finding) - finding.start == 1
        else f"frames {finding.start} to {_end(finding) - 1}"
    )
    where = html.Span(f"{clock(finding.start / clip.fps)} · {frames}", className="muted number doubt-frames")
    start, end = played
    return html.Button(
        [*words, where],
        className="doubt doubt-plays",
        title="Plays these frames on the Stage, with half a second around",
        **sends(SELECTION, {"clip": clip.name, "start": start, "end": end}),
    )


def register(app: Dash, workspace: Workspace) -> None:
    """Registers the repairs; webapp/jobs/changes.py announces their end and undoes them."""

    @app.callback(Input(CLIP_REPAIR, "data"), prevent_initial_call=True)
    def repair(request):
        if not request:
            return
        one = {key: request[key] for key in ("clip", "action", "start", "end", "value")}
        try:
            changes.start(workspace, requests.repair_request(request["dataset"], [one], request["version"]))
        except MotionscapeError as error:
            set_props(NOTICES, {"sendNotifications": [notice("That did not work", str(error), "red")]})
