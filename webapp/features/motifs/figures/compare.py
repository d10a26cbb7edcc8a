"""Two results side by side: a sentence, a table, a flow diagram, and what the Stage plays."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from types import MappingProxyType
from typing import Any

import numpy as np

from core.mocap.dataset import Dataset
from core.motifs.compare import Comparison, Fate
from core.motifs.graph import Motif, MotifGraph
from webapp.ui.tables import SECONDS, STRIP, column, strip_address

WORDS = {"kept": "Kept", "split": "Split", "merged": "Merged", "lost": "Gone", "gained": "New"}
HERE, THERE = "#4a7cd8", "#d2762b"  # colours of figures of this and of the other result
MOST_EACH = 3  # motions of a motif on the Stage, the most typical first
_HEIGHTS = 240.0, 720.0  # of the picture, pixels
_GAP = 3.0  # pixels between two bars
_LEAST_SHARE, _THINNEST = 0.05, 0.3  # of either motif, and pixels: thinner ribbons are not drawn

COLUMNS = [
    column("change", "Change", 96, "What became of the motif", cellRenderer="Change", cellClass="strip-cell"),
    column("here", "This result", 96, "Motif of the result shown above", tooltipField="here"),
    {"field": "here_strip", **STRIP, "headerName": "", "minWidth": 94},
    column("there", "The other", 92, "Motifs of the other result that share most of it", tooltipField="there"),
    {"field": "there_strip", **STRIP, "headerName": "", "minWidth": 94},
    column(
        "overlap",
        "Overlap",
        112,
        "Share of their motion that both have, of what either has",
        cellRenderer="Share",
        cellClass="strip-cell",
    ),
    column("seconds", "Seconds", 80, "Motion in it, here", **SECONDS),
]

Names = Callable[[int], str]
Row = dict[str, Any]


def sentence(comparison: Comparison) -> str:
    """What changed, in plain words."""
    here, there = comparison.counts("a"), comparison.counts("b")
    overlaps_kept = [link.overlap for link in comparison.links if link.kept]
    if not comparison.a and not comparison.b:
        return "Neither result has motifs."
    words = f"{here['kept']} of {_motifs(len(comparison.a))} {_is(here['kept'])} kept in the other result"
    words += f", with {np.mean(overlaps_kept):.0%} overlap on average" if overlaps_kept else ""
    others = [
        f"{here['split']} {_is(here['split'])} split" if here["split"] else "",
        f"{here['merged']} {_is(here['merged'])} merged with others" if here["merged"] else "",
        f"{here['lost']} {_is(here['lost'])} gone" if here["lost"] else "",
    ]
    words += "".join(f"; {other}" for other in others if other) + "."
    words += (
        f" {there['gained']} of its {_motifs(len(comparison.b))} {_is(there['gained'])} new." if comparison.b else ""
    )
    return f"{words} {comparison.agreement:.0%} of all motion lies the same way in both."


def _motifs(n: int) -> str:
    return f"{n} motif{'' if n == 1 else 's'}"


def _is(n: int) -> str:
    return "is" if n == 1 else "are"


def filters(comparison: Comparison) -> list[dict[str, str]]:
    """Choices of a control that shows only one kind of change, with how many there are."""
    counts = comparison.counts("a") | {"gained": comparison.counts("b")["gained"]}
    options = [{"value": change, "label": f"{WORDS[change]} {n}"} for change, n in counts.items() if n]
    return [{"value": "all", "label": f"All {sum(counts.values())}"}, *options]


def rows(
    comparison: Comparison,
    a: MotifGraph,
    b: MotifGraph,
    dataset: Dataset,
    names: Mapping[int, str] = MappingProxyType({}),
) -> list[Row]:
    """A row for each motif of this result, then for each new one of the other; names: people's names of the former."""
    motifs_a, motifs_b = ({motif.id: motif for motif in graph.motifs} for graph in (a, b))
    overlaps = {(link.a, link.b): link.overlap for link in comparison.links}

    def strip(motif: Motif) -> str:
        return strip_address(dataset.name, motif.segments[motif.medoid], 4, dataset.fingerprint)

    def row(fate: Fate) -> Row:
        first = fate.partners[0] if fate.partners else None
        return {
            "key": f"a{fate.motif}",
            "change": fate.change,
            "here": f"{fate.motif} {names.get(fate.motif, '')}".strip(),
            "here_strip": strip(motifs_a[fate.motif]),
            "there": ", ".join(map(str, fate.partners)),
            "there_strip": strip(motifs_b[first]) if first is not None else "",
            "overlap": None if first is None else round(overlaps[fate.motif, first], 3),
            "seconds": round(fate.seconds, 1),
            "selection": {"motif": fate.motif},
        }

    def new(fate: Fate) -> Row:
        empty: Row = {"here": "", "here_strip": "", "overlap": None, "selection": {}}
        shown = {"there": str(fate.motif), "there_strip": strip(motifs_b[fate.motif])}
        change = {"key": f"b{fate.motif}", "change": fate.change, "seconds": round(fate.seconds, 1)}
        return change | empty | shown | {"view": {"gained": str(fate.motif)}}

    return [*map(row, comparison.a), *(new(fate) for fate in comparison.b if fate.change == "gained")]


