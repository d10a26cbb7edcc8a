"""Searches in the app: the search of a link, its hits, and explanations of hits, for pages, routes and exports."""

from __future__ import annotations

import re
import threading
import time
from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from typing import Any

from core import analyses
from core.caching import RecentCache
from core.errors import MotionscapeError
from core.mocap.clip import Label, Segment
from core.mocap.dataset import Dataset
from core.retrieval.hits import Explanation, Hit
from core.retrieval.plausibility import plausibility
from core.retrieval.queries import Query, QueryPart, whole_query
from core.retrieval.search import SearchIndex
from core.workspace import Workspace, WorkspaceError
from webapp.features.search.queries import Piece, read_query, read_weights
from webapp.shell import settings
from webapp.shell.virtual import open_any
from webapp.ui.tables import labels_by_clip

PAGE = "search"
KEYS = ("query", "parts", "level", "route", "label", "named", "lasting", "top")
"""Keys of the store "view", and of links, that say what is searched for."""

FIRST, MOST = 30, 300  # hits that are shown at first, and at most
SAME = 0.5  # share of frames in common from which on a hit is the query itself


@dataclass(frozen=True)
class Search:
    """A search as a link asks for it.

    weights: of nodes or leaves, None for all alike. level: "clip" or "interval". route: 0 to 1, how much the path over
    the ground counts. label, named: the action and the text in the clip's name that hits must have, "" for any.
    lasting: seconds a hit must last, from and to. top: how many hits are shown.
    """

    pieces: tuple[Piece, ...]
    weights: Mapping[str, float] | None = None
    level: str = ""
    route: float = 0.0
    label: str = ""
    named: str = ""
    lasting: tuple[float, float] = (0.0, float("inf"))
    top: int = FIRST


@dataclass(frozen=True)
class SearchResult:
    """The hits of a search, best first; ``total``: how many there are without the limit of what is shown.

    unlike: clips that are left out because they are too unlike. chances: whether scores are chances.
    """

    search: Search
    query: Query
    level: str
    hits: tuple[Hit, ...]
    total: int
    milliseconds: float
    unlike: int = 0
    chances: bool = False


def search_keys_of(view: Mapping[str, str] | None) -> dict[str, str]:
    """The keys of a view that say which search it is."""
    return {key: text for key in KEYS if (text := (view or {}).get(key))}


def read(view: Mapping[str, str] | None) -> Search | None:
    """The search a view asks for, None where it has no query. Raises ParameterError."""
    view = view or {}
    if not view.get("query"):
        return None
    route = _number(view.get("route"), 0.0)
    return Search(
        read_query(view["query"]),
        read_weights(view.get("parts")),
        view["level"] if view.get("level") in ("clip", "interval") else "",
        min(max(route / 100, 0.0), 1.0),
        view.get("label", ""),
        view.get("named", ""),
        _lasting(view.get("lasting")),
        int(min(max(_number(view.get("top"), FIRST), 1), MOST)),
    )


def query_of(workspace: Workspace, dataset: Dataset, pieces: tuple[Piece, ...]) -> Query:
    """The query that the pieces of a link name. Raises WorkspaceError, ParameterError."""
    return Query(tuple(_part(workspace, dataset, piece) for piece in pieces), " + ".join(map(_piece_name, pieces)))


def source_of(workspace: Workspace, dataset: Dataset, piece: Piece) -> Dataset:
    """The data set that a piece is from. Raises WorkspaceError where there is none."""
    return open_any(workspace, piece.dataset) if piece.dataset else dataset


def level_of(search: Search, query: Query) -> str:
    """The kind of hits: whole clips if the query is a whole clip, else intervals, unless the link says which."""
    whole = all(part.start == 0 and part.end == part.clip.n_frames for part in query.parts)
    return search.level or ("clip" if whole else "interval")


