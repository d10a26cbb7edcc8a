"""Clips and stretches that show what a text says, seen in the motion (docs/methods/search_words.md).

Every word gives a score for every frame. Words said together hold at one time, words joined by "and" in one clip or
stretch, moments joined by "then" one after another; a word after "without" must not be seen where the others are.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from core.mocap.clip import Clip, Segment
from core.retrieval.words.language import Moment, Sentence, Term
from core.retrieval.words.signals import RATE, Signals, any_of, mean_over, most_over, signals_of
from core.retrieval.words.vocabulary import WORDS, word

SEEN = 0.5  # a score from which a word is seen
_EDGE = 0.3  # score at which what is seen begins and ends
_SHORTEST = 0.1  # seconds of what is seen, at least
_APART = 0.25  # seconds between two that are two
_NEAR = 0.8  # seconds around what happens within which other words count as at one time
_BETWEEN = 4.0  # seconds between moments that are one after another, and between words joined by "and", at most
_BESIDE = 0.4  # how much a clip is less of an answer for each other remarkable thing that it shows
_LEFT = 0.3  # share of its score that it keeps whatever else it shows
_COUNTED_OTHERWISE = 0.4  # factor of what is seen more or less often than was asked


class Place(NamedTuple):
    """Where a word is seen: frames ``[start, end)`` at the clip's own rate."""

    text: str
    start: int
    end: int
    score: float


@dataclass(frozen=True)
class WordHit:
    """A clip or a stretch, how well it is what was asked for (0 to 1), and which words were seen where."""

    segment: Segment
    score: float
    places: tuple[Place, ...]


class Seen:
    """What is seen in a clip, each word once."""

    def __init__(self, clip: Clip):
        self.clip, self.signals = clip.name, signals_of(clip)
        self.frames, self.fps = clip.n_frames, clip.fps
        self._tracks: dict[tuple[str, str | None], np.ndarray | None] = {}
        self._shown: dict[str, float] = {}

    def track(self, name: str, side: str | None) -> np.ndarray | None:
        """Scores ``(n,)`` of a word; None where this body cannot show it."""
        key = (name, side)
        if key not in self._tracks:
            self._tracks[key] = word(name).scores(self.signals, side)
        return self._tracks[key]

    def of_term(self, term: Term) -> np.ndarray | None:
        """Scores ``(n,)`` of a term."""
        tracks = [t for name in (term.name, *term.instead) if (t := self.track(name, term.side)) is not None]
        return any_of(*tracks) if tracks else None

    def shows(self, name: str) -> float:
        """How much of a marked word the clip shows, 0 to 1."""
        if name not in self._shown:
            track = self.track(name, None)
            self._shown[name] = 0.0 if track is None else _of_clip(track, word(name).lasts)
        return self._shown[name]

    def frame(self, k: int) -> int:
        """Frame of the clip's own rate."""
        return min(self.frames, round(k * self.fps / RATE))


def see(clips: Iterable[Clip]) -> list[Seen]:
    """What is seen in clips."""
    return [Seen(clip) for clip in clips]


def unknown_terms(sentence: Sentence, seen: Sequence[Seen]) -> tuple[str, ...]:
    """Words that no clip's body can show."""
    parts = {frozenset(one.signals.parts) for one in seen}
    return tuple(t.text for t in sentence.terms if not any(set(word(t.name).needs) <= have for have in parts))


def find_clips(sentence: Sentence, seen: Sequence[Seen]) -> list[WordHit]:
    """All clips, best first, each with a score from 0 to 1."""
    hits = [_clip_hit(sentence, one) for one in seen]
    return sorted(hits, key=lambda hit: (-hit.score, hit.segment.clip))


def find_stretches(sentence: Sentence, seen: Sequence[Seen]) -> list[WordHit]:
    """Stretches that show all of a sentence, best first."""
    hits = [hit for one in seen for hit in _stretches(sentence, one)]
    return sorted(hits, key=lambda hit: (-hit.score, hit.segment.clip, hit.segment.start))


def _clip_hit(sentence: Sentence, one: Seen) -> WordHit:
    whole = Segment(one.clip, 0, one.frames)
    tracks = [track for moment in sentence.moments if (track := _moment_track(moment, one)) is not None]
    if not tracks or len(tracks) < len(sentence.moments):
        return WordHit(whole, 0.0, ())
    scores = [_moment_score(moment, one) for moment in sentence.moments]
    score = min(scores) if len(tracks) == 1 else float(np.sqrt(min(scores) * _in_order(tracks)))
    names = {name for term in sentence.terms for name in (term.name, *term.instead)}
    asked = names.union(*(word(name).implies for name in names))
    alone = 1.0
    for other in WORDS:
        if other.marked and other.name not in asked and not names & set(other.implies):
            alone *= 1 - _BESIDE * one.shows(other.name)
    return WordHit(whole, score * (_LEFT + (1 - _LEFT) * alone), _places(sentence.terms, one, 0, one.signals.n))


def _moment_score(moment: Moment, one: Seen) -> float:
    """How much a clip shows a moment."""
    track = _moment_track(Moment(moment.terms, moment.without), one)
    if track is None:
        return 0.0
    lasting = all(word(term.name).lasts for term in moment.terms)
    score = _of_clip(track, lasting)
    for term in moment.terms:
        if term.times is not None:
            counted = len(_runs(one.of_term(term)))
            score *= 1.0 if counted == term.times else _COUNTED_OTHERWISE / max(1, abs(counted - term.times))
    return min([score, *(_moment_score(other, one) for other in moment.alongside)])


