"""New routines in the app: their links, trees and motion, and alternatives for their parts.

A link says ``sentence=random:SEED:MOST`` (by chance, at most so many actions) or the routine's rule indices,
``sentence=0.3.1`` (SYN 5.1); ``pick`` is the number of the chosen action and ``up`` how many phrases further out the
chosen part reaches. ``~derive~KEY`` holds the motion, a clip called ``routine``; KEY is that of its result.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from core import analyses
from core.errors import MotionscapeError, ParameterError
from core.grammar import authoring
from core.grammar.trees import Node, at_path, preorder
from core.mocap.clip import Label
from core.mocap.dataset import Dataset
from core.synthesis import Derivation
from core.synthesis.derivations import read_sentence
from core.workspace import Workspace, WorkspaceError
from webapp.features.grammar import grammars
from webapp.features.grammar.figures import actions
from webapp.shell import recipes, settings
from webapp.shell.errors import sentence
from webapp.shell.names import Colour
from webapp.shell.virtual import virtual_name

if TYPE_CHECKING:
    from core.grammar.learned import LearnedGrammar

DERIVE = "derive"
USUAL_LENGTH, MOST_LENGTH = 40, 200
N_OTHERS = 4
CONTEXT = 0.7  # seconds played before and after a part that is shown in another way
LONGEST = 300  # letters that a link can hold
KEYS = ("sentence", "pick", "up")  # of the link that say which routine it is, and its chosen part
View = Mapping[str, str] | None


def is_composing(view: View) -> bool:
    """Whether the Grammar page makes routines: then a new routine plays, and not what is selected."""
    return (view or {}).get("show") == "compose"


def link_keys_of(view: View, *more: str) -> dict[str, str]:
    """The keys of a link that name a routine and its chosen part."""
    return {key: text for key in (*KEYS, *more) if (text := (view or {}).get(key))}


def find_derivation(workspace: Workspace, key: str) -> Derivation | None:
    """A routine that has been made, or None."""
    return analyses.kept(workspace, DERIVE, key) if re.fullmatch(r"[0-9a-f]{8,64}", key) else None


def open_derivation(workspace: Workspace, key: str) -> Dataset:
    """The made-up data set of a kept routine. Raises WorkspaceError where there is none."""
    derivation = find_derivation(workspace, key)
    if derivation is None:
        raise WorkspaceError("This routine is no longer there; make it again on the Grammar page.")
    return Dataset(virtual_name(DERIVE, key), (derivation.clip,))


def tree_of(learned: LearnedGrammar, sentence: str) -> Node:
    """The tree that a link's ``sentence`` stands for. Raises ParameterError."""
    try:
        return read_sentence(learned.grammar, sentence)
    except ParameterError as error:
        if sentence.startswith("random"):
            raise
        raise ParameterError("The routine of the link does not obey these rules: it was made with others") from error


def code_of(learned: LearnedGrammar, tree: Node) -> str:
    """A tree as a link writes it."""
    return ".".join(map(str, learned.grammar.rule_indices(tree)))


def composed(workspace: Workspace, name: str, view: View) -> dict[str, Any] | None:
    """All that assets/grammar/compose.mjs shows of a routine, or why there is none; None while there is no grammar."""
    data: dict[str, Any] = {"inputs": link_keys_of(view)}
    try:
        learned, key = grammars.learned(workspace, name, view), settings.key_of(workspace, grammars.PAGE, name, view)
        if learned is None or key is None:
            return None
        data["key"] = key
        return data | _composed(workspace, learned, name, view)
    except MotionscapeError as error:
        return data | {"error": sentence(error)}


def _composed(workspace: Workspace, learned: LearnedGrammar, name: str, view: View) -> dict[str, Any]:
    tree = tree_of(learned, (view or {})["sentence"])
    request = derive_request(learned, name, view, tree)
    derivation = analyses.result_now(workspace, request)
    notes = grammars.notes_of(workspace, name, view) or {}
    chosen = chosen_part(learned, tree, view)
    marks = {"marked": chosen and chosen["at"], "picked": _number(view, "pick")}
    return shown_routine(learned, derivation, analyses.key(workspace, request), notes) | {
        "recipes": recipes.texts(workspace.path, request),
        "code": code_of(learned, tree),
        "svg": grammars.routine_svg(workspace.open(name), learned, tree, derivation.pieces, notes, **marks),
        "chosen": chosen,
        "parents": _parents(tree),
    }


def derive_request(learned: LearnedGrammar, dataset: str, view: View, tree: Node) -> analyses.Request:
    """The request for the motion of a routine. Raises ParameterError where it is too long for a link."""
    code = code_of(learned, tree)
    if len(code) > LONGEST:
        raise ParameterError("This routine is too long for a link; choose fewer actions")
    return analyses.Request(
        dataset, DERIVE, {**settings.request_of(grammars.PAGE, dataset, view).parameters, "sentence": code}
    )


def shown_routine(learned: LearnedGrammar, derivation: Derivation, key: str, notes: actions.Notes) -> dict[str, Any]:
    """The motion: its actions and their times, its quality, and the name of its data set."""
    return {
        "name": virtual_name(DERIVE, key),
        "clip": derivation.clip.name,
        "actions": list(derivation.terminals),
        "spans": [list(span) for span in derivation.spans],
        "frames": derivation.clip.n_frames,
        "seconds": round(derivation.clip.seconds, 2),
        "skate": [round(value, 4) for value in derivation.skate],
        "speeds": [round(value, 2) for value in derivation.speeds],
        "jump": derivation.speeds.jump,
        "warnings": list(derivation.warnings),
        "bands": bands(derivation, notes),
        "novel": tuple(derivation.terminals) not in {sentence.terminals for sentence in learned.sentences},
    }


