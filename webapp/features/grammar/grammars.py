"""Grammars in the app: their results, and the names that people give to their actions."""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Iterable, Mapping
from typing import TYPE_CHECKING, Any, NamedTuple

from core.mocap.clip import Segment
from core.mocap.dataset import Dataset
from core.workspace import MotifNote, Workspace, WorkspaceError
from webapp.features.grammar.figures import actions, rules
from webapp.features.grammar.figures.parse_tree import tree_svg
from webapp.shell import settings

if TYPE_CHECKING:
    from core.grammar.learned import LearnedGrammar
    from core.grammar.trees import Node, Symbol

PAGE = "grammar"
View = Mapping[str, str] | None


def learned(workspace: Workspace, dataset: str | None, view: View) -> LearnedGrammar | None:
    """The grammar that a view shows where it has been computed."""
    return settings.result_of(workspace, PAGE, dataset, view)


def notes_of(workspace: Workspace, dataset: str, view: View) -> dict[int, MotifNote] | None:
    """People's notes on the actions of this result, by number; None where there is no result."""
    result, key = learned(workspace, dataset, view), settings.key_of(workspace, PAGE, dataset, view)
    if result is None or key is None:
        return None
    segments = dict(enumerate(result.terminals.segments))
    return workspace.notes.of(workspace.info(dataset).id, key, segments)


def name_action(workspace: Workspace, dataset: str, view: View, action: int, name: str) -> bool:
    """Saves the name of an action; False where nothing changes. Raises WorkspaceError if it is too long."""
    notes, key = notes_of(workspace, dataset, view), settings.key_of(workspace, PAGE, dataset, view)
    result = learned(workspace, dataset, view)
    if notes is None or key is None or result is None or not 0 <= action < result.terminals.n_terminals:
        return False
    before = notes.get(action, MotifNote())
    if name.strip() == before.name:
        return False
    dataset_id, segments = workspace.info(dataset).id, result.terminals.segments[action]
    workspace.notes.put(dataset_id, key, action, segments, name=name, tags=before.tags, note=before.note)
    return True


def names_mark(workspace: Workspace, dataset: str, view: View) -> str:
    """A mark that changes with the names of the actions and the labels of the recordings."""
    names = {action: note.name for action, note in (notes_of(workspace, dataset, view) or {}).items()}
    known = (sorted(names.items()), workspace.open(dataset).labels)
    return hashlib.blake2b(repr(known).encode(), digest_size=6).hexdigest()


def page_data(dataset: Dataset, result: LearnedGrammar, key: str, notes: Mapping[int, MotifNote]) -> dict[str, Any]:
    """All that assets/grammar/*.mjs draw of a result, except trees and new routines."""
    segments = result.terminals.segments
    cuts: dict[str, list[int]] = {}
    for routine in routines(result):
        cuts.setdefault(routine.span.clip, []).append(routine.span.start)
    return {
        "key": key,
        "dataset": dataset.name,
        "version": dataset.fingerprint[:8],
        "actions": actions.actions_data(dataset, segments, result.terminals.medoids, notes),
        "rows": actions.string_rows(dataset, segments, cuts),
        "rules": rules.rules_data(result.grammar.rules, result.grammar.start),
        "routines": [routine_data(dataset, routine) for routine in routines(result)],
    }


class Routine(NamedTuple):
    """A sentence of the recordings: where it lies, the segments of its actions in order, and its tree."""

    span: Segment
    pieces: tuple[tuple[int, Segment], ...]
    tree: Node


def routines(result: LearnedGrammar) -> list[Routine]:
    """The sentences of the recordings, with their trees."""
    return [
        Routine(Segment(sentence.clip, sentence.pieces[0][1].start, sentence.pieces[-1][1].end), sentence.pieces, tree)
        for sentence, tree in zip(result.sentences, result.trees, strict=True)
    ]


def routine_data(dataset: Dataset, routine: Routine) -> dict[str, Any]:
    """A routine as the page lists it; see ``names.Routine``."""
    fps = dataset.clip(routine.span.clip).fps
    return {
        "clip": routine.span.clip,
        "seconds": [round(routine.span.start / fps, 3), round(routine.span.end / fps, 3)],
        "actions": [action for action, _ in routine.pieces],
        "leaves": [[segment.start, segment.end] for _, segment in routine.pieces],
    }


def routine_number(result: LearnedGrammar, view: View) -> int:
    """The number of the routine that a view shows: the first where it names none that exists."""
    text = (view or {}).get("routine", "")
    return int(text) if text.isdecimal() and int(text) < len(result.sentences) else 0


def tree_names(result: LearnedGrammar, notes: Mapping[int, MotifNote]) -> Callable[[Symbol], str]:
    """The function that gives the text in a box of a tree."""
    phrases = rules.phrase_names(result.grammar.rules, result.grammar.start)
    return lambda symbol: phrases[symbol] if isinstance(symbol, str) else actions.short_name(symbol, notes)


def routine_svg(
    dataset: Dataset,
    result: LearnedGrammar,
    tree: Node,
    segments: Iterable[Segment],
    notes: Mapping[int, MotifNote],
    **look: Any,
) -> str:
    """The tree of a routine with a posture below every action.

    segments: of its actions, in order; look: as for parse_tree.tree_svg.
    """
    pictures = [actions.icon_address(dataset, segment) for segment in segments]
    return tree_svg(
        tree,
        tree_names(result, notes),
        actions.tones(result.terminals.n_terminals),
        **({"pictures": pictures} | look),
    )


def dataset_of(workspace: Workspace, name: str | None) -> Dataset | None:
    """The data set, or None where there is none."""
    try:
        return workspace.open(name) if name else None
    except WorkspaceError:
        return None