def index_of(workspace: Workspace, dataset: str | None, view: Mapping[str, str] | None) -> SearchIndex | None:
    """The index that the settings of a view stand for, kept in memory; None where it has not been built."""
    return settings.result_of(workspace, PAGE, dataset, view)


def find(
    workspace: Workspace, dataset: Dataset, view: Mapping[str, str] | None, unlike_too: bool = False
) -> SearchResult | None:
    """The hits of a view's search; None where it has no query or the index has not been built.

    unlike_too: whether hits whose chance is below the index's ``least`` count too. Raises MotionscapeError for a query
    that cannot be searched for.
    """
    search = read(view)
    request = settings.request_of(PAGE, dataset.name, view)
    index = index_of(workspace, dataset.name, view) if search else None
    if search is None or index is None:
        return None
    place = analyses.key(workspace, request), repr((search, dataset.name, _marks(dataset, search), unlike_too))
    least = 0.0 if unlike_too else index.least
    return _recent.get_or_compute(
        place, lambda: _search(index, dataset, search, query_of(workspace, dataset, search.pieces), least)
    )


def warm(workspace: Workspace, dataset: Dataset, view: Mapping[str, str] | None) -> threading.Thread | None:
    """Opens the index of a view and searches it once in a thread, so that the first search of a person is fast.

    Returns the thread, or None where there is no index or it has been opened before.
    """
    key = settings.key_of(workspace, PAGE, dataset.name, view)
    with _warm_lock:
        if key is None or (workspace.path, key) in _warm or not dataset.clips:
            return None
        _warm.add((workspace.path, key))

    def search() -> None:
        clip = min(dataset.clips, key=lambda clip: clip.n_frames)
        query = whole_query(clip, 0, min(clip.n_frames, round(2 * clip.fps)))
        with suppress(MotionscapeError):
            index = index_of(workspace, dataset.name, view)
            if index is None:
                return
            for level in ("clip", "interval"):
                index.explain(query, index.search(query, level=level, top=1)[0])

    thread = threading.Thread(target=search, daemon=True)
    thread.start()
    return thread


def explain(workspace: Workspace, dataset: Dataset, view: Mapping[str, str] | None, hit: Segment) -> Explanation:
    """Why an interval is like the query of a view. Raises MotionscapeError, KeyError for a clip that is not indexed."""
    search, index = read(view), index_of(workspace, dataset.name, view)
    if search is None or index is None:
        raise WorkspaceError("There is no query, or the index has not been built yet.")
    return index.explain(query_of(workspace, dataset, search.pieces), hit, weights=search.weights)


def doubt(workspace: Workspace, dataset: Dataset, view: Mapping[str, str] | None, query: Query) -> str:
    """Why a query in pieces is not plausible as a motion, as a sentence; "" where it is, or cannot be checked.

    The default engine knows the postures; without its index the query is not checked.
    """
    index = index_of(workspace, dataset.name, dict(view or {}) | {f"{PAGE}-method": "bounded-edit"})
    if index is None or not query.hybrid:
        return ""
    try:
        return plausibility(index, query).message or ""
    except MotionscapeError:
        return ""


def tag_of(labels: Mapping[str, Sequence[Label]], segment: Segment) -> str:
    """The label that covers most of a stretch and its share: ``kick 51 %``; the label alone where it covers all."""
    covered, action = _covered_frames(labels, segment), label_of(labels, segment)
    share = round(100 * covered[action] / segment.n_frames) if action else 100
    return action if share >= 100 else f"{action} {max(share, 1)} %"


def label_of(labels: Mapping[str, Sequence[Label]], segment: Segment) -> str:
    """The label that covers most of a stretch's frames, "" where none covers any; labels: of each clip."""
    covered = _covered_frames(labels, segment)
    return max(covered, key=covered.__getitem__, default="")


