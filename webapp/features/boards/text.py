"""Text in Markdown, made into HTML that can do nothing: no HTML of its own, no pictures, no scripts."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from typing import Any

from markdown_it import MarkdownIt

from core.mocap.dataset import Dataset
from core.workspace import Workspace


def content(
    workspace: Workspace, dataset: Dataset, view: Mapping[str, str], options: Mapping[str, str]
) -> dict[str, Any]:
    """``html``: of the option ``markdown``."""
    return {"html": to_html(options.get("markdown", ""))}


def to_html(markdown: str) -> str:
    """Markdown as HTML; HTML in it is shown as text, and so are pictures, which would be fetched from elsewhere."""
    return str(_reader().render(markdown))


@cache
def _reader() -> MarkdownIt:
    return MarkdownIt("commonmark", {"html": False}).enable("table").disable("image")