def bands(derivation: Derivation, notes: actions.Notes) -> list[Colour]:
    """Coloured spans for the Stage, one for each action."""
    return [
        {
            "start": start,
            "end": end,
            "colour": actions.action_colour(action),
            "label": actions.short_name(action, notes),
        }
        for action, (start, end) in zip(derivation.terminals, derivation.spans, strict=True)
        if end > start
    ]


def chosen_part(learned: LearnedGrammar, tree: Node, view: View) -> dict[str, Any] | None:
    """The part that the link chooses (see ``names.Part``); None where there is none."""
    picked = _number(view, "pick")
    if picked is None or not 0 <= picked < tree.end:
        return None
    around = authoring.constituents(tree, picked)  # paths, smallest first
    level = min(_number(view, "up") or 0, len(around) - 1)
    path = around[level]
    node = at_path(tree, path)
    return {
        "at": path,
        "path": ".".join(map(str, path)),
        "first": node.start,
        "end": node.end,
        "name": grammars.tree_names(learned, {})(node.symbol),
        "ways": len(learned.grammar.choices[node.name]),
        "varies": any(len(learned.grammar.choices[n.name]) > 1 for n in preorder(node) if not n.is_leaf),
        "larger": level + 1 < len(around),
        "smaller": level > 0,
    }


def alternatives(workspace: Workspace, name: str, view: View) -> dict[str, Any] | None:
    """Four alternatives for the chosen part, each with its motion, or why there are none; None without a grammar."""
    data: dict[str, Any] = {"inputs": link_keys_of(view, "alt")}
    try:
        learned, notes = grammars.learned(workspace, name, view), grammars.notes_of(workspace, name, view) or {}
        if learned is None:
            return None
        tree = tree_of(learned, (view or {})["sentence"])
        chosen = chosen_part(learned, tree, view)
        if chosen is None:
            return data | {"error": "Choose an action first."}
        seed = _number(view, "alt") or 1
        others = authoring.alternatives(learned.grammar, tree, chosen["at"], N_OTHERS, seed)
        shown = [_alternative(workspace, learned, name, view, other, chosen["at"], notes) for other in others]
    except MotionscapeError as error:
        return data | {"error": sentence(error)}
    return data | {"part": chosen["name"], "others": shown}


def _alternative(
    workspace: Workspace,
    learned: LearnedGrammar,
    name: str,
    view: View,
    tree: Node,
    path: tuple[int, ...],
    notes: actions.Notes,
) -> dict[str, Any]:
    request = derive_request(learned, name, view, tree)
    derivation = analyses.result_now(workspace, request)
    node = at_path(tree, path)
    frames, fps = derivation.clip.n_frames, derivation.clip.fps
    start = derivation.spans[node.start][0] if node.start < len(derivation.spans) else frames
    stop = derivation.spans[node.end - 1][1] if node.end > node.start else start
    margin = round(CONTEXT * fps)
    return {
        "code": code_of(learned, tree),
        "name": virtual_name(DERIVE, analyses.key(workspace, request)),
        "clip": derivation.clip.name,
        "actions": list(derivation.terminals),
        "first": node.start,
        "end": node.end,
        "start": max(0, start - margin),
        "stop": min(frames, stop + margin),
        "seconds": round((stop - start) / fps, 2),
        "bands": bands(derivation, notes),
    }


def keep(workspace: Workspace, name: str | None, view: View, routine_name: str) -> str:
    """Keeps the routine of the link as a clip of the data set ``NAME routines``; returns the message for the person.

    Raises WorkspaceError (no name, a name that is taken).
    """
    routine_name = " ".join(routine_name.split())
    if not routine_name:
        raise WorkspaceError("Give it a name first.")
    learned = grammars.learned(workspace, name, view)
    if learned is None or name is None or not view or not view.get("sentence"):
        raise WorkspaceError("There is no routine to keep.")
    try:
        derivation = analyses.result_now(
            workspace, derive_request(learned, name, view, tree_of(learned, view["sentence"]))
        )
    except MotionscapeError as error:
        raise WorkspaceError(sentence(error)) from error
    notes = grammars.notes_of(workspace, name, view) or {}
    labels = tuple(
        Label(routine_name, start, end, actions.action_name(action, notes))
        for action, (start, end) in zip(derivation.terminals, derivation.spans, strict=True)
        if end > start
    )
    home = f"{name} routines"
    more = Dataset(home, (replace(derivation.clip, name=routine_name),), labels)
    if home in {info.name for info in workspace.datasets()}:
        workspace.add_clips(home, more)
    else:
        workspace.add_dataset(home, more)
    return f"Kept as “{routine_name}” in the data set “{home}”."


def _parents(tree: Node) -> list[str]:
    """For every action the path of the smallest phrase around it, as text."""
    return [".".join(map(str, authoring.constituents(tree, at)[0])) for at in range(tree.end)]


def _number(view: View, key: str) -> int | None:
    text = (view or {}).get(key, "")
    return int(text) if text.isdecimal() and len(text) < 7 else None