def _covered_frames(labels: Mapping[str, Sequence[Label]], segment: Segment) -> dict[str, int]:
    """How many frames of a stretch each label covers."""
    covered: dict[str, int] = {}
    for label in labels.get(segment.clip, ()):
        common = min(label.end, segment.end) - max(label.start, segment.start)
        if common > 0:
            covered[label.action] = covered.get(label.action, 0) + common
    return covered


def _search(index: SearchIndex, dataset: Dataset, search: Search, query: Query, least: float) -> SearchResult:
    level = level_of(search, query)
    started = time.perf_counter()
    only = _possible_clips(dataset, search, level)
    if level == "clip":
        query_clips = {piece.clip for piece in search.pieces if not piece.dataset}
        options: dict[str, Any] = {"only": [name for name in only if name not in query_clips]}
    else:
        options = {"only": only, "top": MOST}
    hits = index.search(query, weights=search.weights, level=level, root_path=search.route, **options)
    labels = labels_by_clip(dataset) if search.label else {}
    hits = [hit for hit in hits if level == "clip" or _passes_filters(dataset, search, labels, hit)]
    milliseconds = 1000 * (time.perf_counter() - started)
    alike = [hit for hit in hits if hit.score >= least]
    unlike = len(hits) - len(alike)
    return SearchResult(
        search, query, level, tuple(alike[: search.top]), len(alike), milliseconds, unlike, index.least > 0
    )


def _possible_clips(dataset: Dataset, search: Search, level: str) -> list[str]:
    """Names of the clips in which hits may lie."""
    labelled = {label.clip for label in dataset.labels if label.action == search.label}
    low, high = search.lasting
    return [
        clip.name
        for clip in dataset.clips
        if search.named.lower() in clip.name.lower()
        and (not search.label or clip.name in labelled)
        and (level != "clip" or low <= clip.seconds <= high)
    ]


def _passes_filters(dataset: Dataset, search: Search, labels: Mapping[str, Sequence[Label]], hit: Hit) -> bool:
    """Whether a moment passes the filters, and is not the query itself."""
    segment = hit.segment
    low, high = search.lasting
    if not low <= segment.n_frames / dataset.clip(segment.clip).fps <= high:
        return False
    if search.label and label_of(labels, segment) != search.label:
        return False
    return not any(_overlap(segment, piece) > SAME for piece in search.pieces if not piece.dataset)


def _overlap(segment: Segment, piece: Piece) -> float:
    """Frames in common as a share of those in either."""
    common = min(segment.end, piece.end) - max(segment.start, piece.start) if segment.clip == piece.clip else 0
    return max(common, 0) / (segment.n_frames + piece.end - piece.start - max(common, 0))


def _part(workspace: Workspace, dataset: Dataset, piece: Piece) -> QueryPart:
    source = source_of(workspace, dataset, piece)
    if piece.clip not in source.names:
        raise WorkspaceError(f"“{source.name}” has no clip called “{piece.clip[:80]}”.")
    return QueryPart(piece.leaves, source.clip(piece.clip), piece.start, piece.end)


def _piece_name(piece: Piece) -> str:
    return f"{piece.clip}:{piece.start}-{piece.end}"


def _marks(dataset: Dataset, search: Search) -> int:
    """A mark that changes with the labels where they matter, since the index does not hold them."""
    return hash(dataset.labels) if search.label else 0


def _number(text: str | None, default: float) -> float:
    return float(text) if text and re.fullmatch(r"\d{1,6}(\.\d{1,4})?", text) else default


def _lasting(text: str | None) -> tuple[float, float]:
    """Seconds from and to, out of ``1.5-4``, ``-4`` or ``1.5-``."""
    low, dash, high = (text or "").partition("-")
    return (_number(low, 0.0), _number(high, float("inf"))) if dash else (0.0, float("inf"))


_warm: set[tuple] = set()  # workspace and key of indexes that have been searched
_warm_lock = threading.Lock()
_recent: RecentCache[tuple[str, str], SearchResult] = RecentCache(64)
