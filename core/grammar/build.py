"""From recordings to a grammar: terminals, sentences, rules (SYN sections 4 and 5)."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, fields
from functools import partial
from typing import Any

import numpy as np

from core.errors import ParameterError
from core.grammar.baselines import sequitur, state_machine
from core.grammar.identification import find_terminals
from core.grammar.induction import Induced, induce
from core.grammar.learned import LearnedGrammar, Sentence
from core.grammar.motion_grammar import Bits
from core.grammar.parameters import TerminalParameters
from core.grammar.sentences import best_cuts
from core.grammar.terminals import Terminals
from core.mocap.clip import Segment
from core.mocap.dataset import Dataset
from core.parameters import parameter
from core.progress import Progress, Report, part_of, silent, timed

ENOUGH_CLIPS = 8  # recordings that can be sentences by themselves: fewer have little to be compared


@dataclass(frozen=True)
class GrammarParameters(TerminalParameters):
    """How a grammar is learned, besides how its terminals are found. Metadata as there.

    Raises ParameterError, in plain words, for a value out of range.
    """

    sentences: str = parameter(
        "auto",
        "clips = every recording is one sentence; shortest = cut recordings where that makes the description shortest; "
        "auto = clips where there are eight or more.",
        choices=("auto", "clips", "shortest"), label="A routine is",
    )  # fmt: skip
    repeats: str = parameter(
        "keep",
        "keep = an action done again counts again; join = the same action several times in a row counts as one.",
        choices=("keep", "join"), label="The same action in a row",
    )  # fmt: skip
    min_sentence: int = parameter(
        3,
        "With shortest: actions that a sentence has at least.",
        1,
        1000,
        1,
        advanced=True,
        label="Shortest routine (actions)",
    )
    candidates: int = parameter(
        40,
        "With shortest: ways to cut that are tried.",
        0,
        10_000,
        10,
        advanced=True,
        label="Divisions tried",
    )
    align: str = parameter(
        "auto",
        "pairs = every two sentences side by side; contexts = whatever stands between equal actions; auto = what gives "
        "the shorter description.",
        choices=("auto", "pairs", "contexts"), advanced=True, label="Alignment of routines",
    )  # fmt: skip
    select: str = parameter(
        "saving",
        "Which of overlapping phrases is kept: saving = the one that saves most writing; branch = the most usual of "
        "its kind, as in the 2011 paper; leaf = the one whose actions recur most.",
        choices=("saving", "branch", "leaf"), advanced=True, label="Overlapping phrases",
    )  # fmt: skip
    touching: bool = parameter(
        False,
        "Let phrases meet: more new sentences, and neighbours among their actions that were never seen.",
        advanced=True,
        label="Phrases may touch",
    )
    merge: str = parameter(
        "side",
        "Make phrases one kind where that shortens the description: side = if they also stand beside the same action; "
        "rules = wherever; no = never.",
        choices=("side", "rules", "no"), advanced=True, label="Phrases of one kind",
    )  # fmt: skip

    def __post_init__(self) -> None:
        super().__post_init__()
        if not (1 <= self.min_sentence <= 1000 and 0 <= self.candidates <= 10_000):
            raise ParameterError("min_sentence must be 1 to 1000, candidates 0 to 10000")
        for entry in fields(GrammarParameters):
            choices = entry.metadata.get("choices")
            if choices and getattr(self, entry.name) not in choices:
                raise ParameterError(f"{entry.name} must be one of {', '.join(choices)}")

    @property
    def terminals(self) -> dict[str, Any]:
        """The parameters of the terminals alone."""
        return {entry.name: getattr(self, entry.name) for entry in fields(TerminalParameters)}

    @property
    def induction(self) -> dict[str, Any]:
        """The arguments of :func:`core.grammar.induction.induce`."""
        return {
            "align_by": self.align,
            "select_by": self.select,
            "touching": self.touching,
            "merge": self.merge,
        }


def learn_grammar(
    dataset: Dataset, parameters: GrammarParameters | None = None, report: Report = silent
) -> LearnedGrammar:
    """The grammar of a data set. Deterministic: the same clips and seed give the same grammar.

    Raises ValueError as :func:`core.grammar.identification.find_terminals`; ``report`` may raise to stop the work.
    """
    parameters = parameters or GrammarParameters()
    terminals = find_terminals(dataset, TerminalParameters(**parameters.terminals), report)
    return grammar_of_terminals(terminals, parameters, report)


def grammar_of_terminals(
    terminals: Terminals, parameters: GrammarParameters | None = None, report: Report = silent
) -> LearnedGrammar:
    """The grammar of the strings of terminals; the parameters of their search are not used.

    Raises ValueError where there are no segments; ``report`` may raise to stop the work.
    """
    parameters = parameters or GrammarParameters()
    seconds = dict(terminals.seconds)
    with timed("sentences", seconds):
        sentences = _sentences(terminals, parameters, report)
    with timed("rules", seconds):
        heard = partial(report, "rules")
        strings = [s.terminals for s in sentences]
        learned = induce(strings, **parameters.induction, report=lambda _, fraction: heard(0.95 * fraction))
        baselines = _baselines(strings, learned, part_of(heard, 0.95, 1.0))
    return LearnedGrammar(
        terminals=terminals,
        sentences=sentences,
        grammar=learned.grammar,
        trees=learned.trees,
        baselines=baselines,
        parameters=asdict(parameters),
        seconds=seconds,
    )


def _sentences(terminals: Terminals, parameters: GrammarParameters, report: Report) -> tuple[Sentence, ...]:
    rows = [(name, _runs(terminals, name, parameters.repeats)) for name, _, _ in terminals.clips]
    rows = [(name, pieces) for name, pieces in rows if pieces]
    strings = [tuple(terminal for terminal, _ in pieces) for _, pieces in rows]
    cuts: Sequence[tuple[int, ...]] = [()] * len(strings)
    few = len(strings) < ENOUGH_CLIPS and parameters.sentences == "auto"
    if few or parameters.sentences == "shortest":
        shown = 0.0

        def heard(stage: str, fraction: float) -> None:
            nonlocal shown
            shown = fraction
            report(stage, fraction)

        def stopped(_stage: str, _fraction: float) -> None:  # of one way to cut: only that it can be cancelled
            report("sentences", shown)

        cuts = best_cuts(
            strings,
            lambda parts: induce(parts, **parameters.induction, report=stopped).bits,
            candidates=parameters.candidates,
            shortest=parameters.min_sentence,
            seed=parameters.seed,
            report=heard,
        )
    return tuple(
        Sentence(name, tuple(pieces[start:end]))
        for (name, pieces), own in zip(rows, cuts, strict=True)
        for start, end in zip((0, *own), (*own, len(pieces)), strict=True)
    )


def _runs(terminals: Terminals, clip: str, repeats: str) -> Sequence[tuple[int, Segment]]:
    return terminals.runs(clip) if repeats == "join" else terminals.occurrences[clip]


def _baselines(
    strings: Sequence[tuple[int, ...]], learned: Induced, progress: Progress
) -> dict[str, Mapping[str, float]]:
    """Size and bits of what the same sentences give a state machine and Sequitur.

    The machine's bits: a transition is two symbols of its states and the end; a sentence's those of its probability.
    """
    machine = state_machine(strings)
    progress(0.2)
    hierarchy = sequitur(strings)
    progress(0.6)
    states = len(machine.leaving)
    of_strings = -sum(machine.log2_probability(string) for string in strings)
    trees = [tree for tree in map(hierarchy.parse, strings) if tree is not None]  # it generates each of them
    progress(1.0)
    return {
        "state_machine": _figures(
            len(machine.transitions), Bits(2 * len(machine.transitions) * np.log2(states), of_strings)
        ),
        "sequitur": _figures(len(hierarchy.rules), hierarchy.bits(trees)),
    }


def _figures(rules: int, bits: Bits) -> dict[str, float]:
    return {
        "rules": rules,
        "bits_grammar": float(bits.grammar),
        "bits_sentences": float(bits.sentences),
        "bits_total": float(bits.total),
    }
