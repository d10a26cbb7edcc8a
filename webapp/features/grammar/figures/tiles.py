"""The figures above a grammar: number of actions, how often they recur, how well the rules describe them."""

from __future__ import annotations

from typing import TYPE_CHECKING

from core.mocap.dataset import Dataset

if TYPE_CHECKING:
    from core.grammar.learned import LearnedGrammar

Tile = tuple[str, str, str]


def tiles(dataset: Dataset, learned: LearnedGrammar) -> list[Tile]:
    """Name, value and explanation of each figure."""
    terminals, grammar = learned.terminals, learned.grammar
    count = sum(map(len, terminals.segments))
    total = max(sum(clip.n_frames for clip in dataset.clips), 1)
    covered = sum(s.n_frames for occurrences in terminals.segments for s in occurrences) / total
    recurring = (
        sum(s.n_frames for occurrences in terminals.segments if len(occurrences) > 1 for s in occurrences) / total
    )
    objective = terminals.objective
    return [
        ("Actions", str(terminals.n_terminals), "Kinds of short movements that were told apart."),
        (
            "Recurring",
            f"{100 * recurring:.0f} %",
            "Share of all frames in actions that occur more than once. "
            f"All actions together cover {100 * covered:.0f} %.",
        ),
        (
            "Repeated",
            f"{count / max(terminals.n_terminals, 1):.1f}×",
            f"How often an action occurs on average: {count} pieces in all.",
        ),
        (
            "Reduced to",
            f"{100 * objective['R']:.1f} %",
            "One typical occurrence of every action, put together, as a share of all motion (R). "
            "Small: much is repeated. 100 %: nothing is.",
        ),
        (
            "Spread",
            f"{100 * objective['E']:.1f} %",
            "How far occurrences lie from the typical one of their action, as a share of the largest distance of two "
            "poses (E'). Small: all occurrences of an action look alike.",
        ),
        (
            "Rules",
            str(len(grammar.rules)),
            f"Ways in which routines and their {len(grammar.nonterminals) - 1} phrases are put together.",
        ),
        (
            "Bits",
            f"{learned.bits.total:.0f}",
            f"What it takes to write the rules ({learned.bits.grammar:.0f}) and, with them, all "
            f"{len(learned.sentences)} routines ({learned.bits.sentences:.0f}). Small: the rules say much.",
        ),
    ]
