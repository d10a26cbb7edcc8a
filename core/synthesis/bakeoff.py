"""Comparison of four ways to make new motion from the same recordings (SYN section 7): a grammar, a state
machine, Sequitur, and random walks on the motif graph."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict, dataclass, field
from typing import Any

import numpy as np

from core.errors import AnalysisError, MotionscapeError, ParameterError
from core.grammar.baselines import sequitur, state_machine
from core.grammar.build import GrammarParameters
from core.grammar.induction import induce
from core.grammar.learned import LearnedGrammar
from core.grammar.trees import leaves
from core.mocap.clip import Clip
from core.mocap.dataset import Dataset
from core.motifs.graph import MotifGraph
from core.parameters import parameter
from core.progress import Report, silent
from core.synthesis.derivations import Derivation, perform
from core.synthesis.graph_paths import MotifPaths, motif_paths
from core.synthesis.paths import Random
from core.synthesis.walks import Walk, make_walk

GRAMMAR, MACHINE, SEQUITUR, WALK = CONTENDERS = ("grammar", "state machine", "sequitur", "motif walk")
_WRITTEN = 200  # sentences that are made to see how many are new
String = tuple[int, ...]
Accepts = Callable[[Sequence[int]], bool]


@dataclass(frozen=True)
class BakeoffParameters(GrammarParameters):
    """How the comparison is made, besides how the grammar is learned. Raises ParameterError for a value out of
    range.
    """

    folds: int = parameter(5, "Parts into which sentences are divided; each is held out once.", 2, 50)
    shuffles: int = parameter(20, "Shuffles of every held-out sentence.", 1, 1000)
    routines: int = parameter(4, "New motions that each makes, to measure them.", 1, 50)
    max_terminals: int = parameter(40, "Actions of a new motion at most.", 1, 200)

    def __post_init__(self) -> None:
        super().__post_init__()
        for name, low, high in (
            ("folds", 2, 50),
            ("shuffles", 1, 1000),
            ("routines", 1, 50),
            ("max_terminals", 1, 200),
        ):
            if not low <= getattr(self, name) <= high:
                raise ParameterError(f"{name} must be {low} to {high}")

    @property
    def grammar(self) -> dict[str, Any]:
        """The parameters of the grammar alone."""
        return {name: getattr(self, name) for name in GrammarParameters.__dataclass_fields__}


@dataclass(frozen=True)
class Contender:
    """Figures of one of the four.

    rules: rules, transitions or edges. accepted: share of the held-out sentences that it, learned from the others,
    could have made; shuffled: share of their shuffles; bits: description length of rules and sentences, for each
    sentence; new: share of sentences by chance that are none of the recordings'. Of its new motions: blends a minute;
    seam_speed and source_speed: metres a second of the fastest joint, in the blends and in the recordings used; skate:
    metres that feet slide in a second of contact, plain: by blending alone, source: in the recordings. nan where
    nothing was made.
    """

    name: str
    rules: int
    accepted: float
    shuffled: float
    bits: float
    new: float
    blends: float
    seam_speed: float
    source_speed: float
    skate: float
    skate_plain: float
    skate_source: float


@dataclass(frozen=True, eq=False)
class Bakeoff:
    """The comparison. clips: a new motion of each that made one, named as it; sentences and shuffles: how many were
    tried; notes: in plain words why something could not be made."""

    contenders: tuple[Contender, ...]
    clips: tuple[Clip, ...]
    sentences: int
    shuffles: int
    notes: tuple[str, ...] = ()
    parameters: Mapping[str, Any] = field(default_factory=dict)


def bake_off(
    dataset: Dataset,
    learned: LearnedGrammar,
    graph: MotifGraph,
    parameters: BakeoffParameters | None = None,
    report: Report = silent,
) -> Bakeoff:
    """Compares the four ways on one data set. Deterministic. Strings of motifs are held out clip by clip.

    Raises AnalysisError where there are fewer than two sentences.
    """
    parameters = parameters or BakeoffParameters()
    strings = [sentence.terminals for sentence in learned.sentences]
    if len(strings) < 2:
        raise AnalysisError(
            "the comparison holds sentences out, and here there is only one: cut the recordings into more"
        )
    rng = np.random.default_rng(parameters.seed)
    paths = motif_paths(graph)
    shares, tried = _held_out(strings, paths, parameters, rng, report)
    writers = _writers(strings, learned)
    contenders, clips, notes = [], [], []
    lasting: list[float] = []  # seconds of the grammar's motions: the walks get as long
    for k, name in enumerate(CONTENDERS):
        report("new motion", k / len(CONTENDERS))
        if name == WALK:
            seconds = float(np.clip(np.mean(lasting), 3, 120)) if lasting else 20.0
            walks, why = _walks(dataset, graph, seconds, parameters)
            made: Sequence[Walk | Derivation] = walks
            new = _share(walk.path not in paths.known for walk in walks)
            rules, bits = paths.edges, paths.bits
        else:
            write = writers[name]
            new = _share(write(seed) not in set(strings) for seed in range(_WRITTEN))
            made, why = _motions(dataset, learned, write, parameters)
            rules, bits = _size(strings, learned, name)
            lasting += [motion.clip.seconds for motion in made] if name == GRAMMAR else []
        notes += [f"{name}: {reason}" for reason in dict.fromkeys(why)]
        clips += [_named(motion.clip, name) for motion in made[:1]]
        contenders.append(Contender(name, rules, *shares[name], bits, new, *_qualities(made)))
    return Bakeoff(tuple(contenders), tuple(clips), len(strings), tried, tuple(notes), asdict(parameters))


def _held_out(
    strings: Sequence[String],
    paths: MotifPaths,
    parameters: BakeoffParameters,
    rng: np.random.Generator,
    report: Report,
) -> tuple[dict[str, tuple[float, float]], int]:
    """Contender -> shares of held-out sentences and of their shuffles that it accepts; and how many shuffles."""
    folds = min(parameters.folds, len(strings))
    fold = rng.permutation(np.arange(len(strings)) % folds)
    verdicts: dict[str, list[list[bool]]] = {name: [[], []] for name in CONTENDERS}
    for k in range(folds):
        report("held out", k / folds)
        rest = [string for string, own in zip(strings, fold, strict=True) if own != k]
        held = [string for string, own in zip(strings, fold, strict=True) if own == k]
        judges = {
            GRAMMAR: induce(rest, **parameters.induction).grammar.accepts,
            MACHINE: state_machine(rest).accepts,
            SEQUITUR: sequitur(rest).accepts,
        }
        shuffles = [_shuffled(string, rng) for string in held for _ in range(parameters.shuffles)]
        for name, accepts in judges.items():
            verdicts[name][0] += map(accepts, held)
            verdicts[name][1] += [accepts(string) for string, same in shuffles if not same]
    for clip, path in paths.by_clip.items():
        walks = paths.without(clip)
        verdicts[WALK][0].append(walks(path))
        shuffles = [_shuffled(path, rng) for _ in range(parameters.shuffles)]
        verdicts[WALK][1] += [walks(string) for string, same in shuffles if not same]
    shares = {name: (_share(held), _share(shuffled)) for name, (held, shuffled) in verdicts.items()}
    return shares, len(verdicts[GRAMMAR][1])


def _shuffled(string: String, rng: np.random.Generator) -> tuple[String, bool]:
    """The string in random order, and whether that is the same again."""
    made = tuple(rng.permutation(string).tolist())
    return made, made == string


def _writers(strings: Sequence[String], learned: LearnedGrammar) -> dict[str, Callable[[int], String]]:
    """Contender -> its sentence for a seed."""
    most = max(map(len, strings))
    machine, hierarchy = state_machine(strings), sequitur(strings)
    return {
        GRAMMAR: lambda seed: leaves(learned.grammar.generate(seed, max_terminals=most)),
        MACHINE: lambda seed: machine.generate(seed, most),
        SEQUITUR: lambda seed: leaves(hierarchy.generate(seed, max_terminals=most)),
    }


def _size(strings: Sequence[String], learned: LearnedGrammar, name: str) -> tuple[int, float]:
    """Rules, and bits for each sentence."""
    if name == GRAMMAR:
        return len(learned.grammar.rules), learned.bits.total / len(strings)
    figures = learned.baselines[name.replace(" ", "_")]
    return int(figures["rules"]), figures["bits_total"] / len(strings)


def _motions(
    dataset: Dataset, learned: LearnedGrammar, write: Callable[[int], String], parameters: BakeoffParameters
) -> tuple[list[Derivation], list[str]]:
    made, why = [], []
    for seed in range(parameters.routines):
        try:
            sentence = write(parameters.seed + seed)[: parameters.max_terminals]
            made.append(perform(dataset, sentence, learned.segments, seed=seed))
        except MotionscapeError as error:
            why.append(str(error))
    return made, why


def _walks(
    dataset: Dataset, graph: MotifGraph, seconds: float, parameters: BakeoffParameters
) -> tuple[list[Walk], list[str]]:
    made, why = [], []
    for seed in range(parameters.routines):
        try:
            made.append(make_walk(dataset, graph, Random(seconds, parameters.seed + seed)))
        except MotionscapeError as error:
            why.append(str(error))
    return made, why


def _qualities(made: Sequence[Derivation | Walk]) -> tuple[float, ...]:
    """Blends a minute, fastest joint in blends and recordings, and skate as kept, by blending alone, in recordings."""
    if not made:
        return (float("nan"),) * 6
    minutes = sum(motion.clip.seconds for motion in made) / 60
    rows = [(*motion.speeds, motion.skate.kept, motion.skate.plain, motion.skate.source) for motion in made]
    return sum(len(motion.seams) for motion in made) / minutes, *map(float, np.mean(rows, axis=0))


def _named(clip: Clip, name: str) -> Clip:
    return Clip(name, clip.skeleton, clip.fps, clip.root_positions, clip.rotations)


def _share(values: Any) -> float:
    numbers = list(values)
    return float(np.mean(numbers)) if numbers else float("nan")
