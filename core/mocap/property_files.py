"""Properties of clips from CSV files and from patterns over the names of clips."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path

from core.errors import FormatError, ParameterError
from core.mocap.properties import LONGEST_COLUMN, Properties, counted, few, fits, line_of
from core.mocap.text import decoded, read_bytes, recording_format
from core.spreadsheets import unguarded


def read_properties(path: str | Path, clips: Iterable[str]) -> tuple[Properties, tuple[str, ...]]:
    """Properties from a CSV file, and remarks: see :func:`parse_properties`. Raises FormatError, RecordingError."""
    return parse_properties(decoded(read_bytes(path)), clips, Path(path).name)


def parse_properties(text: str, clips: Iterable[str], name: str = "The table") -> tuple[Properties, tuple[str, ...]]:
    """Properties from CSV text ``clip, column, ...`` (also with ``;`` or tabs), and remarks in sentences.

    clips: those of the dataset; a clip may be written as the name of its file. A row for a clip that is not there, or
    with other values for a clip that has been named before, is left out and told with its line. Raises FormatError
    where there is no column ``clip``, no other column, a column twice, or no row that fits.
    """
    known = set(clips)
    rows = [(line, row) for line, row in _rows(text) if any(cell.strip() for cell in row)]
    if not rows:
        raise FormatError(f"{name} is empty; its first line names the columns: clip, subject, ...")
    heads = [line_of(cell, "name of a column", LONGEST_COLUMN) for cell in rows[0][1]]
    at = next((k for k, head in enumerate(heads) if head.lower() == "clip"), None)
    if at is None:
        raise FormatError(f"{name} has no column “clip”; its columns are: {', '.join(filter(None, heads)) or 'none'}.")
    used = [(k, head) for k, head in enumerate(heads) if k != at and head]
    if not used or len({head for _, head in used}) < len(used):
        raise FormatError(f"{name} needs columns beside “clip”, each with a name of its own.")
    values: dict[str, dict[str, str]] = {}
    unknown, twice = [], []
    for line, row in rows[1:]:
        cells = [*row, *[""] * (len(heads) - len(row))]
        clip = _clip_of(cells[at].strip(), known)
        own = {head: cells[k].strip() for k, head in used if cells[k].strip()}
        if clip is None:
            unknown.append(f"line {line}: {cells[at].strip()[:40] or 'no name'}")
        elif clip in values and values[clip] != own:
            twice.append(f"line {line}: {clip}")
        else:
            values[clip] = own
    if not values:
        raise FormatError(f"{name}: none of its {len(rows) - 1} rows names a clip of this dataset.")
    made = Properties().with_values(values)
    return made, tuple(_remarks(made, known, unknown, twice))


def _remarks(made: Properties, known: set[str], unknown: Sequence[str], twice: Sequence[str]) -> Iterable[str]:
    if unknown:
        yield f"{counted(unknown, 'row')} of clips that are not here."
    if twice:
        yield f"{counted(twice, 'row')} that give other values for a clip named before; the first counts."
    for name, kind in made.columns.items():
        column = made.column(name)
        if missing := sorted(known - set(column)):
            yield f"“{name}” is missing for {counted(missing, 'clip')}."
        yield from mixed_words(name, kind, column)


def mixed_words(name: str, kind: str, column: Mapping[str, str]) -> Iterable[str]:
    """A sentence where most values of a text column are numbers or dates, and some are not."""
    if kind != "text":
        return
    for other in ("number", "date"):
        odd = [f"{clip}: {value}" for clip, value in column.items() if not fits(value, other)]
        if len(odd) * 2 < len(column):
            yield f"“{name}” is text, for {len(odd)} of {len(column)} values are no {other}: {few(odd)}."


def by_pattern(pattern: str, clips: Iterable[str]) -> tuple[dict[str, dict[str, str]], tuple[str, ...]]:
    """Properties that names of clips hold: clip -> column -> text, and the clips that do not fit.

    pattern: such as ``{subject}_{condition}_{take}``; text between the braces stands as it is, ``*`` for anything. A
    part reaches to the first place where what follows it stands, the last one to the end. Raises ParameterError where
    the pattern names nothing, a column twice, or leaves open where one part ends.
    """
    literals, names = _parts(pattern)
    found, left = {}, []
    for clip in clips:
        own = _matched(clip, literals, names)
        if own is None:
            left.append(clip)
        else:
            found[clip] = own
    return found, tuple(left)


def _parts(pattern: str) -> tuple[list[str], list[str]]:
    """The text around the parts of a pattern, one more than parts, and the names of the parts ("" for ``*``)."""
    literals, names, rest = [], [], pattern.strip()
    while True:
        here = min((k for k in (rest.find("{"), rest.find("*")) if k >= 0), default=-1)
        if here < 0:
            break
        end = rest.find("}", here) if rest[here] == "{" else here
        if end < 0:
            raise ParameterError("The pattern has a “{” without a “}”.")
        literals.append(rest[:here])
        names.append(line_of(rest[here + 1 : end], "name of a column", LONGEST_COLUMN) if end > here else "")
        if end > here and (not names[-1] or names[-1] == "clip"):
            raise ParameterError("A part of the pattern needs a name, as {subject}, and not “clip”.")
        rest = rest[end + 1 :]
    literals.append(rest)
    columns = [name for name in names if name]
    if not columns:
        raise ParameterError("The pattern names no column; write for example {subject}_{condition}_{take}.")
    if len(set(columns)) < len(columns) or len(names) > 20:
        raise ParameterError("The pattern names a column twice, or has too many parts.")
    if not all(literals[1:-1]):
        raise ParameterError("Between two parts of the pattern there must be text, to tell where one ends.")
    return literals, names


def _matched(clip: str, literals: Sequence[str], names: Sequence[str]) -> dict[str, str] | None:
    if not clip.startswith(literals[0]) or not clip.endswith(literals[-1]):
        return None
    last, at = len(clip) - len(literals[-1]), len(literals[0])
    own: dict[str, str] = {}
    for k, name in enumerate(names):
        least = 1 if name else 0
        end = last if k == len(names) - 1 else clip.find(literals[k + 1], at + least)
        if end < at + least or end > last:
            return None
        if name:
            own[name] = clip[at:end]
        at = end + len(literals[k + 1])
    return own


def _rows(text: str) -> Iterable[tuple[int, list[str]]]:
    head = text.partition("\n")[0]
    delimiter = max(",;\t", key=head.count)
    reader = csv.reader(io.StringIO(text), delimiter=delimiter)
    try:
        for row in reader:
            yield reader.line_num, [unguarded(cell) for cell in row]
    except csv.Error as error:
        raise FormatError(f"The table cannot be read as CSV: {error} in line {reader.line_num}.") from error


def _clip_of(written: str, known: set[str]) -> str | None:
    if written in known:
        return written
    stem = recording_format(written)[0] if written else ""
    return stem if stem in known else None
