"""Jitted scanners that turn the text of millions of numbers into arrays in one pass.

Several times the speed of numpy's text parser, and they know where a number went wrong. Every scanner
returns a status (below) and the byte offset it speaks of, so that the readers can name the line.
"""

from __future__ import annotations

import numpy as np

from core.arrays import Float64Array, Int64Array, UInt8Array
from core.compiled import njit

OK, NOT_A_NUMBER, ROW_WIDTH, TOO_MANY_ROWS, UNKNOWN_NAME, REPEATED_NAME, MISSING_NAME, FRAME_NUMBER, NO_FRAME = range(9)

_TAB, _NEWLINE, _SPACE, _HASH, _PLUS, _MINUS, _DOT, _ZERO, _NINE = 9, 10, 32, 35, 43, 45, 46, 48, 57
_POWERS = 10.0 ** np.arange(309)


@njit(nogil=True)
def _is_space(c: int) -> bool:
    return c == _SPACE or _TAB <= c <= 13


@njit(nogil=True)
def _scaled(mantissa: int, exponent: int) -> float:
    if mantissa == 0 or exponent < -330:
        return 0.0
    if exponent > 308:
        return np.inf
    if exponent < -308:
        tiny: float = float(mantissa) / _POWERS[308] / _POWERS[-exponent - 308]
        return tiny
    value: float = float(mantissa) * _POWERS[exponent] if exponent >= 0 else float(mantissa) / _POWERS[-exponent]
    return value


@njit(nogil=True)
def _mantissa(data: UInt8Array, i: int) -> tuple[int, int, int, int]:
    """Digits from ``i``, with or without a point, as (integer, power of ten, count of digits, offset after them)."""
    mantissa, exponent, digits, point = 0, 0, 0, False
    while i < len(data):
        c = data[i]
        if _ZERO <= c <= _NINE:
            if mantissa < 922337203685477579:
                mantissa = mantissa * 10 + (c - _ZERO)
                exponent -= point
            else:  # more digits than a double holds
                exponent += not point
            digits += 1
        elif c == _DOT and not point:
            point = True
        else:
            break
        i += 1
    return mantissa, exponent, digits, i


@njit(nogil=True)
def _exponent(data: UInt8Array, i: int) -> tuple[int, bool, int]:
    """The power after an ``e`` at ``i`` (0 without one), whether it is well formed, and the offset after it."""
    n = len(data)
    if i == n or (data[i] | 32) != 101:  # e or E
        return 0, True, i
    i += 1
    down = i < n and data[i] == _MINUS
    if i < n and data[i] in (_MINUS, _PLUS):
        i += 1
    start, power = i, 0
    while i < n and _ZERO <= data[i] <= _NINE:
        power = min(power * 10 + (data[i] - _ZERO), 100000)
        i += 1
    return (-power if down else power), i > start, i


@njit(nogil=True)
def _number(data: UInt8Array, i: int) -> tuple[float, int]:
    """Value of the decimal number at ``i`` and the offset after it; NaN where it is none or does not fit a double."""
    negative = data[i] == _MINUS
    if data[i] in (_MINUS, _PLUS):
        i += 1
    mantissa, exponent, digits, i = _mantissa(data, i)
    power, well_formed, i = _exponent(data, i)
    if digits == 0 or not well_formed or (i < len(data) and not _is_space(data[i])):
        return np.nan, i
    value = _scaled(mantissa, exponent + power)
    if value == np.inf:
        return np.nan, i
    return (-value if negative else value), i


@njit(nogil=True)
def _skip_space(data: UInt8Array, i: int) -> int:
    while i < len(data) and _is_space(data[i]):
        i += 1
    return i


@njit(nogil=True)
def _skip_word(data: UInt8Array, i: int) -> int:
    while i < len(data) and not _is_space(data[i]):
        i += 1
    return i


@njit(nogil=True)
def _values(
    data: UInt8Array, i: int, row: Float64Array, column: int, end: int, largest: float
) -> tuple[int, bool, int]:
    """Numbers to the end of the line into ``row[column:end]``; (count of them, whether all are good, offset)."""
    count = 0
    while i < len(data) and data[i] != _NEWLINE:
        if _is_space(data[i]):
            i += 1
            continue
        value, after = _number(data, i)
        if not abs(value) <= largest:
            return count, False, i
        if column + count < end:
            row[column + count] = value
        count += 1
        i = after
    return count, True, i


@njit(nogil=True)
def scan_rows(data: UInt8Array, start: int, out: Float64Array, largest: float) -> tuple[int, int, int, int]:
    """Rows of numbers, one a line, blank lines skipped, from byte ``start`` of ``data`` (n_bytes,) into ``out``.

    out: (n_rows, n_columns) float64. Returns (rows found, status, byte offset, columns of the row in doubt).
    """
    rows, width = out.shape
    i, row = _skip_space(data, start), 0
    while i < len(data):
        if row == rows:
            return row, TOO_MANY_ROWS, i, 0
        first = i
        count, good, i = _values(data, i, out[row], 0, width, largest)
        if not good:
            return row, NOT_A_NUMBER, i, count
        if count != width:
            return row, ROW_WIDTH, first, count
        row += 1
        i = _skip_space(data, i)
    return row, OK, i, 0


