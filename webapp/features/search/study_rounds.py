"""The study of PCR section 5.3 as a tool: the pairs that people see, and how their answers are kept.

A query's first hits of every engine whose index is there are shown beside the query. People do not see which engine
found what: the browser gets motions without names, and the server looks the engines up when an answer comes.
"""

from __future__ import annotations

import hashlib
import random
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import combinations
from typing import Any

from core.evaluation.agreement import Vote
from core.mocap.clip import Segment
from core.mocap.dataset import Dataset
from core.retrieval.search import ENGINES
from core.workspace import Workspace, WorkspaceError
from webapp.features.search import searching
from webapp.features.search.queries import Piece, read_hit, write_hit, write_query
from webapp.shell import settings

PER_QUERY = 6  # hits of each engine, as in the paper
DRAWN = 3  # queries drawn at once, as in the paper
MOST_QUERIES = 12
LONGEST = 12.0  # seconds of a clip that is drawn as a query; of a longer one a stretch is
STRETCH = 3.0  # seconds


@dataclass(frozen=True)
class Pair:
    """A query and a hit; ``ranks``: engine -> the hit's place in its list, from 1."""

    query: Segment
    hit: Segment
    ranks: Mapping[str, int]


@dataclass(frozen=True)
class Duel:
    """A query and two hits; ``sides``: (engine of the left one, its rank, engine of the right one, its rank)."""

    query: Segment
    left: Segment
    right: Segment
    sides: tuple[tuple[str, int, str, int], ...]


def queries_of(view: Mapping[str, str] | None) -> list[Segment]:
    """The queries of the study that a link names."""
    words = [word for word in (view or {}).get("asks", "").split(",") if word]
    entries = [read_hit(word) for word in words[:MOST_QUERIES]]
    return list(dict.fromkeys(segment for segment in entries if segment is not None))


def ready_engines(workspace: Workspace, dataset: str, view: Mapping[str, str] | None) -> dict[str, bool]:
    """Every engine, and whether its index has been built."""
    return {
        name: settings.key_of(workspace, searching.PAGE, dataset, with_engine(view, name)) is not None
        for name in ENGINES
    }


def with_engine(view: Mapping[str, str] | None, engine: str) -> dict[str, str]:
    """The settings of a view with another engine."""
    index_settings = {key: text for key, text in (view or {}).items() if key.startswith(f"{searching.PAGE}-")}
    return index_settings | {f"{searching.PAGE}-method": engine}


def pairs(workspace: Workspace, dataset: Dataset, view: Mapping[str, str] | None) -> list[Pair]:
    """The pairs to be rated: each query with the first hits of every engine, every hit once.

    Raises WorkspaceError or ValueError, in plain words, for a query that cannot be searched for.
    """
    entries: dict[tuple[Segment, Segment], dict[str, int]] = {}
    for query, engine, rank, hit in _lists(workspace, dataset, view):
        entries.setdefault((query, hit), {})[engine] = rank
    return [Pair(query, hit, ranks) for (query, hit), ranks in entries.items()]


def duels(workspace: Workspace, dataset: Dataset, view: Mapping[str, str] | None, person: str) -> list[Duel]:
    """The pairs of hits to be compared: those of one rank by two engines, and within an engine three ranks apart.

    Which stands left is drawn for each person. Raises as :func:`pairs`.
    """
    lists: dict[tuple[Segment, str], dict[int, Segment]] = {}
    for query, engine, rank, hit in _lists(workspace, dataset, view):
        lists.setdefault((query, engine), {})[rank] = hit
    entries: dict[tuple[Segment, Segment, Segment], list[tuple[str, int, str, int]]] = {}
    for query, (a, i, first), (b, j, second) in _compared(lists):
        if first == second:
            continue
        sides = (a, i, b, j)
        if _chance(person, query, *sorted((first, second))).random() < 0.5:
            first, second, sides = second, first, (b, j, a, i)
        entries.setdefault((query, first, second), []).append(sides)
    return [Duel(*three, tuple(sides)) for three, sides in entries.items()]


def keep_rating(workspace: Workspace, dataset: Dataset, view: Mapping[str, str] | None, answer: Mapping[str, Any]):
    """Keeps a rating {"query", "hit", "value", "person"} for every engine that found the hit. Raises WorkspaceError."""
    query, hit = read_hit(str(answer.get("query"))), read_hit(str(answer.get("hit")))
    pair = next((p for p in pairs(workspace, dataset, view) if (p.query, p.hit) == (query, hit)), None)
    if pair is None:
        raise WorkspaceError("This pair is no part of the study any more.")
    store, person = workspace.info(dataset.name).id, str(answer.get("person", ""))
    for engine, rank in pair.ranks.items():
        workspace.ratings.put_rating(store, pair.query, pair.hit, engine, rank, int(answer["value"]), person=person)


