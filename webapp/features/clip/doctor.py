"""What was found odd about the clip: in words, and as marks on the time line that play on click."""

from __future__ import annotations

from collections.abc import Sequence

from dash import html
from dash.development.base_component import Component

from core.mocap.clip import Clip
from core.mocap.reports import Finding
from webapp.features.clip.figures import curves as figures
from webapp.shell.buttons import sends
from webapp.shell.names import SELECTION
from webapp.ui.doubts import kind_words
from webapp.ui.tables import clock

AROUND = 0.5  # seconds that are played before and after what was found
_SHORT = 0.02  # share of the clip below which a stretch is too narrow to be seen, and gets a mark
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


def panel(findings: Sequence[Finding], clip: Clip) -> list[Component]:
    """All findings in words, in the order of their frames; those of the whole clip first."""
    if not findings:
        return [html.Div("Nothing odd was found in this clip.", className="muted")]
    ordered = sorted(findings, key=lambda finding: -1 if finding.start is None else finding.start)
    return [html.Ul([_row(finding, clip) for finding in ordered], className="doubt-list", tabIndex="0")]


def _row(finding: Finding, clip: Clip) -> Component:
    words = [
        html.Span(kind_words(finding.kind), className="verdict verdict-warning doubt-kind"),
        html.Span(finding.message[:1].upper() + finding.message[1:], className="doubt-words"),
    ]
    played = around(finding, clip)
    if played is None or finding.start is None:
        return html.Li([*words, html.Span("whole clip", className="muted doubt-frames")], className="doubt")
    frames = (
        f"frame {finding.start}"
        if _end(finding) - finding.start == 1
        else f"frames {finding.start} to {_end(finding) - 1}"
    )
    where = html.Span(f"{clock(finding.start / clip.fps)} · {frames}", className="muted number doubt-frames")
    start, end = played
    return html.Li(
        html.Button(
            [*words, where],
            className="doubt doubt-plays",
            title="Plays these frames on the Stage, with half a second around",
            **sends(SELECTION, {"clip": clip.name, "start": start, "end": end}),
        )
    )
