"""Comparisons of groups made of motifs, actions or labels: the results of the methods as what core.groups compares."""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Any, Literal

import numpy as np

from core.arrays import FloatArray
from core.editing.gait import find_gait
from core.errors import ParameterError
from core.grammar.learned import LearnedGrammar
from core.grammar.trees import leaves, preorder
from core.groups.comparison import Motions, compare_groups
from core.groups.design import Design, Unit
from core.groups.documents import to_json
from core.groups.maps import Stay, map_differences
from core.groups.parameters import GroupParameters
from core.groups.tables import Item
from core.mocap.clip import Segment
from core.mocap.dataset import Dataset
from core.motifs.graph import MotifGraph
from core.motion_map.motion_map import MotionMap
from core.progress import Report, silent

GAIT = "gait cycle"
FEWEST_USES = 4  # of a rule of the grammar that is compared


@dataclass(frozen=True)
class CompareParameters(GroupParameters):
    """A comparison as a request.

    of: what is counted; settings: of the motif graph or the grammar that is counted, as JSON, the usual ones where
    empty. on_map: on the motion map too. design: groups and units as JSON, see :func:`design_json`.
    """

    of: Literal["motifs", "grammar", "labels"] = field(
        default="motifs", metadata={"help": "What is counted: motifs, actions of the grammar, or labels."}
    )
    design: str = field(default="", metadata={"help": "Groups and units, as JSON."})
    settings: str = field(default="", metadata={"help": "Settings of the motifs or the grammar, as JSON."})
    on_map: bool = field(default=False, metadata={"help": "Compare where on the motion map the groups are, too."})

    def need(self) -> tuple[tuple[str, dict[str, Any]], ...]:
        """The results that are compared: methods and their parameters."""
        counted = () if self.of == "labels" else ((self.of, json.loads(self.settings) if self.settings else {}),)
        return (*counted, *((("map", {}),) if self.on_map else ()))


def design_json(design: Design) -> str:
    """A design as JSON text, for a request."""
    units = [[unit.name, unit.group, list(unit.clips)] for unit in design.units]
    parts = [design.column, list(design.groups), units, design.subject, design.paired, list(design.remarks)]
    return json.dumps(parts, ensure_ascii=False, separators=(",", ":"))


def design_of(text: str) -> Design:
    """The design back from :func:`design_json`. Raises ParameterError for anything else."""
    try:
        column, groups, units, subject, paired, remarks = json.loads(text)
        made = tuple(Unit(str(name), str(group), tuple(map(str, clips))) for name, group, clips in units)
        return Design(str(column), tuple(map(str, groups)), made, str(subject), bool(paired), tuple(map(str, remarks)))
    except (ValueError, TypeError) as error:
        raise ParameterError(f"design: cannot be read ({error})") from error


def compare_dataset(
    dataset: Dataset,
    values: CompareParameters,
    report: Report = silent,
    *given: MotifGraph | LearnedGrammar | MotionMap,
) -> dict[str, Any]:
    """The document groups.json for a request. Raises ParameterError, Cancelled."""
    plain = GroupParameters(values.permutations, values.resamples, values.alpha, values.seed)
    counted = next((one for one in given if not isinstance(one, MotionMap)), None)
    motion_map = next((one for one in given if isinstance(one, MotionMap)), None)
    return compared(dataset, design_of(values.design), counted, plain, report, motion_map)


def compared(
    dataset: Dataset,
    design: Design,
    counted: MotifGraph | LearnedGrammar | None,
    parameters: GroupParameters,
    report: Report = silent,
    motion_map: MotionMap | None = None,
) -> dict[str, Any]:
    """The document groups.json of a design: of motifs, of actions, or (None) of the labels of the dataset.

    motion_map: where postures are compared as well.
    """
    motions: dict[str, Motions] = {}
    if isinstance(counted, MotifGraph):
        items = motif_items(counted)
        motions = {str(motif.id): list(zip(motif.segments, motif.warps, strict=True)) for motif in counted.motifs}
    elif isinstance(counted, LearnedGrammar):
        items = (*action_items(counted), *routine_items(counted))
    else:
        items = label_items(dataset)
    used = {clip for unit in design.units for clip in unit.clips}
    motions[GAIT] = strides(dataset, used, report)
    found = compare_groups(dataset, design, items, motions, parameters, report)
    on_map = map_differences(design, stays_on(motion_map), motion_map.grid, parameters) if motion_map else []
    return to_json(found, dataset) | {"map": on_map}


