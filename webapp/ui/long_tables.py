"""Tables with more rows than a browser should hold: rows stay on the server, which sorts, filters and sends blocks.

AG Grid asks for a block with its "infinite" row model, and Dash passes on what it asks (``getRowsRequest``): the rows,
how they are sorted, and the filters of its columns.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np

from core.caching import RecentCache
from webapp.ui.tables import Row

LONG = 2000  # rows from which on a table stays on the server
BLOCK = 100  # rows that are sent at a time
OFFERED = 200  # names that are offered at a time where there are more than a browser should hold
OPTIONS: dict[str, Any] = {
    "cacheBlockSize": BLOCK,
    "maxBlocksInCache": 30,
    "rowBuffer": 10,
    "blockLoadDebounceMillis": 40,
}
"""AG Grid's own options for a table whose rows stay on the server."""


class LongTable:
    """Rows by number, with the values of the columns that are sorted and filtered by.

    values: column -> value of each row, text or numbers, None where there is none. row: the row of a number, made when
    it is sent. texts: column -> what its filter looks at, where that is something else than what it is sorted by.
    """

    def __init__(
        self,
        values: Mapping[str, Sequence[Any]],
        row: Callable[[int], Row],
        texts: Mapping[str, Sequence[str]] | None = None,
    ):
        self._values, self._row, self._texts = values, row, texts or {}
        self._n = len(next(iter(values.values()), ()))
        self._ranks: dict[str, np.ndarray] = {}
        self._lower: dict[str, list[str]] = {}
        self._orders: RecentCache[str, np.ndarray] = RecentCache(16)

    def block(self, request: Mapping[str, Any]) -> dict[str, Any]:
        """What the table shows from ``startRow`` to ``endRow`` of a request, and how many rows match."""
        order = self.order(request.get("filterModel"), request.get("sortModel"))
        start, end = (max(0, int(request.get(key) or 0)) for key in ("startRow", "endRow"))
        shown = order[start : min(end, start + 10 * BLOCK)].tolist()
        return {"rowData": [self._row(k) for k in shown], "rowCount": len(order)}

    def first(self) -> dict[str, Any]:
        """The block that the table shows first."""
        return self.block({"startRow": 0, "endRow": BLOCK})

    def order(self, filters: object = None, sorting: object = None) -> np.ndarray:
        """Numbers ``(n,)`` of the rows that match, in the order in which they are shown."""
        key = json.dumps([filters or {}, sorting or []], sort_keys=True)
        return self._orders.get_or_compute(key, lambda: self._ordered(filters, sorting))

    def _ordered(self, filters: object, sorting: object) -> np.ndarray:
        chosen = np.ones(self._n, bool)
        for column, model in filters.items() if isinstance(filters, Mapping) else ():
            if column in self._values or column in self._texts:
                chosen &= self._matching(column, model)
        rows = np.flatnonzero(chosen)
        for entry in reversed(sorting) if isinstance(sorting, Sequence) else ():
            if isinstance(entry, Mapping) and entry.get("colId") in self._values:
                ranks = self._rank(str(entry["colId"]))[rows]
                ranks = np.where(ranks < 0, self._n, -ranks if entry.get("sort") == "desc" else ranks)
                rows = rows[np.argsort(ranks, kind="stable")]
        return rows

    def _rank(self, column: str) -> np.ndarray:
        """Place of each row among the values of a column ``(n,)``, equal ones alike; -1 where there is none."""
        if column not in self._ranks:
            values = self._values[column]
            there = [value for value in values if value not in (None, "")]
            place = {value: k for k, value in enumerate(sorted(set(there), key=_order))}
            self._ranks[column] = np.array([place.get(value, -1) if value is not None else -1 for value in values])
        return self._ranks[column]

    def _matching(self, column: str, model: object) -> np.ndarray:
        if not isinstance(model, Mapping):
            return np.ones(self._n, bool)
        conditions = model.get("conditions")
        if isinstance(conditions, Sequence) and conditions:
            parts = [self._matching(column, one) for one in conditions]
            together = np.logical_or if model.get("operator") == "OR" else np.logical_and
            return np.asarray(together.reduce(parts))
        if column not in self._lower:
            texts = self._texts.get(column) or self._values[column]
            self._lower[column] = ["" if text is None else str(text).lower() for text in texts]
        test = _TESTS.get(str(model.get("type")), _TESTS["contains"])
        asked = str(model.get("filter") or "").strip().lower()
        return np.fromiter((test(text, asked) for text in self._lower[column]), bool, self._n)


_TESTS: dict[str, Callable[[str, str], bool]] = {
    "contains": lambda text, asked: asked in text,
    "notContains": lambda text, asked: asked not in text,
    "equals": lambda text, asked: text == asked,
    "notEqual": lambda text, asked: text != asked,
    "startsWith": str.startswith,
    "endsWith": str.endswith,
    "blank": lambda text, asked: not text,
    "notBlank": lambda text, asked: bool(text),
}
"""AG Grid's filters of text."""


def _order(value: Any) -> tuple[int, float, str]:
    """Numbers before text; text without regard to capitals."""
    return (1, 0.0, value.lower()) if isinstance(value, str) else (0, float(value), "")
