"""Links to what is shown: pure functions between a URL and a :class:`View`.

A link may be damaged, from an older version, or made up. Parsing never raises: what cannot be understood is left out
and listed among the problems.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from urllib.parse import parse_qsl, quote, urlencode

from webapp.shell import settings
from webapp.shell.feature import Feature, LinkKeys, SelectionKind, features

MAX_QUERY = 4000
_CLIP_KEYS = ("clip", "start", "end", "as")  # of the selection of a clip, which every page has
_MAX_NUMBER = 10**7


@dataclass(frozen=True)
class View:
    """What the link shows. ``selection`` is one of

    {"motif": int[, "motion": int]}, {"motifs": "3-7-9"} (marked together),
    {"edge": "SOURCE-TARGET"[, "transition": int]},
    {"action": int[, "segment": int]} (of the Grammar page),
    {"clip": name[, "start": frame, "end": frame][, "as": "actions"]} (frames of the clip's own rate, end exclusive;
    as: coloured by its actions).
    ``stage`` is the state of the Stage (moment, camera ...), ``view`` what the page shows, and the settings (see
    view_keys): short texts that are passed on unchanged.
    """

    page: str = "library"
    dataset: str | None = None
    selection: Mapping[str, int | str] = field(default_factory=dict)
    stage: Mapping[str, str] = field(default_factory=dict)
    view: Mapping[str, str] = field(default_factory=dict)


STAGE_KEYS = ("time", "speed", "layout", "camera")


def view_keys() -> dict[str, tuple[str, ...]]:
    """What each page shows beside the selection, kept in the store "view": page -> its keys in a link, each once."""
    everywhere = settings.keys_on_every_page()
    return {
        feature.path: tuple(dict.fromkeys([*everywhere, *feature.keys.names, *_settings_keys(feature)]))
        for feature in features()
    }


def _settings_keys(feature: Feature) -> Iterator[str]:
    return (key for name in feature.methods for key in settings.keys(name))


def keys_of_dataset() -> list[str]:
    """Keys of all pages that are dropped when another data set is chosen."""
    return [key for feature in features() for key in feature.keys.of_dataset]


def page_of(pathname: str | None) -> str | None:
    """Name of the page at ``pathname``; None where there is none."""
    name = (pathname or "/").strip("/").lower()
    return "library" if not name else name if name in {feature.path for feature in features()} else None


def parse(pathname: str | None, search: str | None) -> tuple[View, tuple[str, ...]]:
    """The view a URL asks for, and what in it could not be understood (plain sentences)."""
    problems: list[str] = []
    page = page_of(pathname)
    if page is None:
        problems.append(f"There is no page called “{_shorten(pathname)}”.")
    query = (search or "").lstrip("?")
    if len(query) > MAX_QUERY:
        return View(page or "library"), (*problems, "The link is too long.")
    values = _first_values(query, problems)
    selection = _selection(values, problems)
    shown = _view(page or "library", values, problems)
    selectable = {key for kind in _selection_kinds() for key in (kind.key, *kind.numbers)} | {*_CLIP_KEYS}
    known = {"dataset", *STAGE_KEYS, *selectable, *view_keys()[page or "library"]}
    unknown = [name for name in values if name not in known]
    if unknown:
        problems.append("The link has unknown parts: " + ", ".join(_shorten(name) for name in unknown[:5]) + ".")
    view = View(
        page or "library",
        values.get("dataset") or None,
        selection,
        {key: values[key] for key in STAGE_KEYS if _stage_value(values.get(key, ""))},
        shown,
    )
    return view, tuple(problems)


def format_link(view: View) -> str:
    """The relative URL of ``view``; :func:`parse` gives the view back."""
    pairs = {**({"dataset": view.dataset} if view.dataset else {}), **view.view, **view.selection, **view.stage}
    query = urlencode({key: str(value) for key, value in pairs.items()}, quote_via=quote, safe="/-,:", errors="replace")
    return f"/{view.page}" + (f"?{query}" if query else "")


def without_selection(view: View) -> View:
    """The same view with nothing selected; the settings that all pages share stay."""
    shared = {key: text for key, text in view.view.items() if key in settings.keys_on_every_page()}
    return replace(view, selection={}, stage={}, view=shared)


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


def _selection_kinds() -> Iterator[SelectionKind]:
    return (kind for feature in features() for kind in feature.selections)


def _selection(values: Mapping[str, str], problems: list[str]) -> dict[str, int | str]:
    for kind in _selection_kinds():
        if kind.key in values:
            value = _pattern(values, kind, problems) if kind.pattern else _number(values, kind.key, problems)
            return _with_numbers(kind.key, value, values, kind.numbers, problems)
    return _clip(values, problems) if values.get("clip") else {}


def _pattern(values: Mapping[str, str], kind: SelectionKind, problems: list[str]) -> str | None:
    """Text of numbers, written without leading zeros."""
    if re.fullmatch(kind.pattern, values[kind.key]):
        return re.sub(r"[0-9]+", lambda number: str(int(number[0])), values[kind.key])
    problems.append(f"“{kind.key}” in the link should look like {kind.example}.")
    return None


def _clip(values: Mapping[str, str], problems: list[str]) -> dict[str, int | str]:
    chosen = _with_numbers("clip", values["clip"], values, ("start", "end"), problems)
    if any(values.get("as") in feature.clip_colours for feature in features()):
        chosen["as"] = values["as"]
    if ("start" in chosen) == ("end" in chosen) and int(chosen.get("start", 0)) < int(chosen.get("end", 1)):
        return chosen
    problems.append("“start” and “end” in the link must come together, start before end.")
    return {"clip": chosen["clip"]}


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
    keys = next(feature.keys for feature in features() if feature.path == page)
    texts = {key: values[key] for key in view_keys()[page] if values.get(key)}
    usable = {key: text for key, text in texts.items() if _view_value(keys, key, text)}
    problems += [f"“{key}” in the link could not be understood." for key in texts if key not in usable]
    return usable


def _view_value(keys: LinkKeys, key: str, text: str) -> bool:
    if key in keys.free_text:
        return len(text) <= 1000 and text.isprintable()
    return bool(re.fullmatch(r"[-+0-9A-Za-z.,:_~ ]{1,300}", text) and re.fullmatch(keys.patterns.get(key, ".*"), text))


def _stage_value(text: str) -> bool:
    return bool(re.fullmatch(r"[-0-9a-z.,:_]{1,200}", text))


def _shorten(text: str | None, length: int = 40) -> str:
    text = "".join(c if c.isprintable() else "?" for c in (text or ""))
    return text if len(text) <= length else text[: length - 1] + "…"
