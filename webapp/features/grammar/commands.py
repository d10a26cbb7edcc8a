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


def grammar(arguments: Namespace) -> int:
    """Learns the grammar and writes grammar.json; prints the time of each stage, the bits and the commonest rules.

    Raises ParameterError, WorkspaceError, RecordingError, ValueError or OSError in plain words.
    """
    learned = result_of(arguments, "grammar")
    write_json(arguments.out, learned.to_json())
    if not arguments.quiet:
        print("\n".join(_grammar_summary(learned, arguments)))
    return 0


def derive_(arguments: Namespace) -> int:
    """Writes a new sentence of a grammar as motion. Raises WorkspaceError, ValueError or OSError in plain words."""
    check_made(arguments.out, arguments.parts)
    if not 1 <= arguments.max_terminals <= MOST_TERMINALS:
        raise WorkspaceError(f"--max-terminals: 1 to {MOST_TERMINALS}, not {arguments.max_terminals}.")
    learned = read_result(arguments.grammar, "grammar", from_json)
    clips = learned.terminals.clips
    sentence = arguments.sentence or f"random:{arguments.seed}:{arguments.max_terminals}"
    with progress_bar(arguments.quiet) as report:
        dataset = open_source(arguments, report)
        check_clips(arguments.grammar, clips, [name for name, _, _ in clips], dataset, arguments.source)
        dataset = dataset.select(name for name, _, _ in clips)
        derivation = derive(
            dataset,
            learned,
            sentence,
            keep_feet=not arguments.plain,
            seed=arguments.seed,
            name=arguments.out.stem,
            report=report,
        )
    write_bvh(arguments.out, derivation.clip)
    if arguments.parts:
        write_json(arguments.parts, derivation_json(derivation))
    if not arguments.quiet:
        print("\n".join(_derivation_summary(derivation, learned, arguments)))
    return 0


def _grammar_summary(learned: LearnedGrammar, arguments: Namespace) -> Iterator[str]:
    for stage, duration in learned.seconds.items():
        yield f"  {stage:<14}{duration:8.2f} s"
    rules, bits = learned.grammar.rules, learned.bits
    pieces = sum(len(sentence.pieces) for sentence in learned.sentences)
    yield f"{learned.terminals.n_terminals} terminals, {pieces} segments, {len(learned.sentences)} sentences"
    yield f"{len(rules)} rules, {len(learned.grammar.nonterminals)} non-terminals"
    yield f"bits: grammar {bits.grammar:.0f}, sentences {bits.sentences:.0f}, total {bits.total:.0f}"
    for name, figures in learned.baselines.items():
        yield f"  {name.replace('_', ' ')}: {figures['rules']:.0f} rules, {figures['bits_total']:.0f} bits"
    yield ", ".join(f"{name} {value:.3g}" for name, value in learned.terminals.objective.items())
    for rule in sorted(rules, key=lambda rule: -rule.count)[:SHOWN_RULES]:
        yield f"  {rule.count:5d} x {rule.left} -> {' '.join(map(str, rule.right)) or '(nothing)'}"
    yield f"written to {arguments.out}"


def _derivation_summary(derivation: Derivation, learned: LearnedGrammar, arguments: Namespace) -> Iterator[str]:
    yield from (f"note: {warning}" for warning in derivation.warnings)
    shown = " ".join(map(str, derivation.terminals[:60])) + (" ..." if len(derivation.terminals) > 60 else "")
    yield f"{len(derivation.terminals)} terminals: {shown}"
    if derivation.tree is not None:
        yield f"sentence: {'.'.join(map(str, learned.grammar.rule_indices(derivation.tree)))}"
    yield from made_lines(derivation, arguments.out, arguments.parts)
