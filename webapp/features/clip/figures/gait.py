"""The gait of a clip in words and numbers, laid out by assets/clip/gait.mjs."""

from __future__ import annotations

from typing import Any

from core.editing.gait import Gait, GaitBout, Measure

MINUS = "\N{MINUS SIGN}"
HEAD = ("", "Left", "Right", "Both", "±", "Asymmetry")
_DIGITS = {"m": 2, "s": 2, "m/s": 2, "steps/min": 0}
_NAMES = {"strike": "Heel strike", "off": "Toe-off"}


def gait_table(gait: Gait, clip: str, fps: float) -> dict[str, Any]:
    """``why`` where there is no gait, else ``bouts``: {title, facts, start, end, rows: [[name, unit, left, right, both,
    spread, asymmetry]]} and ``events``: [[frame, seconds, side, name]]."""
    n = len(gait.bouts)
    return {
        "clip": clip,
        "why": gait.why,
        "head": HEAD,
        "bouts": [_bout(bout, f" ({k} of {n})" if n > 1 else "", fps) for k, bout in enumerate(gait.bouts, 1)],
        "events": [[e.frame, f"{e.frame / fps:.2f} s", e.side, _NAMES[e.kind]] for e in gait.events],
    }


def bout_words(bout: GaitBout) -> str:
    """``Walking``, ``Running backward`` ..."""
    return ("Walking" if bout.kind == "walk" else "Running") + (" backward" if bout.backward else "")


def _bout(bout: GaitBout, which: str, fps: float) -> dict[str, Any]:
    cadence, speed = (next(m for m in bout.measures if m.name == name) for name in ("Cadence", "Speed"))
    when = f"{bout.start / fps:.2f} to {bout.end / fps:.2f} s"
    return {
        "title": bout_words(bout) + which,
        "facts": f"{when} · {cadence.mean:.0f} steps/min · {speed.mean:.2f} m/s",
        "start": bout.start,
        "end": bout.end + 1,
        "rows": [_row(measure) for measure in bout.measures],
    }


def _row(measure: Measure) -> list[str]:
    sides = [_number(measure, value) for value in (measure.left, measure.right, measure.mean)]
    spread = _number(measure, measure.spread) if measure.n > 1 else ""
    return [measure.name, measure.unit, *sides, spread, _signed(measure.asymmetry)]


def _number(measure: Measure, value: float | None) -> str:
    return "" if value is None else f"{value:.{_DIGITS.get(measure.unit, 1)}f}"


def _signed(percent: float | None) -> str:
    if percent is None:
        return ""
    whole = round(percent)
    return f"{'+' if whole > 0 else MINUS if whole < 0 else ''}{abs(whole)} %"
