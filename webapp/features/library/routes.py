"""Downloads: ``GET /api/bvh/<dataset>/<clip>?start=&end=``, ``/api/features/<dataset>.npz`` and ``.parquet``."""

from __future__ import annotations

import tempfile
from collections.abc import Callable
from pathlib import Path
from urllib.parse import quote

from flask import Blueprint, Response, request

from core import analyses
from core.errors import ParameterError
from core.export import labelled, write_features
from core.export.files import SUFFIXES
from core.mocap.bvh import write_bvh
from core.mocap.dataset import Dataset
from core.workspace import Workspace, WorkspaceError, clean_name
from webapp.features.library.property_routes import properties_blueprint
from webapp.shell.virtual import opener
from webapp.stage.motion_routes import BadRequest, answer_errors, find_interval


def blueprints(workspace: Workspace) -> list[Blueprint]:
    """The routes of the page for one workspace."""
    return [recordings_blueprint(workspace, opener(workspace)), properties_blueprint(workspace)]


def recordings_blueprint(workspace: Workspace, open_dataset: Callable[[str], Dataset]) -> Blueprint:
    """The routes; ``open_dataset`` opens datasets and made-up motion by name (see shell/virtual.py)."""
    blueprint = Blueprint("recordings", __name__, url_prefix="/api")
    answer_errors(blueprint)

    @blueprint.get("/bvh/<dataset>/<path:clip>", merge_slashes=False)
    def bvh(dataset: str, clip: str) -> Response:
        interval = find_interval(open_dataset, dataset, clip)
        whole = interval.end - interval.start == interval.clip.n_frames
        name = interval.clip.name if whole else f"{interval.clip.name} {interval.start}-{interval.end}"
        return _file(f"{name}.bvh", lambda path: write_bvh(path, interval.clip.cut(interval.start, interval.end, name)))

    @blueprint.get("/features/<name>")
    def features(name: str) -> Response:
        dataset, dot, suffix = name.rpartition(".")
        if dot + suffix not in SUFFIXES:
            raise BadRequest(f"Features are written as {' or '.join(SUFFIXES)}.", 404)
        try:
            values = {
                p.name: p.parse(request.args[p.name]) for p in analyses.parameters("features") if p.name in request.args
            }
            table = analyses.stored(workspace, analyses.Request(dataset, "features", values))
        except ParameterError as error:
            raise BadRequest(f"{error}.") from None
        except WorkspaceError as error:
            raise BadRequest(str(error), 404) from None
        if table is None:
            raise BadRequest("The features of this dataset have not been computed yet.", 404)
        table = labelled(table, workspace.open(dataset))
        return _file(f"{dataset}-features{dot}{suffix}", lambda path: write_features(path, table))

    return blueprint


def _file(name: str, write: Callable[[Path], None]) -> Response:
    """A download of this name with the content that ``write`` writes."""
    with tempfile.TemporaryDirectory(prefix="motionscape-") as folder:
        path = Path(folder, "file" + Path(name).suffix)
        write(path)
        answer = Response(path.read_bytes(), mimetype="application/octet-stream")
    answer.headers["Content-Disposition"] = f"attachment; filename*=UTF-8''{quote(clean_name(name))}"
    return answer