@njit(nogil=True)
def _starts_number(c: int) -> bool:
    return _ZERO <= c <= _NINE or c in (_MINUS, _PLUS)


@njit(nogil=True)
def count_numbered_lines(data: UInt8Array, start: int) -> int:
    """Lines from byte ``start`` of ``data`` (n_bytes,) whose first character is a digit or a sign."""
    count, fresh = 0, True
    for i in range(start, len(data)):
        c = data[i]
        if c == _NEWLINE:
            fresh = True
        elif fresh and not _is_space(c):
            fresh = False
            count += _starts_number(c)
    return count


@njit(nogil=True)
def _find_name(data: UInt8Array, start: int, end: int, names: UInt8Array, name_at: Int64Array, guess: int) -> int:
    """Index of the name at ``data[start:end]``, ``guess`` tried first, or -1."""
    n = len(name_at) - 1
    for k in range(n):
        candidate = (guess + k) % n
        first = name_at[candidate]
        if name_at[candidate + 1] - first != end - start:
            continue
        same = True
        for i in range(end - start):
            if data[start + i] != names[first + i]:
                same = False
                break
        if same:
            return candidate
    return -1


@njit(nogil=True)
def _frame_number(data: UInt8Array, i: int, frame: int, last: int) -> tuple[int, int]:
    """The frame number at ``i`` (-1 where it is none, or does not follow ``last``) and the end of its line."""
    value, i = _number(data, i)
    if not 0 <= value <= 2**53 or value != np.floor(value) or (frame >= 0 and value != last + 1):
        return -1, i
    while i < len(data) and data[i] != _NEWLINE:
        if not _is_space(data[i]):
            return -1, i
        i += 1
    return int(value), i


@njit(nogil=True)
def _missing(seen: Int64Array, columns: Int64Array, frame: int) -> int:
    """Index of the first name with columns that did not come in ``frame``, or -1."""
    for k in range(len(seen)):
        if columns[k + 1] > columns[k] and seen[k] != frame:
            return k
    return -1


@njit(nogil=True)
def _named_row(
    data: UInt8Array,
    i: int,
    after: int,
    names: UInt8Array,
    name_at: Int64Array,
    columns: Int64Array,
    seen: Int64Array,
    guess: int,
    frame: int,
    out: Float64Array,
    largest: float,
) -> tuple[int, int, int, int]:
    """One row ``name value value ...``; (status, offset, see scan_frames, index of the name)."""
    name = _find_name(data, i, after, names, name_at, guess)
    if name < 0:
        return UNKNOWN_NAME, i, 0, name
    if seen[name] == frame:
        return REPEATED_NAME, i, name, name
    seen[name] = frame
    count, good, end = _values(data, after, out[frame], columns[name], columns[name + 1], largest)
    if not good:
        return NOT_A_NUMBER, end, name, name
    if count != columns[name + 1] - columns[name]:
        return ROW_WIDTH, i, count, name
    return OK, end, 0, name


@njit(nogil=True)
def scan_frames(
    data: UInt8Array,
    start: int,
    names: UInt8Array,
    name_at: Int64Array,
    columns: Int64Array,
    out: Float64Array,
    largest: float,
) -> tuple[int, int, int, int]:
    """Numbered frames of named rows of numbers (AMC) from byte ``start`` of ``data`` (n_bytes,) into ``out``.

    names, name_at: all names in one (n_bytes,) array, and where each begins, (n_names + 1,).
    columns: (n_names + 1,) first column of each name in ``out`` (n_frames, n_columns) float64; every name that has
    columns must come once a frame. Returns (frames found, status, byte offset, number: a name's index, the values
    found or the frame number before).
    """
    seen = np.full(len(name_at) - 1, -1)
    i, frame, name, last = _skip_space(data, start), -1, -1, -1
    while i < len(data):
        first, after = i, _skip_word(data, i)
        if _starts_number(data[i]):
            missing = _missing(seen, columns, frame) if frame >= 0 else -1
            if missing >= 0:
                return frame, MISSING_NAME, i, missing
            number, i = _frame_number(data, i, frame, last)
            if number < 0:
                return frame + 1, FRAME_NUMBER, first, last
            frame, last = frame + 1, number
        elif data[i] == _HASH:
            while i < len(data) and data[i] != _NEWLINE:
                i += 1
        elif frame < 0:
            return 0, NO_FRAME, i, 0
        else:
            status, i, what, name = _named_row(
                data, i, after, names, name_at, columns, seen, name + 1, frame, out, largest
            )
            if status != OK:
                return frame, status, i, what
        i = _skip_space(data, i)
    missing = _missing(seen, columns, frame) if frame >= 0 else -1
    return (frame + 1, OK, i, 0) if missing < 0 else (frame, MISSING_NAME, i, missing)