def flow(comparison: Comparison, names: Mapping[int, str] = MappingProxyType({})) -> dict[str, Any]:
    """Bars of both results, as high as the motion in them, and ribbons for the motion they share.

    height: pixels; bars: {side ("a" or "b"), motif (None: in no motif), label, y, h, change, title}; ribbons: {a, b
    (motifs or None), ya, yb, h, kind, title}; y and h in pixels from the top. This result's motifs stand kept ones
    first, the other's about beside what they share, "in no motif" last.
    """
    shared = comparison.shared.toarray()
    rank = {change: k for k, change in enumerate(WORDS)}
    order_a = sorted(range(len(comparison.a)), key=lambda i: (rank[comparison.a[i].change], -comparison.a[i].seconds))
    order_b = _beside(comparison, shared[1:, 1:], order_a)
    n = max(len(order_a), len(order_b)) + 1
    height = float(np.clip(17 * n, *_HEIGHTS))
    gap = min(_GAP, height / (4 * n))
    scale = (height - gap * (n - 1)) / max(float(shared.sum()), 1e-12)
    order_a, order_b = ([*(k + 1 for k in order), 0] for order in (order_a, order_b))
    bars_a = _bars("a", comparison.a, order_a, shared.sum(1) * scale, gap, names)
    bars_b = _bars("b", comparison.b, order_b, shared.sum(0) * scale, gap, {})
    for bar in bars_a + bars_b:
        bar["title"] += f": {bar['h'] / scale:.1f} s" + (f", {WORDS[bar['change']].lower()}" if bar["change"] else "")
    return {
        "height": round(height, 1),
        "bars": [_rounded(bar) for bar in bars_a + bars_b],
        "ribbons": [
            _rounded(ribbon) for ribbon in _ribbons(comparison, shared, bars_a, bars_b, order_a, order_b, scale)
        ],
    }


def _beside(comparison: Comparison, shared: np.ndarray, order_a: list[int]) -> list[int]:
    """The other's motifs: kept ones where their partners stand, others at the middle of what they share, new ones
    last."""
    place = np.empty(len(order_a))
    place[np.array(order_a, int)] = np.arange(len(order_a))
    weights = shared.sum(0)
    middle = np.where(weights > 0, (place @ shared) / np.maximum(weights, 1e-12), np.inf)
    at_a, at_b = ({fate.motif: k for k, fate in enumerate(fates)} for fates in (comparison.a, comparison.b))
    for link in comparison.links:
        if link.kept:
            middle[at_b[link.b]] = place[at_a[link.a]]
    return sorted(range(len(comparison.b)), key=lambda j: (comparison.b[j].change == "gained", middle[j], j))


