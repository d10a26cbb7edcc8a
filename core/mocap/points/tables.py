"""Numbers in rows and columns of a text file, with empty cells, read fast."""

from __future__ import annotations

import io
import re
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from core.mocap.errors import RecordingError
from core.mocap.text import decoded, quoted

MOST_COLUMNS = 20_000
_EMPTY = (
    "",
    "nan",
    "NaN",
    "NAN",
    "-nan",
    "null",
    "NULL",
    "None",
    "none",
    "NA",
    "N/A",
    "n/a",
    "-1.#IND",
    "1.#QNAN",
    "inf",
    "-inf",
    "Inf",
    "-Inf",
)
_NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eEdD][+-]?\d+)?")


def divider_of(lines: Sequence[str]) -> str:
    """What divides the cells of these lines: a tab, a semicolon, a comma, or a blank."""
    text = "\n".join(lines)
    if "\t" in text:
        return "\t"
    if text.count(";") > len(lines):
        return ";"
    return "," if text.count(",") > len(lines) else " "


def cells_of(line: str, divider: str) -> list[str]:
    """The cells of a line, without blanks and quotes around them."""
    cells = line.split() if divider == " " else line.split(divider)
    return [cell.strip().strip('"').strip("'").strip() for cell in cells]


def is_number(cell: str) -> bool:
    """Whether a cell holds a number."""
    return _NUMBER.fullmatch(cell) is not None


def read_table(path: str | Path, data: bytes, line: int, divider: str, columns: int) -> np.ndarray:
    """Numbers ``(n_rows, columns)``, NaN for empty cells, of the lines of ``data``; short rows are filled with NaN.

    line: number in the file of the first line. Empty lines are left out. Raises RecordingError for what is no number.
    """
    if not 0 < columns <= MOST_COLUMNS:
        raise RecordingError(path, f"{columns} columns", f"from 1 to {MOST_COLUMNS}", line)
    if divider == ";" and b"," in data:
        data = data.replace(b",", b".")  # decimal commas
    if divider != " ":
        import pyarrow as pa  # starts a thread, and a worker that forks may have none

        try:
            return _fast(data, divider, columns)
        except (pa.ArrowInvalid, pa.ArrowNotImplementedError, pa.ArrowKeyError):
            pass
    return _careful(path, data, line, divider, columns)


def _fast(data: bytes, divider: str, columns: int) -> np.ndarray:
    import pyarrow as pa
    from pyarrow import csv

    names = [str(k) for k in range(columns)]
    table = csv.read_csv(
        io.BytesIO(data),
        read_options=csv.ReadOptions(column_names=names, use_threads=False),
        parse_options=csv.ParseOptions(delimiter=divider, ignore_empty_lines=True),
        convert_options=csv.ConvertOptions(
            column_types={name: pa.float64() for name in names}, null_values=list(_EMPTY), strings_can_be_null=True
        ),
    )
    filled = [column.to_numpy(zero_copy_only=False).astype(float) for column in table.columns]
    values = np.stack(filled, axis=1)
    there: np.ndarray = values[~np.isnan(values).all(axis=1)]
    return there


def _careful(path: str | Path, data: bytes, first: int, divider: str, columns: int) -> np.ndarray:
    rows = []
    for k, text in enumerate(decoded(data).split("\n")):
        cells = cells_of(text, divider)
        if not any(cells):
            continue
        while len(cells) > columns and not cells[-1]:
            cells.pop()
        if len(cells) > columns:
            raise RecordingError(path, f"{len(cells)} cells in a row", f"{columns}", first + k)
        row = np.full(columns, np.nan)
        for c, cell in enumerate(cells):
            if _NUMBER.fullmatch(cell):
                row[c] = float(cell.lower().replace("d", "e"))
            elif cell not in _EMPTY:
                raise RecordingError(path, quoted(cell), "a number or an empty cell", first + k)
        rows.append(row)
    return np.array(rows).reshape(-1, columns)


def rate_of(times: np.ndarray) -> float | None:
    """Frames per second of times ``(n,)`` in seconds or milliseconds, by the median step; None where none rise."""
    times = times[np.isfinite(times)]
    if len(times) < 2:
        return None
    step = float(np.median(np.diff(times)))
    if not step > 0:
        return None
    if step > 2:  # a frame lasts milliseconds, not seconds
        step /= 1000
    rate = 1 / step
    return float(round(rate)) if round(rate) and abs(rate - round(rate)) < 0.005 * rate else rate