def stays_on(motion_map: MotionMap) -> Iterator[Stay]:
    """The stays of clips on the nodes of a map."""
    runs = motion_map.runs
    for clip, node, frames in zip(
        runs.clip.tolist(), runs.node.tolist(), (runs.end - runs.start).tolist(), strict=True
    ):
        yield motion_map.clips[clip], node, float(frames)


def motif_items(graph: MotifGraph, names: Mapping[int, str] | None = None) -> tuple[Item, ...]:
    """Motifs as items. names: motif id -> what people call it."""
    names = names or {}
    return tuple(
        Item("motif", str(motif.id), names.get(motif.id) or f"motif {motif.id}", motif.segments)
        for motif in graph.motifs
    )


def action_items(learned: LearnedGrammar) -> tuple[Item, ...]:
    """Actions of a grammar as items; neighbours of one action count as one."""
    terminals = learned.terminals
    runs: dict[int, list[Segment]] = {}
    for clip in terminals.occurrences:
        for terminal, segment in terminals.runs(clip):
            runs.setdefault(terminal, []).append(segment)
    return tuple(Item("action", str(k), f"action {k}", tuple(runs[k])) for k in sorted(runs))


def routine_items(learned: LearnedGrammar) -> tuple[Item, ...]:
    """Routines as items: rules of a grammar that stand for several actions in a row, where they occur in the sentences.

    Rules of whole sentences, and those used fewer than FEWEST_USES times, say nothing of groups and are left out.
    """
    found: dict[int, list[Segment]] = {}
    words: dict[int, tuple[int, ...]] = {}
    for sentence, tree in zip(learned.sentences, learned.trees, strict=True):
        for node in preorder(tree):
            if node.is_leaf or node.end - node.start < 2 or node is tree:
                continue
            first, last = sentence.pieces[node.start][1], sentence.pieces[node.end - 1][1]
            found.setdefault(node.rule, []).append(Segment(sentence.clip, first.start, last.end))
            words.setdefault(node.rule, leaves(node))
    often = sorted(rule for rule, segments in found.items() if len(segments) >= FEWEST_USES)
    return tuple(Item("routine", f"rule {k}", _routine(words[k]), tuple(sorted(found[k]))) for k in often)


def _routine(actions: Sequence[int]) -> str:
    """What a routine is called: the actions of its first occurrence."""
    return "routine " + "-".join(map(str, actions[:8])) + (" ..." if len(actions) > 8 else "")


def label_items(dataset: Dataset) -> tuple[Item, ...]:
    """Labelled actions as items."""
    found: dict[str, list[Segment]] = {}
    for label in dataset.labels:
        found.setdefault(label.action, []).append(Segment(label.clip, label.start, label.end))
    return tuple(Item("label", action, action, tuple(sorted(found[action]))) for action in sorted(found))


def strides(dataset: Dataset, clips: Iterable[str], report: Report = silent) -> Motions:
    """Strides of walking, from a strike of the left heel to the next, evenly in time, for curves of the gait."""
    found: list[tuple[Segment, FloatArray]] = []
    names = sorted(clips)
    for k, name in enumerate(names):
        report("finding strides", k / len(names))
        gait = find_gait(dataset.clip(name))
        for number, bout in enumerate(gait.bouts):
            if bout.kind != "walk":
                continue
            own = (e.frame for e in gait.events if (e.bout, e.side, e.kind) == (number, "left", "strike"))
            frames = sorted(own)
            for start, end in pairwise(frames):
                if end - start > 2:
                    found.append((Segment(name, start, end), np.arange(end - start, dtype=np.float32)))
    return found
