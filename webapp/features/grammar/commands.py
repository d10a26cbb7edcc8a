"""``motionscape grammar`` and ``motionscape derive``: rules of what follows what, and new motion that obeys them."""

from __future__ import annotations

from argparse import Namespace
from collections.abc import Iterator

from core.grammar.learned import LearnedGrammar, from_json
from core.mocap.bvh import write_bvh
from core.synthesis.derivations import MOST_TERMINALS, Derivation, derive
from core.synthesis.kept_derivations import derivation_json
from core.workspace import WorkspaceError
from webapp.cli.one_result import result_of
from webapp.cli.progress_bar import progress_bar
from webapp.cli.result_files import check_clips, check_made, made_lines, read_result, write_json
from webapp.cli.sources import open_source

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
    check_made(asked.out, asked.parts)
    if not 1 <= asked.max_terminals <= MOST_TERMINALS:
        raise WorkspaceError(f"--max-terminals: 1 to {MOST_TERMINALS}, not {asked.max_terminals}.")
    learned = read_result(asked.grammar, "grammar", from_json)
    clips = learned.terminals.clips
    sentence = asked.sentence or f"random:{asked.seed}:{asked.max_terminals}"
    with progress_bar(asked.quiet) as report:
        dataset = open_source(asked, report)
        check_clips(asked.grammar, clips, [name for name, _, _ in clips], dataset, asked.source)
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
    yield from made_lines(made, asked.out, asked.parts)
