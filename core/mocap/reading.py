"""How recordings are read where their files do not say it, or say it wrong; and the same for clips that are there."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from core.errors import ParameterError
from core.mocap.clip import Clip
from core.mocap.corrections import BodyCorrections
from core.mocap.units import guess_unit, in_words
from core.mocap.upright import find_up, turned

_GUESS = "no unit in a BVH file"  # how the note on a guessed unit begins


@dataclass(frozen=True)
class Reading:
    """What someone said about recordings, beside what their files say.

    unit: metres per unit of the files; up: the axis that points up in them (``y``, ``z``, ``-x`` ...); None: found out
    from the body. fps: frames per second; None: what the file says. body: which joints are which. points: the list
    of joints that files of points have (core.mocap.points.presets); smooth: cut-off in Hz of what they are smoothed
    with. Raises ParameterError where a number is not positive.
    """

    unit: float | None = None
    up: str | None = None
    fps: float | None = None
    body: BodyCorrections | None = None
    points: str | None = None
    smooth: float | None = None

    def __post_init__(self) -> None:
        if self.fps is not None and not 0 < self.fps < 1e6:
            raise ParameterError(f"frame rate must be positive, not {self.fps}")
        if self.smooth is not None and not 0 < self.smooth < 1e4:
            raise ParameterError(f"a cut-off must be positive, not {self.smooth} Hz")
        if self.unit is not None and not 1e-6 <= self.unit <= 1000:
            raise ParameterError(f"a unit must be from 1e-6 to 1000 metres, not {self.unit}")

    @property
    def says_something(self) -> bool:
        """Whether anything is said at all."""
        return self != Reading()


def settled(clip: Clip, how: Reading) -> Clip:
    """A clip as its reader gives it, in the unit and the way up that it has or that someone said, with a note of each.

    The frame rate has been the reader's business.
    """
    clip = with_body(clip, how.body) if how.body else clip
    clip = with_unit(clip, how.unit) if how.unit else clip
    up = how.up or find_up(clip)
    return _with_up_note(turned(clip, up), said=how.up is not None)


@dataclass(frozen=True)
class Change:
    """What is to be read otherwise in clips that are there.

    how: what was said; what it does not say stays. guess_up, guess_unit: find the way up, or the unit, out from the
    body once more.
    """

    how: Reading = Reading()
    guess_up: bool = False
    guess_unit: bool = False


def read_again(clip: Clip, change: Change) -> Clip:
    """The clip as it would be had its file been read with ``change``.

    A new rate changes how fast the frames pass, not the frames. Raises ParameterError for a correction that does not
    fit.
    """
    how = change.how
    clip = with_body(clip, how.body) if how.body else clip
    if change.guess_unit:
        skeleton = replace(clip.skeleton, offsets=clip.skeleton.offsets / clip.skeleton.unit, unit=1.0)
        guess = guess_unit(skeleton)
        clip = with_unit(clip, guess.metres, f"{_GUESS}: {guess.words}")
    elif how.unit:
        clip = with_unit(clip, how.unit)
    if change.guess_up:
        clip = _with_up_note(turned(clip, find_up(clip)), said=False)
    elif how.up:
        clip = _with_up_note(turned(clip, how.up), said=True)
    return replace(clip, fps=float(how.fps)) if how.fps else clip


def with_unit(clip: Clip, metres: float, note: str = "") -> Clip:
    """The clip in which a unit of its file is ``metres`` long."""
    factor = metres / clip.skeleton.unit
    notes = tuple(text for text in clip.notes if not text.startswith((_GUESS, "unit: ")))
    notes = (*notes, note or f"unit: {in_words(metres)}, as was said")
    if abs(factor - 1) < 1e-9:
        return replace(clip, notes=notes)
    return replace(
        clip,
        skeleton=replace(clip.skeleton, offsets=clip.skeleton.offsets.astype(float) * factor, unit=metres),
        root_positions=(np.asarray(clip.root_positions, float) * factor).astype(np.float32),
        translations={j: (np.asarray(t, float) * factor).astype(np.float32) for j, t in clip.translations.items()},
        notes=notes,
    )


def with_body(clip: Clip, body: BodyCorrections) -> Clip:
    """The clip with the corrections that are meant for its rig, in place of those it had; as it is where none are."""
    skeleton = body.applied(clip.skeleton)
    return clip if skeleton is clip.skeleton else replace(clip, skeleton=skeleton)


def _with_up_note(clip: Clip, said: bool) -> Clip:
    notes = tuple(text for text in clip.notes if not text.endswith(_TURNED))
    if clip.up == "y":
        return replace(clip, notes=notes) if notes != clip.notes else clip
    why = "as was said" if said else "as the body stands"
    return replace(clip, notes=(*notes, f"{clip.up.upper()} points up in the file, {why}{_TURNED}"))


_TURNED = ": turned so that Y does"
