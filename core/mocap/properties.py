"""What is known of clips beside their motion: columns such as subject, condition or session."""

from __future__ import annotations

import io
import math
import unicodedata
from collections.abc import Iterable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from datetime import date
from typing import Any, Literal

from core.errors import FormatError, ParameterError
from core.spreadsheets import SheetWriter

Kind = Literal["text", "number", "date"]
KINDS: tuple[Kind, ...] = ("text", "number", "date")
LONGEST_COLUMN, LONGEST_VALUE, MOST_COLUMNS = 60, 200, 60
_FEW = 5  # rows or clips that a remark names


@dataclass(frozen=True)
class Properties:
    """Properties of clips. columns: name -> kind, in the order in which they are shown.

    values: clip -> column -> value as text; a number as it was written, a date as YYYY-MM-DD. What is not known of a
    clip has no entry.
    """

    columns: Mapping[str, Kind] = field(default_factory=dict)
    values: Mapping[str, Mapping[str, str]] = field(default_factory=dict)

    def column(self, name: str) -> dict[str, str]:
        """Clip -> value, for the clips that have one; raises ParameterError where there is no such column."""
        if name not in self.columns:
            known = ", ".join(self.columns) or "none"
            raise ParameterError(f"There is no property {name[:LONGEST_COLUMN]!r} of clips; there are: {known}.")
        return {clip: own[name] for clip, own in self.values.items() if name in own}

    def groups(self, name: str) -> dict[str, tuple[str, ...]]:
        """Value -> the clips that have it, values in order; raises ParameterError where there is no such column."""
        clips: dict[str, list[str]] = {}
        for clip, value in self.column(name).items():
            clips.setdefault(value, []).append(clip)
        order = sorted(clips, key=lambda value: sort_key(value, self.columns[name]))
        return {value: tuple(clips[value]) for value in order}

    def of_clips(self, clips: Iterable[str]) -> Properties:
        """The properties of these clips alone; columns stay."""
        return Properties(self.columns, {clip: self.values[clip] for clip in clips if self.values.get(clip)})

    def with_values(self, values: Mapping[str, Mapping[str, str]]) -> Properties:
        """Values written over those that are there; an empty one takes its value away.

        A column that is new gets the kind that all its values fit; one whose kind the new values do not fit becomes
        text. values: clip -> column -> text. Raises ParameterError for names and values that are too long.
        """
        merged = {clip: dict(own) for clip, own in self.values.items()}
        for clip, own in values.items():
            for name, value in own.items():
                name, value = line_of(name, "name of a column", LONGEST_COLUMN), line_of(value, "value", LONGEST_VALUE)
                if not name or name == "clip":
                    raise ParameterError("A property needs a name, and not “clip”.")
                merged.setdefault(clip, {})[name] = value
        merged = {clip: {k: v for k, v in own.items() if v} for clip, own in merged.items()}
        names = dict.fromkeys([*self.columns, *(name for own in merged.values() for name in own)])
        if len(names) > MOST_COLUMNS:
            raise ParameterError(f"There are at most {MOST_COLUMNS} properties of clips; these are {len(names)}.")
        by_column = {name: [own[name] for own in merged.values() if name in own] for name in names}
        columns = {
            name: self.columns[name]
            if name in self.columns and all(fits(value, self.columns[name]) for value in own)
            else kind_of(own)
            for name, own in by_column.items()
        }
        return Properties(columns, {clip: own for clip, own in merged.items() if own})

    def without_column(self, name: str) -> Properties:
        """Without a column; raises ParameterError where there is no such column."""
        self.column(name)
        columns = {other: kind for other, kind in self.columns.items() if other != name}
        values = {clip: {k: v for k, v in own.items() if k != name} for clip, own in self.values.items()}
        return Properties(columns, {clip: own for clip, own in values.items() if own})

    def with_kind(self, name: str, kind: str) -> Properties:
        """With another kind of a column; raises ParameterError where a value does not fit it, naming the clips."""
        if kind not in KINDS:
            raise ParameterError(f"A property is one of {', '.join(KINDS)}.")
        odd = [f"{clip} ({value})" for clip, value in self.column(name).items() if not fits(value, kind)]
        if odd:
            raise ParameterError(f"“{name}” is no {kind} for {counted(odd, 'clip')}.")
        return Properties({**self.columns, name: kind}, self.values)

    def to_json(self) -> dict[str, Any]:
        """As JSON: ``columns`` and ``values``."""
        return {"columns": dict(self.columns), "values": {clip: dict(own) for clip, own in self.values.items()}}

    def to_csv(self, clips: Sequence[str]) -> str:
        """A CSV file with a row for each of ``clips``, ``clip`` first."""
        text = io.StringIO()
        writer = SheetWriter(text)
        writer.writerow(["clip", *self.columns])
        for clip in clips:
            writer.writerow([clip, *(self.values.get(clip, {}).get(name, "") for name in self.columns)])
        return text.getvalue()


def from_json(document: Mapping[str, Any]) -> Properties:
    """The properties back from :meth:`Properties.to_json`. Raises FormatError for anything else."""
    try:
        columns = {str(name): kind for name, kind in document["columns"].items() if kind in KINDS}
        values = {
            str(clip): {str(name): str(value) for name, value in own.items() if name in columns}
            for clip, own in document["values"].items()
        }
    except (KeyError, TypeError, AttributeError) as error:
        raise FormatError(f"these are no properties of clips: {error!r} is missing or misshapen") from error
    return Properties(columns, values)


def fits(value: str, kind: str) -> bool:
    """Whether a value can be of this kind."""
    if kind == "text":
        return True
    with suppress(ValueError):
        if kind == "date":
            return len(value) == 10 and bool(date.fromisoformat(value))
        return math.isfinite(float(value))
    return False


def kind_of(values: Sequence[str]) -> Kind:
    """The narrowest kind that all values fit; text where there is none."""
    return next((kind for kind in ("number", "date") if values and all(fits(v, kind) for v in values)), "text")


def sort_key(value: str, kind: Kind) -> tuple[float, str]:
    """Numbers by size, all else by letters."""
    return (float(value) if kind == "number" and fits(value, kind) else 0.0), value


def line_of(text: object, what: str, longest: int) -> str:
    """One line of readable text; raises ParameterError where it is too long."""
    plain = unicodedata.normalize("NFC", str(text))
    plain = " ".join("".join(c if unicodedata.category(c)[0] != "C" else " " for c in plain).split())
    if len(plain) > longest:
        raise ParameterError(f"The {what} “{plain[:30]}...” has {len(plain)} letters; {longest} fit.")
    return plain


def counted(items: Sequence[str], what: str) -> str:
    """How many there are, and the first of them."""
    return f"{len(items)} {what}{'' if len(items) == 1 else 's'} ({few(items)})"


def few(items: Sequence[str]) -> str:
    """The first of some items."""
    return ", ".join(items[:_FEW]) + (" ..." if len(items) > _FEW else "")