def _of_clip(track: np.ndarray, lasting: bool) -> float:
    peak, share = float(mean_over(track, 0.4).max()), float(track.mean())
    return 0.4 * peak + 0.6 * share if lasting else 0.85 * peak + 0.15 * share


def _moment_track(moment: Moment, one: Seen) -> np.ndarray | None:
    """Scores ``(n,)`` of a moment: its words at one time, those alongside it nearby, and none of the unwanted."""
    tracks = [track for term in moment.terms if (track := one.of_term(term)) is not None]
    if len(tracks) < len(moment.terms):
        return None
    if not tracks:
        tracks = [np.ones(one.signals.n)]
    if len(tracks) > 1:  # what happens counts for what is going on around it
        tracks = [
            t if word(term.name).lasts else most_over(t, _NEAR) for t, term in zip(tracks, moment.terms, strict=True)
        ]
    track = np.prod(tracks, axis=0) ** (1 / len(tracks))
    for other in moment.alongside:
        beside = _moment_track(other, one)
        if beside is None:
            return None
        reach = 2 * _BETWEEN
        track = any_of(np.minimum(track, most_over(beside, reach)), np.minimum(beside, most_over(track, reach)))
    for term in moment.without:
        unwanted = one.of_term(term)
        if unwanted is not None:
            track = track * (1 - most_over(unwanted, 0.5))
    return np.asarray(track)


def _in_order(tracks: Sequence[np.ndarray]) -> float:
    """How well moments are seen one after another anywhere, the least of them counting."""
    reached = np.maximum.accumulate(mean_over(tracks[0], 0.4))
    for track in tracks[1:]:
        later = np.roll(reached, 3)
        later[:3] = 0
        reached = np.maximum.accumulate(np.minimum(later, mean_over(track, 0.4)))
    return float(reached[-1])


def _runs(track: np.ndarray | None) -> list[tuple[int, int, float]]:
    """Frames ``[start, end)`` where a word is seen, and its mean score there."""
    if track is None or not len(track):
        return []
    inside = np.concatenate([[False], track > _EDGE, [False]])
    starts, ends = np.flatnonzero(~inside[:-1] & inside[1:]), np.flatnonzero(inside[:-1] & ~inside[1:])
    merged: list[list[int]] = []
    for start, end in zip(starts.tolist(), ends.tolist(), strict=True):
        if merged and start - merged[-1][1] < _APART * RATE:
            merged[-1][1] = end
        else:
            merged.append([start, end])
    found = [(start, end, float(track[start:end].mean())) for start, end in merged]
    return [(s, e, m) for s, e, m in found if track[s:e].max() >= SEEN and e - s >= _SHORTEST * RATE]


def _stretches(sentence: Sentence, one: Seen) -> list[WordHit]:
    chains: list[tuple[int, int, float]] | None = None
    for moment in sentence.moments:
        runs = _runs(_moment_track(moment, one))
        for term in moment.terms:
            if term.times is not None:
                runs = _in_a_row(runs, term.times)
        chains = runs if chains is None else _then(chains, runs)
    hits = []
    for start, end, score in chains or []:
        segment = Segment(one.clip, one.frame(start), max(one.frame(end), one.frame(start) + 1))
        hits.append(WordHit(segment, score, _places(sentence.terms, one, start, end)))
    return hits


def _in_a_row(runs: list[tuple[int, int, float]], times: int) -> list[tuple[int, int, float]]:
    """Stretches of ``times`` runs close after one another; of more in a row each counts less."""
    rows: list[list[tuple[int, int, float]]] = []
    for run in runs:
        if rows and run[0] - rows[-1][-1][1] <= _BETWEEN / 2 * RATE:
            rows[-1].append(run)
        else:
            rows.append([run])
    found = []
    for row in rows:
        if len(row) >= times:
            factor = 1.0 if len(row) == times else _COUNTED_OTHERWISE
            found.append((row[0][0], row[times - 1][1], factor * min(run[2] for run in row[:times])))
    return found


def _then(before: list[tuple[int, int, float]], after: list[tuple[int, int, float]]) -> list[tuple[int, int, float]]:
    """Pairs of runs one after another: each later run with the best earlier one that ends soon before it."""
    found = []
    for start, end, score in after:
        fitting = [
            b for b in before if b[0] < start and b[1] < end and -0.5 * (end - start) <= start - b[1] <= _BETWEEN * RATE
        ]
        if fitting:
            first = max(fitting, key=lambda b: (b[2], b[0]))
            found.append((first[0], end, float(np.sqrt(first[2] * score))))
    return found


def _places(terms: Sequence[Term], one: Seen, start: int, end: int) -> tuple[Place, ...]:
    """Where each word is seen within frames ``[start, end)``."""
    places = []
    for term in terms:
        for first, last, score in _runs(one.of_term(term)):
            low, high = max(first, start), min(last, end)
            if low < high:
                places.append(
                    Place(term.text, one.frame(low), max(one.frame(high), one.frame(low) + 1), round(score, 3))
                )
    return tuple(places)


__all__ = ["Place", "Seen", "Signals", "WordHit", "find_clips", "find_stretches", "see", "unknown_terms"]
