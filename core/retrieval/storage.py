"""What an index holds and how large it is: the figures of the paper's Tables 1, 2 and 3 (PCR sections 3 and 5.1)."""

from __future__ import annotations

import time
from dataclasses import dataclass

from core.mocap.clip import Clip
from core.retrieval.node_index import NodeReport
from core.retrieval.queries import whole_query
from core.retrieval.search import Engine, SearchIndex


@dataclass(frozen=True)
class Storage:
    """A column of Table 3, sizes in bytes. seconds: what building the index took; query: a query's, None if not asked.

    library: motion pattern library; lists: pattern index lists; maps: pattern dissimilarity maps; frames: the postures
    that the engine compares or verifies with, which the paper does not count. nodes: rows of Tables 1 and 2, whose
    frames are of ``fps`` a second. An engine without patterns has frames alone.
    """

    seconds: float
    clips: int
    frames: int
    library: int
    lists: int
    maps: int
    fps: float
    nodes: tuple[NodeReport, ...]
    query: float | None = None


def storage_of(index: SearchIndex, clip: Clip | None = None) -> Storage:
    """The figures of an index; where it has several engines, their sums, and the nodes of the first.

    clip: a query, whose processor time is measured once what all queries share is there.
    """
    engines = (index.engine, *index.others)
    sizes = [_sizes(engine) for engine in engines]
    frames = sum(engine.store.codes.nbytes for engine in engines)
    library, lists, maps = (sum(column) for column in zip(*sizes, strict=True))
    nodes = tuple(node.report() for node in getattr(index.engine, "nodes", {}).values())
    seconds = float(sum(index.seconds.values()))
    query = _seconds_of(index, clip) if clip else None
    return Storage(seconds, len(index.clips), frames, library, lists, maps, index.engine.store.fps, nodes, query)


def _seconds_of(index: SearchIndex, clip: Clip) -> float:
    query = whole_query(clip)
    index.search(query)
    started = time.process_time()
    index.search(query)
    return time.process_time() - started


def _sizes(engine: Engine) -> tuple[int, int, int]:
    """Bytes of library, lists and maps of an engine. Maps are counted as they are when a search has needed them."""
    nodes = getattr(engine, "nodes", {}).values()
    library = sum(node.library.patterns.nbytes for node in nodes)
    lists = sum(node.symbols.nbytes + node.begins.nbytes + node.ends.nbytes + node.starts.nbytes for node in nodes)
    maps = sum(len(node.library.patterns) ** 2 * node.library.patterns.itemsize for node in nodes)
    return library, lists, maps