def keep_vote(workspace: Workspace, dataset: Dataset, view: Mapping[str, str] | None, answer: Mapping[str, Any]):
    """Keeps a vote {"query", "left", "right", "choice", "person"}. Raises WorkspaceError."""
    person = str(answer.get("person", ""))
    three = tuple(read_hit(str(answer.get(key))) for key in ("query", "left", "right"))
    duel = next((d for d in duels(workspace, dataset, view, person) if (d.query, d.left, d.right) == three), None)
    if duel is None:
        raise WorkspaceError("This pair is no part of the study any more.")
    for a, i, b, j in duel.sides:
        vote = Vote(duel.query, duel.left, duel.right, a, b, i, j, str(answer.get("choice")), person)
        workspace.ratings.put_vote(workspace.info(dataset.name).id, vote)


def draw_queries(dataset: Dataset, seed: int, n: int = DRAWN) -> list[Segment]:
    """Random queries: labelled stretches of different actions where there are labels, else clips or parts of long ones.

    n: how many, fewer where there are not as many.
    """
    chance = random.Random(seed)
    by_action: dict[str, list[Segment]] = {}
    for label in dataset.labels:
        if 0.5 <= (label.end - label.start) / dataset.clip(label.clip).fps <= LONGEST:
            by_action.setdefault(label.action, []).append(Segment(label.clip, label.start, label.end))
    if by_action:
        actions = chance.sample(sorted(by_action), min(n, len(by_action)))
        return [chance.choice(by_action[action]) for action in actions]
    drawn = []
    for clip in chance.sample(list(dataset.clips), min(n, len(dataset.clips))):
        length = min(clip.n_frames, round(STRETCH * clip.fps)) if clip.seconds > LONGEST else clip.n_frames
        start = chance.randrange(clip.n_frames - length + 1)
        drawn.append(Segment(clip.name, start, start + length))
    return drawn


def shown_pairs(dataset: Dataset, entries: list[Pair], person: str, answers: Mapping[tuple[Segment, Segment], int]):
    """Pairs for the browser in an order drawn for each person, without a word about engines."""
    rows = [
        {
            "query": write_hit(pair.query),
            "hit": write_hit(pair.hit),
            "value": answers.get((pair.query, pair.hit)),
            "request": _request(dataset, [(pair.query, "Query", "#4a7cd8"), (pair.hit, "Result", "#3a9b7a")]),
        }
        for pair in entries
    ]
    _chance(person, "order", len(rows)).shuffle(rows)
    return rows


def shown_duels(
    dataset: Dataset, entries: list[Duel], person: str, answers: Mapping[tuple[Segment, Segment, Segment], str]
):
    """Duels for the browser, as :func:`shown_pairs`; the query stands in the middle."""
    rows = [
        {
            "query": write_hit(duel.query),
            "left": write_hit(duel.left),
            "right": write_hit(duel.right),
            "value": answers.get((duel.query, duel.left, duel.right)),
            "request": _request(
                dataset,
                [(duel.left, "A", "#3a9b7a"), (duel.query, "Query", "#4a7cd8"), (duel.right, "B", "#d2762b")],
            ),
        }
        for duel in entries
    ]
    _chance(person, "duels", len(rows)).shuffle(rows)
    return rows


def _lists(workspace: Workspace, dataset: Dataset, view) -> Iterator[tuple[Segment, str, int, Segment]]:
    """Every hit of the study: query, engine, rank, hit."""
    engines = [name for name, ready in ready_engines(workspace, dataset.name, view).items() if ready]
    for query in queries_of(view):
        for engine in engines:
            search_view = with_engine(view, engine) | {"query": write_query([Piece(*query)]), "top": str(PER_QUERY)}
            entries = searching.find(workspace, dataset, search_view, unlike_too=True)
            for rank, hit in enumerate(entries.hits if entries else (), 1):
                yield query, engine, rank, hit.segment


def _compared(lists: Mapping[tuple[Segment, str], Mapping[int, Segment]]):
    """(query, (engine, rank, hit), (engine, rank, hit)) of all informative comparisons."""
    engines: dict[Segment, list[str]] = {}
    for query, engine in lists:
        engines.setdefault(query, []).append(engine)
    for query, names in engines.items():
        for a, b in combinations(names, 2):
            for rank in range(1, PER_QUERY // 2 + 1):
                if rank in lists[query, a] and rank in lists[query, b]:
                    yield query, (a, rank, lists[query, a][rank]), (b, rank, lists[query, b][rank])
        for name in names:
            ranked, apart = lists[query, name], PER_QUERY // 2
            for rank in range(1, apart + 1):
                if rank in ranked and rank + apart in ranked:
                    yield query, (name, rank, ranked[rank]), (name, rank + apart, ranked[rank + apart])


def _chance(*parts: object) -> random.Random:
    """A random generator that is the same for the same parts, on every machine."""
    return random.Random(hashlib.blake2b(repr(parts).encode(), digest_size=8).hexdigest())


def _request(dataset: Dataset, figures: list[tuple[Segment, str, str]]) -> dict[str, Any]:
    """What the Stage plays: motions side by side at their own pace, without the names of their clips."""
    items = [
        {"clip": s.clip, "start": s.start, "end": s.end, "label": label, "colour": colour}
        for s, label, colour in figures
    ]
    content = {"dataset": dataset.name, "version": dataset.fingerprint, "title": "How alike?", "items": items}
    return {**content, "layout": "side", "sync": "start"}
