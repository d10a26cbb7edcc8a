"""Line icons: shapes live in assets/shared/icons.css as masks, so they take the colour of the text around them."""

from __future__ import annotations

from dash import html

from webapp.shell.attributes import attributes


def icon(name: str, size: int = 18) -> html.Span:
    """A decorative icon; whatever carries it must have a text or an aria-label of its own."""
    return html.Span(
        className=f"icon icon-{name}", style={"width": size, "height": size}, **attributes(aria_hidden="true")
    )
