"""Learning a grammar from sentences by alignment-based learning (van Zaanen 2000; SYN section 5)."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence
from typing import NamedTuple

from core.errors import AnalysisError
from core.grammar.alignment import Sentence, align, ways
from core.grammar.constituents import grammar_of, merge_kinds, read_off
from core.grammar.motion_grammar import Grammar
from core.grammar.selection import select
from core.grammar.trees import Node
from core.progress import Progress, Report, part_of, silent


class Induced(NamedTuple):
    """A grammar, and the tree of every sentence it was learned from."""

    grammar: Grammar
    trees: tuple[Node, ...]

    @property
    def bits(self) -> float:
        """Total description length (SYN equation 6)."""
        return self.grammar.bits(self.trees).total


def induce(
    sentences: Iterable[Sequence[int]],
    *,
    align_by: str = "auto",
    select_by: str = "saving",
    touching: bool = False,
    merge: str = "side",
    report: Report = silent,
) -> Induced:
    """The grammar of sentences of terminals (numbers from 0).

    align_by: see :func:`core.grammar.alignment.align`; "auto" takes the way that gives the shorter description;
    select_by, touching: see :func:`core.grammar.selection.select`;
    merge: "no", "side" or "rules", see :func:`core.grammar.constituents.merge_kinds`. With touching=False and
    merge="no" no sentence of the grammar has two neighbours that are not neighbours in a training sentence.
    Raises AnalysisError where there are no sentences or one is empty.
    """
    given = [tuple(map(int, sentence)) for sentence in sentences]
    if not given or not all(given):
        raise AnalysisError("a grammar needs sentences, and every sentence at least one terminal")
    tried = ways(list(dict.fromkeys(given))) if align_by == "auto" else (align_by,)
    learned = []
    for k, way in enumerate(tried):
        heard = part_of(lambda fraction: report("rules", fraction), k / len(tried), (k + 1) / len(tried))
        learned.append(_induced(given, way, select_by, touching, merge, heard))
    return min(learned, key=lambda one: one.bits)


def _induced(
    given: list[Sentence], align_by: str, select_by: str, touching: bool, merge: str, progress: Progress
) -> Induced:
    different: dict[Sentence, int] = Counter(given)
    kept = list(different)
    hypotheses = align(kept, align_by, part_of(progress, 0.0, 0.1))
    chosen = select(kept, hypotheses, list(different.values()), select_by, touching, part_of(progress, 0.1, 0.25))
    trees = read_off(kept, chosen)
    place = {sentence: k for k, sentence in enumerate(kept)}
    every = [trees[place[sentence]] for sentence in given]
    if merge != "no":
        every = list(merge_kinds(given, every, merge, part_of(progress, 0.25, 0.95)))
    progress(0.95)
    grammar, numbered = grammar_of(every)
    return Induced(grammar, numbered)
