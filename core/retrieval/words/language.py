"""What people type, as a tree of words: "walk then turn left", "wave with both hands without walking"."""

from __future__ import annotations

import re
from dataclasses import dataclass
from difflib import get_close_matches

from core.errors import ParameterError
from core.retrieval.words.vocabulary import SAME, word

MOST = 400  # characters of a text
_NUMBERS = {"twice": 2, "thrice": 3, "two": 2, "three": 3, "four": 4, "five": 5, "six": 6, "once": 1, "one": 1}
_IRREGULAR = {
    "ran": "run", "sat": "sit", "lay": "lie", "lying": "lie", "lies": "lie", "fell": "fall", "fallen": "fall",
    "threw": "throw", "thrown": "throw", "stood": "stand", "bent": "bend", "rose": "rise", "risen": "rise",
    "spun": "spin", "crept": "creep", "swung": "swing", "got": "get", "held": "hold", "knelt": "kneel", "hung": "hang",
    "went": "go", "hit": "hit", "struck": "strike", "leapt": "leap", "took": "take", "came": "come", "shot": "shoot",
    "bye-bye": "byebye", "goodbye": "bye", "feet": "foot", "raising": "raise", "carries": "carry", "carried": "carry",
}  # fmt: skip
_SKIPPED = {
    "a", "an", "the", "his", "her", "their", "its", "own", "person", "someone", "somebody", "man", "woman", "he",
    "she", "they", "it", "is", "are", "was", "be", "being", "to", "of", "in", "on", "at", "this", "that", "very",
    "hand", "hands", "arm", "arms", "leg", "legs", "foot", "feet", "performs", "does", "do", "doing", "direction",
    "side", "s", "by", "from", "into", "for", "or", "something", "ground", "air", "off", "uneven", "terrain",
    "upward", "upwards", "downward", "self", "degree", "degrees",
}  # fmt: skip
_JOINED = frozenset(("while", "with", "as", "then"))
_COUNTED = re.compile(r"\b(two|three|four|five|six)\b (?!hand|arm|leg|feet|foot|knee)(?=\w)")
_TIMES = re.compile(r"\b(twice|thrice|(?:once|one|two|three|four|five|six|\d{1,2})(?: ?x| times| time))(?!\w)")


@dataclass(frozen=True)
class Term:
    """A word and what is said of it: its side ("left", "right", "both"), how often it is seen, or others instead."""

    name: str
    side: str | None = None
    times: int | None = None
    instead: tuple[str, ...] = ()

    @property
    def text(self) -> str:
        """As one would say it."""
        times = {None: "", 2: " twice"}.get(self.times, f" {self.times} times")
        return f"{' or '.join((self.name, *self.instead))}{f' {self.side}' if self.side else ''}{times}"


@dataclass(frozen=True)
class Moment:
    """What is seen at one time: words together, without others; ``alongside``: others in the same stretch."""

    terms: tuple[Term, ...]
    without: tuple[Term, ...] = ()
    alongside: tuple[Moment, ...] = ()

    @property
    def all(self) -> tuple[Term, ...]:
        """All words that are to be seen."""
        return self.terms + tuple(term for moment in self.alongside for term in moment.all)


@dataclass(frozen=True)
class Sentence:
    """Moments one after another; unknown: words that are not of the vocabulary; near: words like each of them."""

    text: str
    moments: tuple[Moment, ...]
    unknown: tuple[str, ...]
    near: tuple[tuple[str, ...], ...]

    @property
    def terms(self) -> tuple[Term, ...]:
        """All words that are to be seen."""
        return tuple(term for moment in self.moments for term in moment.all)


def parse(text: str) -> Sentence:
    """A text as a sentence. Raises ParameterError where it is empty or too long."""
    if not text.strip():
        raise ParameterError("say what to look for in words, such as 'walk then turn left'")
    if len(text) > MOST:
        raise ParameterError(f"words of at most {MOST} characters, not {len(text)}")
    spaced = re.sub(r"(?<=[a-z])(?=[A-Z])", " ", text).replace("_", " ").replace("’", "").replace("/", " or ")
    clean = re.sub(r"[^\w\s,;>-]", " ", spaced.lower())
    parts = re.split(r"\s*(?:[;>]|,? and then |,? then |followed by|\bbefore\b)\s*", f" {clean} ")
    unknown: list[str] = []
    moments = [moment for part in parts if (moment := _moment(part, unknown))]
    found = tuple(dict.fromkeys(unknown))
    known = sorted(SAME)
    near = tuple(tuple(dict.fromkeys(get_close_matches(w, known, 3, 0.6))) for w in found)
    return Sentence(text, tuple(moments), found, near)


