"""A table as plain HTML, for the first picture of a page: what AG Grid will draw at the same place."""

from __future__ import annotations

import re
from collections.abc import Mapping
from html import escape
from typing import Any

MOST_ROWS = 40  # more than most screens show at once
_ICONS = {"ok": "check", "warning": "warning", "error": "error"}


def first_table(props: Mapping[str, Any], _link: str = "") -> str:
    """The head and the first rows of a table; props: those of AgGrid."""
    columns = [column for column in props.get("columnDefs") or () if not column.get("hide")]
    chosen = "rowSelection" in (props.get("dashGridOptions") or {})
    rows_of = props.get("rowData") or (props.get("getRowsResponse") or {}).get("rowData") or ()
    head = "".join(_head(column) for column in columns)
    rows = "".join(
        f"<tr>{'<td><i></i></td>' if chosen else ''}{''.join(_cell(column, row) for column in columns)}</tr>"
        for row in rows_of[:MOST_ROWS]
    )
    boxes = ("<col style='width:40px'>", "<th><i></i></th>") if chosen else ("", "")
    widths = "".join(_width(column) for column in columns)
    name = escape(str(props.get("id", "")))
    return (
        f'<div id="{name}" class="first-grid"><table><colgroup>{boxes[0]}{widths}</colgroup>'
        f"<thead><tr>{boxes[1]}{head}</tr></thead><tbody>{rows}</tbody></table></div>"
    )


def _width(column: Mapping[str, Any]) -> str:
    width = column.get("minWidth") if column.get("flex") else column.get("width")
    return f"<col style='width:{width}px'>"


def _head(column: Mapping[str, Any]) -> str:
    return f"<th{_numeric(column)}>{escape(str(column.get('headerName', '')))}</th>"


def _numeric(column: Mapping[str, Any]) -> str:
    return ' class="number"' if "number" in column.get("cellClass", "") else ""


def _cell(column: Mapping[str, Any], row: Mapping[str, Any]) -> str:
    value = row.get(column.get("field", ""))
    return f"<td{_numeric(column)}>{_content(column, value, row)}</td>"


def _content(column: Mapping[str, Any], value: Any, row: Mapping[str, Any]) -> str:
    digits = re.search(r"\.format\('\.(\d)f'\)", (column.get("valueFormatter") or {}).get("function", ""))
    if value is None:
        return "–" if digits else ""
    if digits:
        return f"{value:.{int(digits[1])}f}"
    text = escape(f"{value:g}" if isinstance(value, float) else str(value))
    match column.get("cellRenderer"):
        case "ClipLink":
            return f'<a class="clip-link ellipsis" href="{escape(row["href"])}">{text}</a>'
        case "Filmstrip":
            return f'<img class="filmstrip" loading="lazy" alt="" src="{text}">'
        case "Mark":
            mark = f'<span class="icon icon-{_ICONS[text]}" style="width:14px;height:14px"></span>'
            return f'<span class="verdict verdict-mark verdict-{text}">{mark}</span>'
        case None:
            return text
    return ""
