"""What one sees, as a link: pure functions between a URL and a :class:`View`.

A link may come from an e-mail that broke it, from an older version, or from someone's imagination. Parsing never
raises: what cannot be understood is left out and named in the list of problems.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from urllib.parse import parse_qsl, quote, urlencode

from webapp import settings

VIEW_KEYS = {  # what a page shows beside the selection: kept in the store "view", each page with keys of its own
    "library": ("tab", "files"),
    "motifs": (
        "view",
        "side",
        "walk",
        "weights",
        "other",
        "gained",
        "extra",
        "gaps",
        "ends",
        "feet",
        "stability",
        "step",
    ),
    "sweeps": ("x", "y", "seeds"),
    "search": (
        *("query", "parts", "level", "route", "label", "named", "lasting", "top"),  # see webapp/searching.py
        *("hit", "look", "study", "asks", "measure"),
        *settings.keys("search"),
        *settings.keys("ranking"),
    ),
    "grammar": ("show", "routine", "sentence", "pick", "up", "alt", "counts", *settings.keys("grammar")),
    "clip": ("chart", "angles", "joints", "rig", "channels", "span"),
    "map": ("keys", "drawn", "within", "pace", "way", "colour", "click", "below", "region", *settings.keys("map")),
}
PAGES = tuple(VIEW_KEYS)
OF_DATASET = (
    "walk",
    "weights",
    "other",
    "gained",
    "joints",
    "query",
    "hit",
    "label",
    "named",
    "asks",
    *("routine", "sentence", "pick", "up", "alt"),
    *("keys", "drawn", "region"),
)  # what makes no sense any more with another data set
FREE_TEXT = frozenset(
    {"query", "hit", "label", "named", "asks"}
)  # keys that may hold any text one can print, such as names of clips
SHAPES = {  # of keys that only make sense in one way
    "keys": r"\d{1,4}-\d{1,4}(,\d{1,4}-\d{1,4})*",
    "drawn": r"[\d.]{1,8}-[\d.]{1,8}(,[\d.]{1,8}-[\d.]{1,8})+",
    **dict.fromkeys(("region", "routine", "pick", "up", "alt"), r"\d{1,6}"),
}
MAX_QUERY = 4000
_SELECTION_KEYS = ("motifs", "motif", "motion", "edge", "transition", "action", "segment", "clip", "start", "end", "as")
_MAX_NUMBER = 10**7


@dataclass(frozen=True)
class View:
    """What the link shows. ``parameters`` are the method's, as text; ``selection`` is one of

    {"motif": int[, "motion": int]}, {"motifs": "3-7-9"} (marked together),
    {"edge": "SOURCE-TARGET"[, "transition": int]},
    {"action": int[, "segment": int]} (of the Grammar page),
    {"clip": name[, "start": frame, "end": frame][, "as": "actions"]} (frames of the clip's own rate, end exclusive;
    as: coloured by its actions).
    ``stage`` is the Stage's own business (moment, camera ...), ``view`` the page's (see VIEW_KEYS): short strings
    handed back as they came.
    """

    page: str = "library"
    dataset: str | None = None
    parameters: Mapping[str, str] = field(default_factory=dict)
    selection: Mapping[str, int | str] = field(default_factory=dict)
    stage: Mapping[str, str] = field(default_factory=dict)
    view: Mapping[str, str] = field(default_factory=dict)


STAGE_KEYS = ("time", "speed", "layout", "camera")


def page_of(pathname: str | None) -> str | None:
    """Name of the page at ``pathname``; None where there is none."""
    name = (pathname or "/").strip("/").lower()
    return "library" if not name else name if name in PAGES else None


def parse(
    pathname: str | None, search: str | None, parameter_names: tuple[str, ...] = ()
) -> tuple[View, tuple[str, ...]]:
    """The view a URL asks for, and what in it could not be understood (plain sentences)."""
    problems: list[str] = []
    page = page_of(pathname)
    if page is None:
        problems.append(f"There is no page called “{_shorten(pathname)}”.")
    query = (search or "").lstrip("?")
    if len(query) > MAX_QUERY:
        return View(page or "library"), (*problems, "The link is too long to be one of ours.")
    values = _first_values(query, problems)
    selection = _selection(values, problems)
    shown = _view(page or "library", values, problems)
    known = {"dataset", *STAGE_KEYS, *_SELECTION_KEYS, *parameter_names, *VIEW_KEYS[page or "library"]}
    unknown = [name for name in values if name not in known]
    if unknown:
        problems.append("The link has parts we do not know: " + ", ".join(_shorten(name) for name in unknown[:5]) + ".")
    view = View(
        page or "library",
        values.get("dataset") or None,
        {name: values[name] for name in parameter_names if name in values},
        selection,
        {key: values[key] for key in STAGE_KEYS if _stage_value(values.get(key, ""))},
        shown,
    )
    return view, tuple(problems)


def format_link(view: View) -> str:
    """The relative URL of ``view``; :func:`parse` gives the view back."""
    pairs = {**({"dataset": view.dataset} if view.dataset else {}), **view.parameters, **view.view}
    pairs |= {**view.selection, **view.stage}
    query = urlencode({key: str(value) for key, value in pairs.items()}, quote_via=quote, safe="/-,:")
    return f"/{view.page}" + (f"?{query}" if query else "")


def without_selection(view: View) -> View:
    """The same view with nothing selected."""
    return replace(view, selection={}, stage={}, view={})


def _first_values(query: str, problems: list[str]) -> dict[str, str]:
    values: dict[str, str] = {}
    try:
        pairs = parse_qsl(query, keep_blank_values=True, max_num_fields=100)
    except ValueError:
        problems.append("The link could not be read.")
        return values
    for key, value in pairs:
        if "\x00" in value or "�" in value:
            problems.append(f"“{_shorten(key)}” in the link is not readable text.")
        else:
            values.setdefault(key, value)
    return values


def _selection(values: Mapping[str, str], problems: list[str]) -> dict[str, int | str]:
    if "motif" in values:
        return _with_numbers("motif", _number(values, "motif", problems), values, ("motion",), problems)
    if "motifs" in values:
        if re.fullmatch(r"\d{1,6}(-\d{1,6}){0,299}", values["motifs"]):
            return {"motifs": values["motifs"]}
        problems.append("“motifs” in the link should look like 3-7-9.")
        return {}
    if "action" in values:
        return _with_numbers("action", _number(values, "action", problems), values, ("segment",), problems)
    if "edge" in values:
        match = re.fullmatch(r"(\d{1,6})-(\d{1,6})", values["edge"])
        if not match:
            problems.append("“edge” in the link should look like 3-5.")
        edge = f"{int(match[1])}-{int(match[2])}" if match else None
        return _with_numbers("edge", edge, values, ("transition",), problems)
    if values.get("clip"):
        chosen = _with_numbers("clip", values["clip"], values, ("start", "end"), problems)
        chosen |= {"as": values["as"]} if values.get("as") == "actions" else {}
        if ("start" in chosen) == ("end" in chosen) and chosen.get("start", 0) < chosen.get("end", 1):
            return chosen
        problems.append("“start” and “end” in the link must come together, start before end.")
        return {"clip": chosen["clip"]}
    return {}


def _with_numbers(
    kind: str, value: int | str | None, values: Mapping[str, str], keys: tuple[str, ...], problems: list[str]
) -> dict[str, int | str]:
    if value is None:
        return {}
    numbers = {key: _number(values, key, problems) for key in keys if key in values}
    return {kind: value, **{key: number for key, number in numbers.items() if number is not None}}


def _number(values: Mapping[str, str], key: str, problems: list[str]) -> int | None:
    text = values[key]
    if re.fullmatch(r"[0-9]{1,8}", text) and int(text) <= _MAX_NUMBER:
        return int(text)
    problems.append(f"“{key}” in the link should be a whole number, not “{_shorten(text)}”.")
    return None


def _view(page: str, values: Mapping[str, str], problems: list[str]) -> dict[str, str]:
    found = {key: values[key] for key in VIEW_KEYS[page] if values.get(key)}
    usable = {key: text for key, text in found.items() if _view_value(key, text)}
    problems += [f"“{key}” in the link could not be understood." for key in found if key not in usable]
    return usable


def _view_value(key: str, text: str) -> bool:
    if key in FREE_TEXT:
        return len(text) <= 1000 and text.isprintable()
    return bool(re.fullmatch(r"[-0-9A-Za-z.,:_~ ]{1,300}", text) and re.fullmatch(SHAPES.get(key, ".*"), text))


def _stage_value(text: str) -> bool:
    return bool(re.fullmatch(r"[-0-9a-z.,:_]{1,200}", text))


def _shorten(text: str | None, length: int = 40) -> str:
    text = "".join(c if c.isprintable() else "?" for c in (text or ""))
    return text if len(text) <= length else text[: length - 1] + "…"
