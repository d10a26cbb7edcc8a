"""Routes of boards, saved views and comments: JSON under ``/api``.

A board that is open asks once a second whether it has changed; the answer costs a few queries and is empty where it has
not (ETag). What someone else has changed meanwhile is refused with 409 and both versions.
"""

from __future__ import annotations

import hashlib
import json
from dataclasses import asdict, is_dataclass
from typing import Any
from urllib.parse import quote

from flask import Blueprint, Response, jsonify, request

from core import analyses
from core.errors import ParameterError
from core.workspace import AccessRefused, ConflictError, DocumentGone, Workspace, WorkspaceError
from core.workspace.blocks import Block
from webapp import jobs
from webapp.features.boards.board_changes import CHANGES, pinned_to, whole_of
from webapp.features.boards.contents import answer, request_of
from webapp.features.boards.discussion import said_about
from webapp.features.boards.documents import (
    board_data,
    board_entry,
    board_mark,
    clips_of_group,
    comment_data,
    dataset_of,
    kinds,
    part_of,
    view_entry,
)
from webapp.features.boards.pictures import keep_picture, picture_of
from webapp.features.boards.report_writing import Reports
from webapp.features.boards.templates import TEMPLATES, blocks_of
from webapp.shell.routes import ASK_AGAIN, BadRequest, answer_errors, json_body, response_with_etag


def blueprints(workspace: Workspace) -> list[Blueprint]:
    """The routes of the page for one workspace."""
    routes = Blueprint("boards", __name__, url_prefix="/api")
    answer_errors(routes)
    _answer_refusals(routes)
    _list_routes(routes, workspace)
    _board_routes(routes, workspace)
    _view_routes(routes, workspace)
    _comment_routes(routes, workspace)
    _report_routes(routes, workspace)
    return [routes]


def _answer_refusals(routes: Blueprint) -> None:
    @routes.errorhandler(ConflictError)
    def _conflict(error: ConflictError) -> tuple[Response, int]:
        present = error.present
        theirs = asdict(present) if is_dataclass(present) and not isinstance(present, type) else None
        return jsonify(error=str(error), conflict=True, theirs=theirs, author=error.author), 409

    @routes.errorhandler(DocumentGone)
    def _gone(error: DocumentGone) -> tuple[Response, int]:
        return jsonify(error=str(error), gone=True), 404

    @routes.errorhandler(AccessRefused)
    def _refused(error: AccessRefused) -> tuple[Response, int]:
        return jsonify(error=str(error), refused=True), 403


def _list_routes(routes: Blueprint, workspace: Workspace) -> None:
    @routes.get("/boards")
    def list_boards() -> Response:
        content = {
            "boards": [board_entry(board) for board in workspace.boards.all()],
            "views": [view_entry(view) for view in workspace.views.all()],
            "damaged": [*workspace.boards.damaged(), *workspace.views.damaged()],
            "templates": [
                {"name": name, "title": t.title, "words": t.words, "shape": [[*b[2:6], b[0]] for b in t.blocks]}
                for name, t in TEMPLATES.items()
            ],
            "kinds": kinds(),
        }
        text = json.dumps(content)
        return response_with_etag([_digest(text)], False, lambda: text, "application/json")

    @routes.post("/boards")
    def make_board() -> Response:
        body = json_body()
        template = TEMPLATES.get(str(body.get("template", "empty")))
        if template is None:
            raise BadRequest("There is no such template.")
        title, author = str(body.get("title") or template.title), str(body.get("author", ""))
        dataset = str(body.get("dataset", ""))
        blocks = [pinned_to(workspace, dataset, block) for block in blocks_of(template)]
        board = workspace.boards.create(title, blocks, author, str(body.get("note", "")))
        if dataset:
            board = workspace.boards.set_filters(board.id, {"dataset": dataset}, author)
        return jsonify(board_data(workspace, board.id))


def _board_routes(routes: Blueprint, workspace: Workspace) -> None:
    @routes.get("/boards/<id>")
    def show_board(id: str) -> Response:
        mark = board_mark(workspace, id)
        return response_with_etag(
            [mark], False, lambda: json.dumps(board_data(workspace, id) | {"mark": mark}), "application/json"
        )

    @routes.post("/boards/<id>")
    def change_board(id: str) -> Response:
        body = json_body()
        change = CHANGES.get(str(body.get("action")))
        if change is None:
            raise BadRequest("There is no such change of a board.")
        made = change(workspace, id, body, str(body.get("author", "")))
        if made == "":
            return jsonify(deleted=True)
        return jsonify(board_data(workspace, made or id))

    @routes.get("/boards/<id>/history")
    def board_history(id: str) -> Response:
        return jsonify(history=[asdict(change) for change in workspace.boards.history(id)])

    @routes.get("/boards/<id>/group")
    def board_group(id: str) -> Response:
        return jsonify(clips=clips_of_group(workspace, workspace.boards.get(id), request.args.get("of", "")))

    @routes.get("/boards/<id>/blocks/<block_id>")
    def show_block(id: str, block_id: str) -> Response:
        board = workspace.boards.get(id)
        block = board.block(block_id)
        if block is None:
            raise BadRequest("This block has been removed.", 404)
        found = answer(workspace, dataset_of(board, block), part_of(block), block.settings.get("pinned"))
        shown = found._asdict() | {"job": _job(workspace, dataset_of(board, block), block)}
        text = json.dumps(shown, default=dict)
        return response_with_etag([_digest(text)], False, lambda: text, "application/json")

    @routes.post("/boards/<id>/blocks/<block_id>/compute")
    def compute_block(id: str, block_id: str) -> Response:
        board = workspace.boards.get(id)
        block = board.block(block_id)
        if block is None:
            raise BadRequest("This block has been removed.", 404)
        asked = request_of(dataset_of(board, block), part_of(block))
        if asked is None:
            raise BadRequest("There is nothing to compute behind this block.")
        job = jobs.start(workspace, asked)
        return jsonify(job=job.id)