def _moment(text: str, unknown: list[str]) -> Moment | None:
    kept, *left_out = re.split(r"\b(?:without|but not|not|no|never)\b", text)
    together = [terms for part in re.split(r",|\band\b|\bplus\b", kept) if (terms := _terms(part, unknown))]
    without = tuple(term for part in left_out for term in _terms(part, unknown))
    if not together:
        return Moment((), without) if without else None
    first, *others = together
    return Moment(first, without, tuple(Moment(terms) for terms in others))


def _terms(text: str, unknown: list[str]) -> tuple[Term, ...]:
    """The words of a stretch of text; sides and numbers go to the words they are said of."""
    times, found = None, _TIMES.search(text) or _COUNTED.search(text)
    if found:
        first = found[1].split()[0].rstrip("x")
        times = int(first) if first.isdigit() else _NUMBERS[first]
        text = text.replace(found[0], " ", 1)
    tokens = [token for token in re.split(r"[\s,]+", text.strip()) if token.strip("-") and token not in _JOINED]
    tokens = [piece for t in tokens for piece in (t.split("-") if t not in SAME else [t]) if piece]
    side = "both" if {"both", "two"} & set(tokens) and times is None else None
    left, right = "left" in tokens, "right" in tokens
    side = "both" if left and right else "left" if left else "right" if right else side
    names: list[str] = []
    at = 0
    while at < len(tokens):
        for size in (3, 2, 1):
            name = _known(tokens[at : at + size])
            if name and at + size <= len(tokens):
                names.append(name)
                at += size
                break
        else:
            token = tokens[at]
            if (
                token not in _SKIPPED
                and token not in ("left", "right", "both", "two")
                and base_form(token) not in _SKIPPED
            ):
                unknown.append(token)
            at += 1
    names = _specified(names, tokens)
    if "or" in tokens and names:
        return (Term(names[0], side if word(names[0]).sided else None, times, tuple(names[1:])),)
    return tuple(
        Term(name, side if word(name).sided else None, times if k == 0 else None) for k, name in enumerate(names)
    )


def _specified(names: list[str], tokens: list[str]) -> list[str]:
    """Words that a side or a limb beside them changes: raise (a leg), walk (to the left)."""
    limbs = {"leg", "legs", "foot", "feet"} & set(tokens)
    names = ["raise leg" if name in ("raise", "raised") and limbs else name for name in names]
    if "raised" in names and "up" in tokens and len(set(names)) > 1 and "raised" not in tokens:
        names = [name for name in names if name != "raised"]  # "scoop up" says nothing of hands that are up
    if "knee" in tokens and "raise" in names:
        names.remove("raise")
    sideless = names and not any(word(name).sided for name in names)
    if sideless and {"left", "right"} & set(tokens) and {"walk", "move", "run"} & set(names):
        names.append("sideways")
    return list(dict.fromkeys(names))


def _known(tokens: list[str]) -> str | None:
    plain = " ".join(tokens)
    for text in (plain, " ".join([*map(base_form, tokens)]), " ".join([base_form(tokens[0]), *tokens[1:]])):
        if text in SAME:
            return SAME[text]
    return None


def base_form(token: str) -> str:
    """A word without the ending of its form: walking, walks, walked -> walk."""
    if token in SAME:
        return token
    if token in _IRREGULAR:
        return _IRREGULAR[token]
    for ending in ("ing", "ed", "es", "s", "er", "ly"):
        stem = token.removesuffix(ending)
        if stem != token and len(stem) > 1:
            for form in (stem, stem + "e", stem[:-1] if len(stem) > 2 and stem[-1] == stem[-2] else stem, stem + "y"):
                if form in SAME or form in _IRREGULAR:
                    return form if form in SAME else _IRREGULAR[form]
                if any(form == each.split()[0] for each in SAME):
                    return form
    return token
