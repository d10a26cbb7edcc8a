"""What learning a grammar from recordings gives, and how it is kept: grammar.json."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, NamedTuple

from core.errors import FormatError
from core.grammar import terminals as terminal_files
from core.grammar.motion_grammar import Bits, Grammar
from core.grammar.rules import Rule
from core.grammar.terminals import Terminals, segment_json
from core.grammar.trees import Node
from core.mocap.clip import Segment

FORMAT = "motionscape/grammar/1"


class Sentence(NamedTuple):
    """A sentence of the recordings: its clip, and its terminals with the segments they stand for, in order."""

    clip: str
    pieces: tuple[tuple[int, Segment], ...]

    @property
    def terminals(self) -> tuple[int, ...]:
        """The sentence as a string."""
        return tuple(terminal for terminal, _ in self.pieces)


@dataclass(frozen=True, eq=False)
class LearnedGrammar:
    """A grammar and what it was learned from.

    trees: one a sentence, whose rule indices (:meth:`Grammar.rule_indices`) give the sentence back. baselines: name ->
    figures of a state machine and of Sequitur on the same sentences. parameters: as used; seconds: stage -> time.
    """

    terminals: Terminals
    sentences: tuple[Sentence, ...]
    grammar: Grammar
    trees: tuple[Node, ...]
    baselines: Mapping[str, Mapping[str, float]] = field(default_factory=dict)
    parameters: Mapping[str, Any] = field(default_factory=dict)
    seconds: Mapping[str, float] = field(default_factory=dict)

    @cached_property
    def bits(self) -> Bits:
        """Description length of the grammar and of the sentences (SYN equation 6)."""
        return self.grammar.bits(self.trees)

    @cached_property
    def segments(self) -> Mapping[int, tuple[Segment, ...]]:
        """Terminal -> the segments that stand for it in the sentences."""
        segments_of: dict[int, list[Segment]] = {}
        for sentence in self.sentences:
            for terminal, segment in sentence.pieces:
                segments_of.setdefault(terminal, []).append(segment)
        return {terminal: tuple(segments_of[terminal]) for terminal in sorted(segments_of)}

    def to_json(self) -> dict[str, Any]:
        """grammar.json; beyond the design's fields: ``right`` sides and trees name non-terminals by strings; ``start``,
        ``spans`` (a sentence's clip and segments), ``derivations`` (rule indices of each sentence), ``baselines``."""
        own = self.terminals.to_json()
        return {
            **own,
            "format": FORMAT,
            "parameters": dict(self.parameters),
            "seconds": {stage: round(t, 4) for stage, t in self.seconds.items()},
            "terminal_search": {"parameters": own["parameters"], "seconds": own["seconds"]},
            "sentences": [list(sentence.terminals) for sentence in self.sentences],
            "spans": [
                {"clip": sentence.clip, "segments": [segment_json(segment) for _, segment in sentence.pieces]}
                for sentence in self.sentences
            ],
            "start": self.grammar.start,
            "rules": [{"left": r.left, "right": list(r.right), "count": r.count} for r in self.grammar.rules],
            "derivations": [list(self.grammar.rule_indices(tree)) for tree in self.trees],
            "bits": {"grammar": self.bits.grammar, "sentences": self.bits.sentences, "total": self.bits.total},
            "baselines": {name: dict(figures) for name, figures in self.baselines.items()},
        }


def from_json(document: Mapping[str, Any]) -> LearnedGrammar:
    """The grammar back from :meth:`LearnedGrammar.to_json`. Raises FormatError for anything that is not such a
    document, or whose derivations do not give its sentences."""
    if not isinstance(document, Mapping) or document.get("format") != FORMAT:
        format_name = document.get("format") if isinstance(document, Mapping) else type(document).__name__
        raise FormatError(f"this is no grammar: found {format_name!r}, expected {FORMAT!r}")
    try:
        searched = document["terminal_search"]
        terminals = terminal_files.from_json({**document, "format": terminal_files.FORMAT, **searched})
        grammar = Grammar(
            tuple(Rule(rule["left"], tuple(rule["right"]), rule["count"]) for rule in document["rules"]),
            document["start"],
        )
        sentences = tuple(
            Sentence(
                span["clip"],
                tuple(
                    (t, Segment(s["clip"], s["start"], s["end"])) for t, s in zip(string, span["segments"], strict=True)
                ),
            )
            for string, span in zip(document["sentences"], document["spans"], strict=True)
        )
        learned = LearnedGrammar(
            terminals, sentences, grammar, tuple(map(grammar.tree_of, document["derivations"])),
            document["baselines"], document["parameters"], document["seconds"],
        )  # fmt: skip
    except (KeyError, TypeError, AttributeError) as error:
        raise FormatError(f"this grammar is incomplete: {error!r} is missing or misshapen") from error
    for sentence, code in zip(sentences, document["derivations"], strict=True):
        if grammar.reconstruct(code) != sentence.terminals:
            raise FormatError("this grammar's derivations do not give its sentences")
    return learned