def _job(workspace: Workspace, dataset: str, block: Block) -> dict[str, Any] | None:
    """The newest job for the result behind a block, while it runs or where it failed."""
    asked = request_of(dataset, part_of(block)) if dataset else None
    try:
        job = workspace.jobs.latest(analyses.key(workspace, asked)) if asked else None
    except (ParameterError, WorkspaceError):
        return None
    if job is None or not (job.alive or job.state == "failed"):
        return None
    return {"id": job.id, "state": job.state, "fraction": round(job.fraction, 2), "error": job.error}


def _view_routes(routes: Blueprint, workspace: Workspace) -> None:
    @routes.post("/views")
    def save_view() -> Response:
        body = json_body()
        tags = [str(tag) for tag in body.get("tags", ())]
        address, title, note, author = (str(body.get(name, "")) for name in ("address", "title", "note", "author"))
        id, version = body.get("id"), body.get("version")
        view = workspace.views.save(address, title, note, tags, author, str(id) if id else None, version)
        if body.get("picture"):
            keep_picture(workspace, view.id, view.version, str(body["picture"]))
        return jsonify(view_entry(view))

    @routes.post("/views/<id>")
    def change_view(id: str) -> Response:
        body = json_body()
        if body.get("action") == "delete":
            workspace.views.delete(id)
            return jsonify(deleted=True)
        if body.get("action") == "undelete":
            return jsonify(view_entry(workspace.views.undelete(id)))
        if body.get("action") == "restore":
            restored = workspace.views.restore(id, whole_of(body, "version"), str(body.get("author", "")))
            return jsonify(view_entry(restored))
        if body.get("action") == "picture":
            view = workspace.views.get(id)
            keep_picture(workspace, id, view.version, str(body.get("picture", "")))
            return jsonify(view_entry(view))
        raise BadRequest("There is no such change of a view.")

    @routes.get("/views/<id>/history")
    def view_history(id: str) -> Response:
        return jsonify(history=[asdict(change) for change in workspace.views.history(id)])

    @routes.get("/views/<id>/picture")
    def view_picture(id: str) -> Response:
        version = workspace.views.version(id)
        picture = picture_of(workspace, id, version)
        if picture is None:
            return Response(status=204)  # no fault that a browser would log: the list shows the page's name instead
        answer_ = Response(picture, mimetype="image/jpeg")
        answer_.headers["Cache-Control"] = ASK_AGAIN
        return answer_


def _comment_routes(routes: Blueprint, workspace: Workspace) -> None:
    @routes.get("/comments")
    def show_comments() -> Response:
        return jsonify(said_about(workspace, request.args) or {})

    @routes.post("/comments")
    def change_comments() -> Response:
        body = json_body()
        comments, id = workspace.comments, str(body.get("id", ""))
        action = body.get("action")
        if action == "add":
            parent = body.get("parent")
            place, text = str(body.get("place", "")), str(body.get("text", ""))
            comment = comments.add(place, text, str(body.get("author", "")), parent and str(parent))
        elif action == "edit":
            comment = comments.edit(id, str(body.get("text", "")), whole_of(body, "version"))
        elif action in ("resolve", "reopen", "undelete"):
            comment = getattr(comments, action)(id)
        elif action == "delete":
            comments.delete(id)
            return jsonify(deleted=True)
        else:
            raise BadRequest("There is no such change of a comment.")
        return jsonify(comment_data(comment))


def _report_routes(routes: Blueprint, workspace: Workspace) -> None:
    reports = Reports(workspace)

    @routes.get("/report/<dataset>")
    def show_report(dataset: str) -> Response:
        form = request.args.get("form", "html")
        if form not in ("html", "pdf"):
            raise BadRequest("A report is written as html or pdf.")
        board = workspace.boards.get(request.args["board"]) if request.args.get("board") else None
        again = bool(request.args.get("again"))
        return jsonify(reports.ask(dataset, board, "pdf" if form == "pdf" else "html", again))

    @routes.get("/report/<dataset>/<key>")
    def report_file(dataset: str, key: str) -> Response:
        workspace.info(dataset)  # raises for those who may not see it
        found = reports.file(key)
        if found is None:
            raise BadRequest("This report is not ready, or what it shows has changed: ask for it again.", 404)
        name, content = found
        sent = Response(content, mimetype="application/octet-stream")
        sent.headers["Content-Disposition"] = f"attachment; filename*=UTF-8''{quote(name)}"
        return sent


def _digest(text: str) -> str:
    return hashlib.blake2b(text.encode(), digest_size=16).hexdigest()
