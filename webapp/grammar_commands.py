"""``motionscape grammar`` and ``motionscape derive``: rules of what follows what, and new motion that obeys them."""

from __future__ import annotations

import json
from argparse import Namespace
from collections.abc import Iterator
from pathlib import Path

from core.grammar.learned import LearnedGrammar, from_json
from core.mocap.bvh import write_bvh
from core.mocap.dataset import Dataset
from core.synthesis.derivations import MOST_TERMINALS, Derivation, derive
from core.synthesis.kept_derivations import derivation_json
from core.workspace import WorkspaceError
from webapp.commands import write_json
from webapp.one_result import result_of
from webapp.progress_bar import progress_bar
from webapp.sources import open_source

SHOWN_RULES = 12


def grammar(asked: Namespace) -> int:
    """Learns the grammar and writes grammar.json; prints the time of each stage, the bits and the commonest rules.

    Raises ParameterError, WorkspaceError, RecordingError, ValueError or OSError in plain words.
    """
    found = result_of(asked, "grammar")
    write_json(asked.out, found.to_json())
    if not asked.quiet:
        print("\n".join(_grammar_summary(found, asked)))
    return 0


def derive_(asked: Namespace) -> int:
    """Writes a new sentence of a grammar as motion. Raises WorkspaceError, ValueError or OSError in plain words."""
    if asked.out.suffix.lower() != ".bvh":
        raise WorkspaceError(f"{asked.out}: --out names a BVH file, such as sentence.bvh.")
    if not 1 <= asked.max_terminals <= MOST_TERMINALS:
        raise WorkspaceError(f"--max-terminals: 1 to {MOST_TERMINALS}, not {asked.max_terminals}.")
    learned = read_grammar(asked.grammar)
    sentence = asked.sentence or f"random:{asked.seed}:{asked.max_terminals}"
    with progress_bar(asked.quiet) as report:
        dataset = open_source(asked, report)
        check_clips(dataset, learned, asked)
        made = derive(
            dataset,
            learned,
            sentence,
            keep_feet=not asked.plain,
            seed=asked.seed,
            name=asked.out.stem,
            report=report,
        )
    write_bvh(asked.out, made.clip)
    if asked.parts:
        write_json(asked.parts, derivation_json(made))
    if not asked.quiet:
        print("\n".join(_derivation_summary(made, learned, asked)))
    return 0


def read_grammar(path: Path) -> LearnedGrammar:
    """The grammar in a file of ``motionscape grammar``. Raises WorkspaceError for another file, OSError."""
    try:
        return from_json(json.loads(path.read_text(encoding="utf-8")))
    except (ValueError, RecursionError) as error:
        raise WorkspaceError(f"{path}: not a file that “motionscape grammar” wrote ({error})") from error


def check_clips(dataset: Dataset, learned: LearnedGrammar, asked: Namespace) -> None:
    """Raises WorkspaceError where the grammar was not learned from these recordings."""
    have = {clip.name: clip.n_frames for clip in dataset.clips}
    for name, frames, _ in learned.terminals.clips:
        if name not in have:
            raise WorkspaceError(f"{asked.grammar} names the clip “{name}”, which {asked.source} does not have.")
        if have[name] != frames:
            raise WorkspaceError(
                f"{asked.grammar} was made from other recordings: “{name}” has {have[name]} frames here, "
                f"{frames} there."
            )


def _grammar_summary(found: LearnedGrammar, asked: Namespace) -> Iterator[str]:
    for stage, taken in found.seconds.items():
        yield f"  {stage:<14}{taken:8.2f} s"
    rules, bits = found.grammar.rules, found.bits
    pieces = sum(len(sentence.pieces) for sentence in found.sentences)
    yield f"{found.terminals.n_terminals} terminals, {pieces} segments, {len(found.sentences)} sentences"
    yield f"{len(rules)} rules, {len(found.grammar.nonterminals)} non-terminals"
    yield f"bits: grammar {bits.grammar:.0f}, sentences {bits.sentences:.0f}, total {bits.total:.0f}"
    for name, figures in found.baselines.items():
        yield f"  {name.replace('_', ' ')}: {figures['rules']:.0f} rules, {figures['bits_total']:.0f} bits"
    yield ", ".join(f"{name} {value:.3g}" for name, value in found.terminals.objective.items())
    for rule in sorted(rules, key=lambda rule: -rule.count)[:SHOWN_RULES]:
        yield f"  {rule.count:5d} x {rule.left} -> {' '.join(map(str, rule.right)) or '(nothing)'}"
    yield f"written to {asked.out}"


def _derivation_summary(made: Derivation, learned: LearnedGrammar, asked: Namespace) -> Iterator[str]:
    yield from (f"note: {warning}" for warning in made.warnings)
    shown = " ".join(map(str, made.terminals[:60])) + (" ..." if len(made.terminals) > 60 else "")
    yield f"{len(made.terminals)} terminals: {shown}"
    if made.tree is not None:
        yield f"sentence: {'.'.join(map(str, learned.grammar.rule_indices(made.tree)))}"
    yield f"{made.clip.seconds:.1f} s, {made.clip.n_frames} frames, {len(made.seams)} blends"
    skate, speeds = made.skate, made.speeds
    yield (
        f"foot skate, m per second of contact: {skate.kept:.3f} (blending alone {skate.plain:.3f}, "
        f"recordings {skate.source:.3f})"
    )
    yield f"fastest joint, m/s: {speeds.seams:.2f} in the blends, {speeds.sources:.2f} in the recordings"
    yield f"written to {asked.out}" + (f" and {asked.parts}" if asked.parts else "")
