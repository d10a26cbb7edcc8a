"""Properties of clips: ``/api/properties/<dataset>`` shows and changes them, ``.../csv`` gives them as a file."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any

from flask import Blueprint, Response, jsonify

from core.mocap.properties import Properties
from core.mocap.property_files import by_pattern, mixed_words, parse_properties
from core.workspace import Workspace
from core.workspace.clip_properties import present_properties
from webapp.shell.routes import BadRequest, answer_errors, attachment, json_body

LARGEST_TABLE = 8_000_000  # bytes
MOST_VALUES, MOST_ROWS = 60, 8  # of a column in the summary, of clips in a preview
Body = dict[str, Any]


def properties_blueprint(workspace: Workspace) -> Blueprint:
    """The routes for one workspace."""
    routes = Blueprint("properties", __name__, url_prefix="/api/properties")
    answer_errors(routes)

    @routes.get("/<dataset>")
    def show_properties(dataset: str) -> Response:
        return jsonify(_summary(workspace, dataset, present_properties(workspace, dataset)))

    @routes.get("/<dataset>/csv")
    def properties_file(dataset: str) -> Response:
        names = workspace.open(dataset).names
        return attachment(present_properties(workspace, dataset).to_csv(names), "text/csv", f"{dataset}-clips.csv")

    @routes.post("/<dataset>")
    def change_properties(dataset: str) -> Response:
        body = json_body(LARGEST_TABLE)
        id, author = workspace.info(dataset).id, str(body.get("author", ""))
        if body.get("action") == "restore":
            version = body.get("version")
            if not isinstance(version, int):
                raise BadRequest("version must be a whole number.")
            workspace.properties.restore(id, version, author)
            return jsonify(_summary(workspace, dataset, present_properties(workspace, dataset)))
        change = CHANGES.get(str(body.get("action")))
        if change is None:
            raise BadRequest("There is no such change of properties.")
        present = workspace.properties.of(id)
        made, remarks, what = change(present, workspace.open(dataset).names, body)
        shown = _summary(workspace, dataset, made) | {"remarks": list(remarks), "rows": _rows(present, made)}
        if body.get("preview"):
            return jsonify(shown)
        return jsonify(shown | {"before": workspace.properties.put(id, made, what, author)})

    return routes


Changed = tuple[Properties, Iterable[str], str]


def _from_table(present: Properties, clips: tuple[str, ...], body: Body) -> Changed:
    come, remarks = parse_properties(str(body.get("table", "")), clips)
    return present.with_values(come.values), remarks, f"{', '.join(come.columns)} from a table"


def _from_names(present: Properties, clips: tuple[str, ...], body: Body) -> Changed:
    found, left = by_pattern(str(body.get("pattern", "")), clips)
    if not found:
        raise BadRequest(f"No name of a clip has this form; the first is “{clips[0]}”.")
    some = f" ({', '.join(left[:3])}{' ...' if len(left) > 3 else ''})" if left else ""
    remarks = [
        f"{len(found)} of {len(clips)} names have this form.",
        *([f"{len(left)} have not{some}."] if left else []),
    ]
    return present.with_values(found), remarks, f"read from names: {body.get('pattern')}"


def _by_hand(present: Properties, clips: tuple[str, ...], body: Body) -> Changed:
    column, value = str(body.get("column", "")).strip(), str(body.get("value", "")).strip()
    chosen = [str(clip) for clip in body.get("clips") or ()]
    if unknown := set(chosen) - set(clips):
        raise BadRequest(f"There is no clip {min(unknown)[:80]!r}.")
    if not chosen:
        raise BadRequest("No clip is chosen.")
    made = present.with_values({clip: {column: value} for clip in chosen})
    return (
        made,
        mixed_words(column, made.columns.get(column, "text"), made.column(column) if column in made.columns else {}),
        f"{column} of {len(chosen)} clips",
    )


def _kind(present: Properties, clips: tuple[str, ...], body: Body) -> Changed:
    column, kind = str(body.get("column", "")), str(body.get("kind", ""))
    return present.with_kind(column, kind), (), f"{column} is a {kind}"


def _remove(present: Properties, clips: tuple[str, ...], body: Body) -> Changed:
    column = str(body.get("column", ""))
    return present.without_column(column), (), f"{column} removed"


CHANGES: dict[str, Callable[[Properties, tuple[str, ...], Body], Changed]] = {
    "table": _from_table,
    "names": _from_names,
    "set": _by_hand,
    "kind": _kind,
    "remove": _remove,
}
"""What can be done: (present, clips of the data set, request) -> properties, remarks, and what it was in few words."""


def _summary(workspace: Workspace, dataset: str, properties: Properties) -> dict[str, Any]:
    clips = workspace.open(dataset).names
    shown = properties.of_clips(clips)
    columns = []
    for name, kind in shown.columns.items():
        groups = shown.groups(name)
        columns.append(
            {
                "name": name,
                "kind": kind,
                "distinct": len(groups),
                "missing": len(clips) - sum(map(len, groups.values())),
                "values": [[value, len(groups[value])] for value in list(groups)[:MOST_VALUES]],
            }
        )
    return {"dataset": dataset, "clips": len(clips), "columns": columns, "first": clips[0] if clips else ""}


def _rows(before: Properties, after: Properties) -> list[dict[str, str]]:
    """Some of the clips whose values change, for a preview."""
    changed = (clip for clip, own in after.values.items() if dict(before.values.get(clip, {})) != dict(own))
    return [{"clip": clip} | dict(after.values[clip]) for _, clip in zip(range(MOST_ROWS), changed, strict=False)]
