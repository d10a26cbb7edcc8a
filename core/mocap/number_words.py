"""Words that stand for numbers in ways that no number is written: glued together, with a comma, or for "no value"."""

from __future__ import annotations

import re

_NUMBER = r"[+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?"
_PLAIN = re.compile(_NUMBER)
_GLUED = re.compile(rf"{_NUMBER}(?:(?=[+-]){_NUMBER})+")
_PARTS = re.compile(_NUMBER)
_MISSING = re.compile(r"[+-]?(nan(\(.*\))?|inf(inity)?|[0-9]\.?#(ind|qnan|snan|inf)\S*|null|none|n/?a)", re.IGNORECASE)


def is_missing(word: str) -> bool:
    """Whether a word says that there is no value: nan, inf, -1.#IND, null ..."""
    return _MISSING.fullmatch(word) is not None


def is_numeric(word: str) -> bool:
    """Whether a word begins as a number does."""
    return word[:1].isdigit() or (word[:1] in "+-." and word[1:2].isdigit()) or word[:2] in ("-.", "+.")


def numbers_in(word: str, decimal_commas: bool = False) -> list[float] | None:
    """The numbers in a word: one, several without a space between them (``0-75``), NaN for a missing one.

    decimal_commas: ``1,5`` is one and a half; else commas separate numbers. None where the word is anything else.
    """
    if _PLAIN.fullmatch(word):
        return [float(word)]
    if "," in word:
        if decimal_commas:
            word = word.replace(",", ".")
        else:
            parts = [numbers_in(part) for part in word.split(",") if part]
            return None if not parts or None in parts else [value for part in parts for value in part or ()]
        if _PLAIN.fullmatch(word):
            return [float(word)]
    if is_missing(word):
        return [float("nan")]
    return [float(part) for part in _PARTS.findall(word)] if _GLUED.fullmatch(word) else None
