"""What a page loads: the frame's scripts at once; tables, charts and graphs where they are first shown.

Dash writes a script tag for every component library into every page and asks for the layout and the list of callbacks
when all of them have run. Here the page brings the layout and the list along, leaves out what is never used, and gives
heavy libraries a stand-in (``assets/shell/loading.mjs``) that loads them when one of their components is first drawn.
What the page of an address will need is fetched from the start, beside the other scripts.
"""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

import dash
from flask import request
from plotly.utils import PlotlyJSONEncoder

from webapp.shell import first_picture, links
from webapp.shell.assets import VENDOR
from webapp.shell.names import FIRST_DEPENDENCIES, FIRST_LAYOUT, LOADING, URL
from webapp.shell.state import Values
from webapp.shell.stores import CheckedDash

UNUSED = ("/dash_table/", "/dash/deps/polyfill@")  # no page has a DataTable; no supported browser needs the polyfill
LATER = {  # namespace of a library -> its components that pages use
    "dash_ag_grid": ("AgGrid",),
    "dash_cytoscape": ("Cytoscape",),
}
PLOTLY = f"{VENDOR}/plotly-cartesian.min.js"  # of plotly.js only what draws charts with axes: assets/build.mjs
_SUITES = "_dash-component-suites/"
_CHUNKS = {"table": "dash_ag_grid/async-community.js", "chart": "dash/dcc/async-graph.js"}


class LoadingDash(CheckedDash):
    """Dash whose pages load only what they need.

    shown_at_once: path of a page -> what it begins with, of "table", "chart" and "graph".
    first_values: pathname and search of an address -> properties of the layout's components, by id, that show it.
    drawings: how the first picture of a page draws a kind of component or the one of an id (first_picture.py).
    """

    shown_at_once: Mapping[str, Sequence[str]] = {}
    first_values: Callable[[str, str], Values] = staticmethod(lambda pathname, search: {})
    drawings: Mapping[str, first_picture.Draw] = {}

    def interpolate_index(self, *_: Any, **parts: Any) -> str:
        """The page's HTML. Raises RuntimeError where Dash writes its scripts otherwise than this module knows."""
        scripts, later = split_scripts(parts["scripts"])
        addresses = self._addresses(later)
        pages = {page: [a for kind in kinds for a in addresses[kind]] for page, kinds in self.shown_at_once.items()}
        layout, shown = self._first_layout()
        loading = {"suites": _suites(later), "plotly": addresses["chart"][-1], "pages": pages}
        parts["scripts"] = "\n".join(
            [
                _data(FIRST_LAYOUT, json.dumps(layout)),
                _data(FIRST_DEPENDENCIES, self.dependencies().get_data(as_text=True)),
                _data(LOADING, json.dumps(loading)),
                *scripts,
            ]
        )
        ahead = pages.get(links.page_of(request.path) or "", ())
        parts["css"] += "".join(f'\n<link rel="preload" as="script" href="{address}">' for address in ahead)
        parts["metas"] += first_picture.SCHEME
        if shown:
            style_sheets = re.findall(r'<link rel="stylesheet" href="([^"]+)"', parts["css"])
            parts["app_entry"] = first_picture.picture(layout, shown, style_sheets, self.drawings) + parts["app_entry"]
        return super().interpolate_index(**parts).replace("<html>", '<html lang="en">', 1)

    def _first_layout(self) -> tuple[Any, str]:
        """The layout with what the requested address shows, so that the browser need not ask for it; and the link of
        what is shown, "" where the browser has to ask.
        """
        search = "?" + request.query_string.decode("ascii", "replace") if request.query_string else ""
        values = self.first_values(request.path, search)
        return filled(
            self.serve_layout().get_data(as_text=True), values
        ), request.path + search if URL in values else ""

    def _addresses(self, later: Mapping[str, str]) -> dict[str, list[str]]:
        """What to load for each kind of thing a page shows."""
        suites = self.config.requests_pathname_prefix + _SUITES
        plotly = Path(self.config.assets_folder) / PLOTLY
        return {
            "table": [later["dash_ag_grid"], suites + _CHUNKS["table"]],
            "graph": [later["dash_cytoscape"]],
            "chart": [suites + _CHUNKS["chart"], f"{self.get_asset_url(PLOTLY)}?m={plotly.stat().st_mtime}"],
        }


def split_scripts(html: str) -> tuple[list[str], dict[str, str]]:
    """Dash's script tags without those not needed at once, and the addresses of the libraries of ``LATER``.

    Raises RuntimeError where a library of ``UNUSED`` or ``LATER`` has not exactly one script.
    """
    tags = re.findall(r"<script\b[^>]*>.*?</script>", html, re.DOTALL)
    left_out = {part: [tag for tag in tags if part in tag] for part in (*UNUSED, *(f"/{name}/" for name in LATER))}
    for part, matches in left_out.items():
        if len(matches) != 1:
            raise RuntimeError(f"Dash {dash.__version__} writes {len(matches)} scripts of {part}, not one")
    later = {name: _source(left_out[f"/{name}/"][0]) for name in LATER}
    removed = {tag for matches in left_out.values() for tag in matches}
    return [tag for tag in tags if tag not in removed], later


def _source(tag: str) -> str:
    """The address in a script tag."""
    match = re.search(r'src="([^"]+)"', tag)
    if match is None:
        raise RuntimeError(f"Dash {dash.__version__} writes a script without an address: {tag}")
    return match[1]


def filled(layout: str, values: Values) -> Any:
    """A layout (JSON), parsed, with ``values`` put into its components. Raises KeyError for an id it does not have."""
    missing = dict(values)

    def fill(node: Any) -> None:
        if isinstance(node, list):
            for child in node:
                fill(child)
        elif isinstance(node, dict) and "props" in node:
            name = node["props"].get("id")
            if isinstance(name, str) and name in missing:
                node["props"] |= json.loads(json.dumps(missing.pop(name), cls=PlotlyJSONEncoder))
            fill(node["props"].get("children"))

    tree = json.loads(layout)
    fill(tree)
    if missing:
        raise KeyError(f"no component of the layout is called {', '.join(missing)}")
    return tree


def _suites(sources: Mapping[str, str]) -> dict[str, dict[str, object]]:
    return {name: {"source": source, "components": LATER[name]} for name, source in sources.items()}


def _data(name: str, text: str) -> str:
    """JSON in a page, for its scripts."""
    return f'<script id="{name}" type="application/json">{text.replace("<", chr(92) + "u003c")}</script>'
