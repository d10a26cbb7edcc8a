"""New motion from a grammar: a sentence of terminals, a recorded segment for each, stitched (SYN section 6)."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from core.errors import AnalysisError, ParameterError
from core.grammar.learned import LearnedGrammar
from core.grammar.motion_grammar import Grammar
from core.grammar.trees import Node, leaves
from core.mocap.clip import Clip, Segment
from core.mocap.dataset import Dataset
from core.progress import Report, silent
from core.synthesis.bodies import same_joints
from core.synthesis.footing import Skate
from core.synthesis.postures import Moment, moments_apart
from core.synthesis.stitching import Speeds, stitch

MOST_TERMINALS = 1000


@dataclass(frozen=True, eq=False)
class Derivation:
    """A sentence of a grammar as motion.

    clip: the motion, floor at height 0. terminals: the sentence. pieces: the segment that shows each terminal. spans:
    half-open frames of the clip in which each is on; they follow one another without gaps. tree: how the grammar made
    the sentence, None for one given as terminals. jumps: metres between the postures where one piece passes into the
    next. seams: half-open frames of the blends. contacts ``(n_frames, 2)`` bool: which foot stands. skate: the
    foot-skate meter. speeds: of the fastest joint. warnings: plain words.
    """

    clip: Clip
    terminals: tuple[int, ...]
    pieces: tuple[Segment, ...]
    spans: tuple[tuple[int, int], ...]
    tree: Node | None
    jumps: tuple[float, ...]
    seams: tuple[tuple[int, int], ...]
    contacts: np.ndarray
    skate: Skate
    speeds: Speeds
    warnings: tuple[str, ...] = ()


def read_sentence(grammar: Grammar, text: str) -> Node:
    """The tree that a text stands for: ``random:SEED:MOST`` (by chance, about so many terminals at most) or rule
    indices, ``0.3.1`` (SYN 5.1). Raises ParameterError in plain words."""
    by_chance = re.fullmatch(r"random:(\d{1,9})(?::(\d{1,4}))?", text)
    if by_chance:
        most = min(max(int(by_chance[2] or 40), 1), MOST_TERMINALS)
        return grammar.generate(int(by_chance[1]), max_terminals=most)
    if not re.fullmatch(r"\d{1,5}([.-]\d{1,5})*", text):
        raise ParameterError(f"sentence: expected random:SEED:MOST or rule indices such as 0.3.1, not {text[:40]!r}")
    return grammar.tree_of(map(int, re.split("[.-]", text)))


def derive(
    dataset: Dataset,
    learned: LearnedGrammar,
    sentence: Node | str,
    *,
    keep_feet: bool = True,
    seed: int = 0,
    name: str = "routine",
    report: Report = silent,
) -> Derivation:
    """A sentence of a learned grammar as motion; sentence: its tree, or a text for :func:`read_sentence`.

    The same seed gives the same motion. Raises ValueError in plain words where that cannot be.
    """
    tree = read_sentence(learned.grammar, sentence) if isinstance(sentence, str) else sentence
    return perform(
        dataset, leaves(tree), learned.segments, tree=tree, keep_feet=keep_feet, seed=seed, name=name, report=report
    )


def perform(
    dataset: Dataset,
    terminals: Sequence[int],
    segments: Mapping[int, Sequence[Segment]],
    *,
    tree: Node | None = None,
    keep_feet: bool = True,
    seed: int = 0,
    name: str = "routine",
    report: Report = silent,
) -> Derivation:
    """Any sentence of terminals as motion; segments: those that may stand for each terminal.

    Raises AnalysisError for an empty sentence, a terminal without segments, or where no one skeleton has them all.
    """
    if not terminals:
        raise AnalysisError("this sentence has no actions, so there is nothing to show")
    usable = _of_one_skeleton(dataset, terminals, segments)
    pieces, jumps = choose_segments(dataset, terminals, usable, seed)
    made = stitch(dataset, pieces, keep_feet=keep_feet, name=name, report=report)
    leading = made.timeline.leading[0]
    begins = np.searchsorted(leading, np.arange(len(pieces) + 1)).tolist()
    return Derivation(
        clip=made.clip,
        terminals=tuple(terminals),
        pieces=pieces,
        spans=tuple(pairwise(begins)),
        tree=tree,
        jumps=jumps,
        seams=tuple((int(a), int(b)) for a, b in made.timeline.seams),
        contacts=made.contacts,
        skate=made.skate,
        speeds=made.speeds,
        warnings=made.warnings,
    )


def choose_segments(
    dataset: Dataset, terminals: Sequence[int], segments: Mapping[int, Sequence[Segment]], seed: int = 0
) -> tuple[tuple[Segment, ...], tuple[float, ...]]:
    """A segment for every terminal, and the distance in metres from each to the next (SYN section 6).

    The first by chance, then greedily the one whose first posture is nearest to the last of the one before.
    Raises KeyError for a terminal without segments.
    """
    rng = np.random.default_rng(seed)
    used = dict.fromkeys(segment for terminal in dict.fromkeys(terminals) for segment in segments[terminal])
    place = {segment: k for k, segment in enumerate(used)}
    moments = [Moment(s.clip, s.start) for s in used] + [Moment(s.clip, s.end - 1) for s in used]
    features = moments_apart(dataset, moments).astype(np.float64)
    starts, ends = features[: len(used)], features[len(used) :]
    first = segments[terminals[0]]
    chosen, jumps = [first[int(rng.integers(len(first)))]], []
    for terminal in terminals[1:]:
        choices = [place[segment] for segment in segments[terminal]]
        far = np.linalg.norm(starts[choices] - ends[place[chosen[-1]]], axis=1)
        best = int(far.argmin())
        chosen.append(segments[terminal][best])
        jumps.append(float(far[best]))
    return tuple(chosen), tuple(jumps)


def _of_one_skeleton(
    dataset: Dataset, terminals: Sequence[int], segments: Mapping[int, Sequence[Segment]]
) -> dict[int, list[Segment]]:
    """The segments of clips whose skeletons have the same joints: of those that have all terminals, most segments."""
    wanted = dict.fromkeys(terminals)
    families: list[tuple[Clip, set[str]]] = []
    for clip in dataset.clips:
        family = next((names for first, names in families if same_joints(first.skeleton, clip.skeleton)), None)
        if family is None:
            families.append((clip, {clip.name}))
        else:
            family.add(clip.name)
    by_family = [{t: [s for s in segments.get(t, ()) if s.clip in names] for t in wanted} for _, names in families]
    whole = [usable for usable in by_family if all(usable.values())]
    if not whole:
        missing = [t for t in wanted if not any(usable[t] for usable in by_family)]
        if missing:
            raise AnalysisError(f"no recording shows action {missing[0]}")
        raise AnalysisError("no one skeleton has all actions of this sentence, and one motion needs one skeleton")
    return max(whole, key=lambda usable: sum(map(len, usable.values())))
