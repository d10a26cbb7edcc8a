"""How recordings are read: unit, way up and frame rate, chosen on import and changed afterwards as a job."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterable
from typing import Any

import dash_mantine_components as dmc
from dash import Dash, Output, State, html
from dash.development.base_component import Component

from core import analyses, requests
from core.errors import ParameterError
from core.mocap.dataset import Dataset
from core.mocap.points.presets import PRESETS
from core.mocap.units import UNITS, in_words
from core.workspace import Workspace
from core.workspace.tasks import names_of_clips
from webapp.features.library import dialogs, names

AUTO, KEEP = "auto", "keep"
_UNITS = ("m", "cm", "mm", "dm", "in", "ft")
_UPS = ("y", "z", "x")


def controls(unit: str, up: str, fps: str, change: bool = False) -> list[Component]:
    """Controls of these ids. change: of clips that are there, so that each thing may stay as it is."""
    first = [{"value": KEEP, "label": "As it is"}] if change else []
    first += [{"value": AUTO, "label": "Find out from the body" if change else "As the body tells"}]
    units = [{"value": word, "label": f"{UNITS[word][1].capitalize()} ({word})"} for word in _UNITS]
    ups = [{"value": axis, "label": f"{axis.upper()} points up"} for axis in _UPS]
    chosen = KEEP if change else AUTO
    return [
        _select(unit, "Unit of length", first + units, chosen),
        _select(up, "Up axis", first + ups, chosen),
        dmc.NumberInput(
            id=fps,
            label="Frame rate (per second)",
            placeholder="As it is" if change else "As the file says",
            min=1,
            max=1000,
            debounce=False,
        ),
    ]


def _select(name: str, label: str, data: list[dict[str, str]], value: str) -> Component:
    return dmc.Select(id=name, label=label, data=data, value=value, allowDeselect=False, comboboxProps={"shadow": "md"})


def fold() -> Component:
    """The controls of an import, folded."""
    return html.Details(
        className="reading-fold",
        children=[
            html.Summary("Reading"),
            html.Div(
                "What a file does not say is found out from the body, and noted in the import report. "
                "AMC files name no rate; they are taken as 120 frames per second.",
                className="muted reading-hint",
            ),
            html.Div(controls(names.UPLOAD_UNIT, names.UPLOAD_UP, names.UPLOAD_FPS), className="reading-controls"),
            html.Div(
                "Files of points (TRC, C3D, CSV, NPY, NPZ, JSON) become a body. Their joints are known by name or "
                "number, and the report says how well bones of fixed lengths fit.",
                className="muted reading-hint",
            ),
            html.Div(_points_controls(), className="reading-controls"),
        ],
    )


def _points_controls() -> list[Component]:
    lists = [{"value": name, "label": preset.title} for name, preset in PRESETS.items()]
    return [
        _select(names.UPLOAD_POINTS, "Joints of points", [{"value": AUTO, "label": "As the file tells"}, *lists], AUTO),
        dmc.NumberInput(
            id=names.UPLOAD_SMOOTH,
            label="Smooth points (cut-off in Hz)",
            placeholder="Not smoothed",
            min=0.1,
            max=1000,
            debounce=False,
        ),
    ]


def options(unit: object, up: object, fps: object) -> dict[str, Any]:
    """What was chosen, as options of a request; nothing for what is left as it is. Raises ParameterError."""
    said: dict[str, Any] = {key: str(word) for key, word in (("unit", unit), ("up", up)) if word not in (None, KEEP)}
    return said if fps in (None, "") else said | {"fps": _number(fps)}


def import_options(
    unit: object, up: object, fps: object, points: object = None, smooth: object = None
) -> dict[str, Any]:
    """As :func:`options` for an import, where finding out is what happens anyway. Raises ParameterError.

    points, smooth: the list of joints of files of points, and the cut-off of their smoothing.
    """
    said = options(unit, up, fps) | {"points": points or AUTO}
    said |= {} if smooth in (None, "") else {"smooth": _number(smooth)}
    return {key: value for key, value in said.items() if value != AUTO}


def _number(value: object) -> float:
    try:
        return float(str(value))
    except ValueError:
        raise ParameterError(f"Expected a number, not {str(value)[:20]!r}.") from None


def request_for(dataset: str, clips: Collection[str], unit: object, up: object, fps: object) -> analyses.Request:
    """The request that reads ``clips`` (all where empty) of a data set otherwise.

    Raises ParameterError where nothing is to change.
    """
    said = options(unit, up, fps)
    if not said:
        raise ParameterError("Choose what is to be read otherwise.")
    return requests.reread_request(dataset, **said, **({"clips": names_of_clips(clips)} if clips else {}))


def read_now(dataset: Dataset, clips: Collection[str]) -> str:
    """How ``clips`` (all where empty) are read now, in words."""
    here = [clip for clip in dataset.clips if not clips or clip.name in clips]
    facts = (
        (in_words(clip.skeleton.unit).partition(" (")[0] for clip in here),
        (f"{clip.up.upper()} up" for clip in here),
        (f"{clip.fps:g} frames per second" for clip in here),
    )
    which = f"{len(here):,} clip{'s' if len(here) != 1 else ''} of {dataset.name}"
    return f"{which}. Read now as: {'; '.join(map(_counted, facts))}."


def _counted(words: Iterable[str]) -> str:
    """Words with how often each occurs, where there are several."""
    counts = Counter(words).most_common()
    if len(counts) == 1:
        return counts[0][0]
    named = ", ".join(f"{word} in {n:,}" for word, n in counts[:4])
    return named + (f" and {len(counts) - 4} others" if len(counts) > 4 else "")


def dialog() -> Component:
    """The dialog that changes how clips are read."""
    return dmc.Modal(
        id=names.REREAD_DIALOG,
        title="Change how it was read",
        size="lg",
        children=[
            html.Div(id=names.REREAD_NOW, className="muted reading-hint"),
            html.Div(
                controls(names.REREAD_UNIT, names.REREAD_UP, names.REREAD_FPS, change=True),
                className="reading-controls",
            ),
            html.Div(
                "Labels stay with their frames. Another rate changes how fast the frames pass, not the frames.",
                className="muted reading-hint",
            ),
            html.Div(id=names.REREAD_PROBLEM, className="form-problem", role="alert"),
            dmc.Group(dmc.Button("Read again", id=names.REREAD_DO), justify="flex-end", mt="md"),
        ],
    )


def _fill(dataset: Dataset, asked: dict[str, Any]) -> list[Any]:
    return [read_now(dataset, asked.get("clips") or ()), KEEP, KEEP, "", None]


def register(app: Dash, workspace: Workspace) -> None:
    """The callbacks of the dialog."""
    chosen = [(names.REREAD_UNIT, "value"), (names.REREAD_UP, "value"), (names.REREAD_FPS, "value")]
    filled = [Output(names.REREAD_NOW, "children"), *(Output(*one) for one in chosen)]
    filled.append(Output(names.REREAD_PROBLEM, "children"))
    dialogs.opens(app, workspace, names.REREAD_DIALOG, names.REREAD_OF, filled, _fill)
    dialogs.starts(
        app,
        workspace,
        names.REREAD_DIALOG,
        names.REREAD_DO,
        names.REREAD_PROBLEM,
        names.REREAD_OF,
        [State(*one) for one in chosen],
        lambda dataset, asked, *said: request_for(dataset.name, asked.get("clips") or (), *said),
    )