def _bars(
    side: str, fates: Sequence[Fate], order: list[int], heights: np.ndarray, gap: float, names: Mapping[int, str]
) -> list[dict[str, Any]]:
    """Bars from the top in their order: places among the fates counted from 1, 0 for "in no motif"."""
    bars, y = [], 0.0
    for k in order:
        fate = fates[k - 1] if k else None
        bars.append(
            {
                "side": side,
                "motif": fate.motif if fate else None,
                "label": str(fate.motif) if fate else "none",
                "y": y,
                "h": float(heights[k]),
                "change": fate.change if fate else "",
                "title": f"Motif {fate.motif} {names.get(fate.motif, '')}".strip() if fate else "In no motif",
            }
        )
        y += float(heights[k]) + gap
    return bars


def _ribbons(comparison, shared, bars_a, bars_b, order_a, order_b, scale) -> list[dict[str, Any]]:
    """Bands of motion that two bars share; those too thin to see, or to matter to either, are left out."""
    kinds = {(link.a, link.b): "kept" if link.kept else "linked" for link in comparison.links}
    table = shared[np.ix_(order_a, order_b)]
    sizes = table.sum(1), table.sum(0)
    from_a = np.cumsum(table, axis=1) - table
    from_b = np.cumsum(table, axis=0) - table
    shown = (table > _LEAST_SHARE * np.minimum(sizes[0][:, None], sizes[1])) & (table * scale > _THINNEST)
    ribbons = []
    for i, j in np.argwhere(shown):
        one, two = bars_a[i]["motif"], bars_b[j]["motif"]
        ribbons.append(
            {
                "a": one,
                "b": two,
                "ya": bars_a[i]["y"] + from_a[i, j] * scale,
                "yb": bars_b[j]["y"] + from_b[i, j] * scale,
                "h": table[i, j] * scale,
                "kind": kinds.get((one, two), "rest"),
                "title": f"{_called(one)} here, {_called(two)} in the other: {table[i, j]:.1f} s",
            }
        )
    return ribbons


def _rounded(entry: Mapping[str, Any]) -> dict[str, Any]:
    return {name: round(float(value), 1) if isinstance(value, float) else value for name, value in entry.items()}


def _called(motif: int | None) -> str:
    return "in no motif" if motif is None else f"motif {motif}"


def pair_request(
    dataset: Dataset,
    a: MotifGraph,
    b: MotifGraph,
    comparison: Comparison,
    selection: Mapping[str, Any],
    gained: str = "",
) -> dict[str, Any] | None:
    """What the Stage plays: the selected motif of ``a`` beside its partners in ``b``, or a new motif of ``b`` alone.

    None where ``selection`` names no motif of ``a`` and ``gained`` none of ``b``.
    """
    fate = next((f for f in comparison.a if str(f.motif) == str(selection.get("motif"))), None)
    here = [motif for motif in a.motifs if fate and motif.id == fate.motif]
    wanted = fate.partners if fate else tuple(f.motif for f in comparison.b if str(f.motif) == gained and not selection)
    there = [motif for number in wanted for motif in b.motifs if motif.id == number]
    if not here and not there:
        return None
    each = MOST_EACH if len(there) < 3 else 1
    items = [_item(s, f"here {m.id}", HERE) for m in here for s in _typical(m, each)]
    items += [_item(s, f"other {m.id}", THERE) for m in there for s in _typical(m, each)]
    others = f"motif{'s' if len(there) > 1 else ''} {', '.join(str(m.id) for m in there)} of the other result"
    title = f"Motif {here[0].id} and {others}" if here and there else f"Motif {(here + there)[0].id}, only "
    title += "" if here and there else "here" if here else "in the other result"
    return {
        "dataset": dataset.name,
        "version": dataset.fingerprint,
        "items": items,
        "layout": "side",
        "sync": "start",
        "title": title,
    }


def _typical(motif: Motif, most: int) -> list[Any]:
    others = [segment for k, segment in enumerate(motif.segments) if k != motif.medoid]
    return [motif.segments[motif.medoid], *others][:most]


def _item(segment: Any, label: str, colour: str) -> dict[str, Any]:
    clip, start, end = segment
    return {"clip": clip, "start": int(start), "end": int(end), "label": label, "colour": colour}
