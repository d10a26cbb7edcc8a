"""Routines: sentences of the hidden grammar, performed. Actions are joined by cross-fades, feet keep to the floor."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import count

import numpy as np

from core.demo.actions import RECORDED, RUN_ON, idle, perform, squat
from core.demo.gaits import gait
from core.demo.hidden_rules import ACTIONS, derive
from core.demo.motions import FPS
from core.demo.performers import PERFORMERS, Performer
from core.demo.settling import settle
from core.editing.blending import Transition, concatenate, find_transition, heading, pieces
from core.mocap.clip import Clip, Label

_GAITS = ("walk", "run")
_FADE, _SLOW_FADE, _LONGEST_FADE = 0.3, 0.45, 0.7  # seconds
_RUN_ON = 0.35  # seconds: at least so much of the run-on is kept
_PACE = 0.4  # metres a second: mean joint speed of a cross-fade between postures far apart
# how far from its end an action may be left, and how far from its start entered, in seconds
_EXITS = {"gait": 0.63, "idle": 0.33, "dance": 0.5}
_ENTRIES = {"gait": 0.63, "idle": 0.17, "dance": 0.5}
_HOME = 3.0  # metres from the start beyond which a performer turns back


@dataclass(frozen=True)
class Take:
    """One action on its way into a routine: its clip, and the (frame, action) pairs of the labels inside."""

    kind: str
    clip: Clip
    labels: tuple[tuple[int, str], ...]

    @property
    def fade(self) -> float:
        """Seconds of the cross-fade that suits it."""
        return _SLOW_FADE if self.kind == "gait" else RECORDED[self.kind].fade if self.kind in RECORDED else _FADE

    def trimmed(self, head: float | None = None, tail: float | None = None) -> Take:
        """With only as much of the run-on at its head or tail as a cross-fade of that many seconds asks for."""
        if self.kind not in RECORDED:
            return self
        cut = [0 if fade is None else round((RUN_ON - max(_RUN_ON, 0.8 * fade)) * FPS) for fade in (head, tail)]
        return replace(self, clip=self.clip.cut(cut[0], self.clip.n_frames - cut[1]))


def routines(minutes: float, seed: int, plain: bool = False) -> Iterator[tuple[Clip, tuple[Label, ...]]]:
    """Routines one by one until they last ``minutes`` together; the performers take turns.

    plain: leave feet and floor as the cross-fades left them (to measure what locking the feet does).
    """
    left = minutes * 60
    for index in count():
        if left <= 0:
            return
        rng = np.random.default_rng([seed, index])
        performer = PERFORMERS[index % len(PERFORMERS)]
        name = f"{performer.name}_{index // len(PERFORMERS) + 1:02d}"
        clip, labels, _ = perform_sentence(derive(rng), performer, rng, name, plain)
        left -= clip.seconds
        yield clip, labels


def perform_sentence(
    sentence: tuple[str, ...], performer: Performer, rng: np.random.Generator, name: str, plain: bool = False
) -> tuple[Clip, tuple[Label, ...], tuple[tuple[int, int], ...]]:
    """The sentence as one clip, a label an action, and the half-open frame ranges of the cross-fades.

    Labels meet in the middle of the cross-fades, cover every frame and do not overlap. plain: see :func:`routines`.
    Raises ValueError for an empty sentence and for an action that is none of :data:`core.demo.hidden_rules.ACTIONS`.
    """
    if not sentence or not set(sentence) <= set(ACTIONS):
        raise ValueError(f"a routine is made of {', '.join(ACTIONS)}, not of {sentence}")
    done: list[Clip] = []
    marks, seams, frames = [(0, sentence[0])], [], 0  # frames: how many are in ``done``
    current: Take | None = None
    for group in _groups(sentence):
        take = _take(group, performer, rng, current)
        if current is None:
            current = take
            marks = list(take.labels)
            continue
        current, take, fade, way = _transition(current, take)
        before, seam, after = pieces(current.clip, take.clip, way, fade, steps=not plain, floor=0.0)
        done += [piece for piece in (before, seam) if piece is not None]
        frames += (before.n_frames if before else 0) + seam.n_frames
        seams.append((frames - seam.n_frames, frames))
        middle = frames - seam.n_frames // 2
        offset = frames - seam.n_frames - way.entry
        marks += [(middle if k == 0 else at + offset, action) for k, (at, action) in enumerate(take.labels)]
        # never empty: every take outlasts the latest entry and the longest cross-fade together
        assert after is not None
        current = replace(take, clip=after)
    assert current is not None  # the sentence is not empty
    clip = concatenate([*done, current.clip], name)
    ends = [at for at, _ in marks[1:]] + [clip.n_frames]
    labels = tuple(Label(name, at, end, action) for (at, action), end in zip(marks, ends, strict=True))
    return (clip if plain else settle(clip)), labels, tuple(seams)


def _transition(a: Take, b: Take) -> tuple[Take, Take, float, Transition]:
    """Seconds and place of the cross-fade: the further apart the two postures, the longer it takes.

    Recorded actions run on at their ends for as long as the longest cross-fade; of that, only what is needed is kept.
    """
    windows = _EXITS.get(a.kind, 0.0), _ENTRIES.get(b.kind, 0.0)
    fade = max(a.fade, b.fade)
    first, second = a.trimmed(tail=fade), b.trimmed(head=fade)
    way = find_transition(first.clip, second.clip, fade, *windows)
    wanted = min(way.cost / _PACE, _LONGEST_FADE)
    if wanted > fade:
        fade, first, second = wanted, a.trimmed(tail=wanted), b.trimmed(head=wanted)
        way = find_transition(first.clip, second.clip, fade, *windows)
    return first, second, fade, way


def _groups(sentence: tuple[str, ...]) -> Iterator[tuple[str, ...]]:
    """Actions one by one, but neighbouring gaits together: they pass into one another in step."""
    k = 0
    while k < len(sentence):
        end = k + 1
        while sentence[k] in _GAITS and end < len(sentence) and sentence[end] in _GAITS:
            end += 1
        yield sentence[k:end]
        k = end


def _take(group: tuple[str, ...], performer: Performer, rng: np.random.Generator, before: Take | None) -> Take:
    action = group[0]
    if action in _GAITS:
        stages = [(stage, rng.uniform(2.8, 5.0) if stage == "walk" else rng.uniform(2.5, 4.0)) for stage in group]
        clip, starts = gait(stages, _turn(before, rng), performer, rng)
        return Take("gait", clip, tuple(zip(starts, group, strict=True)))
    if action == "idle":
        clip = idle(rng.uniform(1.6, 3.0), performer, rng)
    elif action == "squat":
        clip = squat(performer, rng)
    else:
        clip = perform(action, performer, rng)
    return Take(action, clip, ((0, action),))


def _turn(before: Take | None, rng: np.random.Generator) -> float:
    """By how much a gait turns, radians: anywhere near the start, towards it from afar."""
    turn = rng.uniform(-2.2, 2.2)
    if before is not None:
        end = before.clip.cut(before.clip.n_frames - 1, before.clip.n_frames)
        x, _, z = end.root_positions[0]
        if np.hypot(x, z) > _HOME:
            home = np.arctan2(-x, -z) - float(heading(end)[0])
            turn = np.arctan2(np.sin(home), np.cos(home)) + rng.uniform(-0.4, 0.4)
    return float(turn)
