"""The actions of a data set, and every clip as a string of them: what assets/grammar/*.mjs draw."""

from __future__ import annotations

import io
from collections.abc import Mapping, Sequence
from typing import Any
from urllib.parse import quote, urlencode

from core.mocap.clip import Segment
from core.mocap.dataset import Dataset
from core.spreadsheets import SheetWriter
from core.workspace import MotifNote
from webapp.shell.names import Colour
from webapp.ui.brief_names import brief_names
from webapp.ui.tables import labels_by_clip, majority_label, strip_address
from webapp.ui.timeline import motif_colour

action_colour = motif_colour
"""Colours of actions, the same in all views."""

Notes = Mapping[int, MotifNote]


def action_name(action: int, notes: Notes) -> str:
    """The name that someone gave to an action, or its number."""
    return (notes[action].name if action in notes else "") or f"Action {action}"


def short_name(action: int, notes: Notes) -> str:
    """The text for a small box: the name that someone gave to an action, or its number alone."""
    return (notes[action].name if action in notes else "") or str(action)


def ink_on(colour: str) -> str:
    """Black or white, whichever reads better on a colour like ``#4a7cd8``; as on the Stage's bands."""
    red, green, blue = (int(colour[at : at + 2], 16) for at in (1, 3, 5))
    return "#10151d" if 0.3 * red + 0.59 * green + 0.11 * blue > 140 else "#ffffff"


def tones(actions: int) -> dict[int, str]:
    """The colours of all actions."""
    return {k: action_colour(k) for k in range(actions)}


def actions_data(
    dataset: Dataset, segments: Sequence[Sequence[Segment]], medoids: Sequence[Segment], notes: Notes
) -> list[dict[str, Any]]:
    """An entry for each action, in order; see ``names.Action``.

    segments: those of each action; medoids: the most typical one of each.
    """
    by_clip = labels_by_clip(dataset)
    rates = {clip.name: clip.fps for clip in dataset.clips}
    entries = []
    for action, (occurrences, typical) in enumerate(zip(segments, medoids, strict=True)):
        label = majority_label(occurrences, by_clip)
        named = action in notes and bool(notes[action].name)
        seconds = sum(s.n_frames / rates[s.clip] for s in occurrences) / len(occurrences)
        entries.append(
            {
                "id": action,
                "name": action_name(action, notes),
                "short": short_name(action, notes),
                "named": named,
                "hint": "" if named else _hint(label),
                "colour": action_colour(action),
                "ink": ink_on(action_colour(action)),
                "count": len(occurrences),
                "seconds": round(seconds, 2),
                "clips": len({s.clip for s in occurrences}),
                "label": label,
                "strip": strip_address(dataset.name, typical, 6, dataset.fingerprint),
                "icon": icon_address(dataset, typical),
            }
        )
    return entries


def icon_address(dataset: Dataset, segment: Segment, scheme: str = "") -> str:
    """The URL of a posture in the middle of a segment."""
    query = {"start": segment.start, "end": segment.end, "v": dataset.fingerprint[:8]}
    query |= {"scheme": scheme} if scheme else {}
    return f"/api/icon/{quote(dataset.name, safe='')}/{quote(segment.clip, safe='')}?{urlencode(query)}"


def string_rows(
    dataset: Dataset, segments: Sequence[Sequence[Segment]], cuts: Mapping[str, Sequence[int]]
) -> list[dict[str, Any]]:
    """A row for each clip, in seconds; see ``names.Row``.

    cuts: clip -> frames at which a sentence begins.
    """
    pieces: dict[str, list[list[float]]] = {clip.name: [] for clip in dataset.clips}
    rates = {clip.name: clip.fps for clip in dataset.clips}
    for action, occurrences in enumerate(segments):
        for number, (clip, start, end) in enumerate(occurrences):
            if clip in pieces:
                pieces[clip].append([_short(start / rates[clip]), _short(end / rates[clip]), action, number])
    labels: dict[str, list[list[Any]]] = {clip.name: [] for clip in dataset.clips}
    for label in dataset.labels:
        fps = rates[label.clip]
        labels[label.clip].append([_short(label.start / fps), _short(label.end / fps), label.action])
    return [
        {
            "clip": clip.name,
            "brief": brief,
            "fps": clip.fps,
            "seconds": _short(clip.seconds),
            "pieces": sorted(pieces[clip.name]),
            "cuts": [_short(frame / clip.fps) for frame in cuts.get(clip.name, ())],
            "labels": sorted(labels[clip.name]),
        }
        for clip, brief in zip(dataset.clips, brief_names(dataset.names, 18), strict=True)
    ]


def spans(segments: Sequence[Sequence[Segment]], notes: Notes, within: Segment) -> list[Colour]:
    """Coloured spans of a stretch of a clip for the Stage, in frames of the clip's own rate."""
    entries: list[Colour] = [
        {"start": start, "end": end, "colour": action_colour(action), "label": short_name(action, notes)}
        for action, occurrences in enumerate(segments)
        for clip, start, end in occurrences
        if clip == within.clip and start < within.end and end > within.start
    ]
    return sorted(entries, key=lambda span: span["start"])


def segments_csv(dataset: Dataset, segments: Sequence[Sequence[Segment]], notes: Notes) -> str:
    """A line for each segment: action, its name, frames (end exclusive), seconds and main label."""
    by_clip = labels_by_clip(dataset)
    text = io.StringIO()
    lines = SheetWriter(text)
    lines.writerow(["action", "name", "clip", "start_frame", "end_frame", "seconds", "label"])
    for action, occurrences in enumerate(segments):
        name = notes[action].name if action in notes else ""
        for segment in occurrences:
            seconds = f"{segment.n_frames / dataset.clip(segment.clip).fps:.3f}"
            label = majority_label([segment], by_clip).rpartition(" (")[0]
            lines.writerow([action, name, *segment, seconds, label])
    return text.getvalue()


def _hint(label: str) -> str:
    """The action of ``punch (83 %)``, where it covers at least half."""
    word, _, share = label.rpartition(" (")
    return word if word and int(share.split()[0]) >= 50 else ""


def _short(value: float) -> float:
    return round(float(value), 3)
