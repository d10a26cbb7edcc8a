"""Comparisons of groups: how often planted differences are found, false alarms, the curve test beside spm1d, speed.

usage: python -m benchmarks groups     (spm1d is left out where it is not installed)
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator

import numpy as np

from benchmarks.recordings import SHARED
from core import find_motifs, open_dataset
from core.arrays import FloatArray
from core.comparing import compared, label_items, strides
from core.demo import make_demo
from core.demo.planted import DIFFERENCES, Difference, person
from core.groups.clusters import cluster_test
from core.groups.comparison import Comparison, table_rows
from core.groups.curves import all_curves, unit_curves
from core.groups.design import Design, Unit, make_design
from core.groups.figures import figure_table, figures_by_clip
from core.groups.parameters import GroupParameters
from core.groups.tables import use_table
from core.mocap.clip import Clip, Label
from core.mocap.dataset import Dataset, ImportReport
from core.mocap.properties import Properties
from core.mocap.property_files import by_pattern

POOL, DRAWS, SPLITS, SIZES = 24, 40, 500, (4, 8, 16)
PARAMETERS = GroupParameters(permutations=1000, resamples=100)
# What counts as finding the difference: rows of these names
SIGNS = {"kicks": ("kick",), "slower": ("Walking speed", "Step time", "Cadence"), "wider": ("Left arm", "Right arm")}
CURVE = "left hip flexion"


def main() -> str:
    """The section of docs/benchmarks.md, in Markdown."""
    pools = {difference: Pool(difference, 1000 * k) for k, difference in enumerate(DIFFERENCES)}
    return "\n".join(
        [
            "## Groups compared",
            "",
            f"`python -m benchmarks groups`: people of the demo, {POOL} in each pool, a routine of a minute or two",
            "each. One group kicks twice as often, moves a tenth slower, or holds the arms 15 degrees wider. Found: a",
            f"figure that speaks of it has a corrected p-value of at most .05, share of {DRAWS} draws.",
            "",
            "| planted | " + " | ".join(f"{size} a group" for size in SIZES) + " |",
            "|---|" + "---|" * len(SIZES),
            *(power(pools, difference) for difference in DIFFERENCES if difference != "nothing"),
            "",
            *false_alarms(pools["nothing"]),
            *beside_spm1d(pools),
            *real(),
            *speed(),
        ]
    )


class Pool:
    """People with a difference: their figures and use of labels, a row each."""

    def __init__(self, difference: Difference, first: int):
        made = [person(first + k, difference, seed=1) for k in range(POOL)]
        self.dataset = as_dataset(made)
        self.design = Design("group", ("A",), tuple(Unit(n, "A", (n,)) for n in self.dataset.names), "subject")
        self.figures = figure_table(self.design, figures_by_clip(self.design, self.dataset))
        self.curves = all_curves(self.dataset, self.dataset.names)
        self.motions = list(strides(self.dataset, self.dataset.names))

    def use(self, actions: tuple[str, ...]) -> FloatArray:
        """Share, rate and duration of these labels, ``(POOL, n_actions, 3)``."""
        items = {item.id: item for item in label_items(self.dataset)}
        clips = {clip.name: (clip.n_frames, clip.fps) for clip in self.dataset.clips}
        return use_table(self.design, [items[action] for action in actions], clips)

    def curve(self, name: str) -> FloatArray:
        """The mean curve of the gait of each person, ``(POOL, points)``."""
        return unit_curves(self.design, self.curves, name, self.motions)


def as_dataset(made: list[tuple[Clip, tuple[Label, ...]]]) -> Dataset:
    """Clips with their labels as a data set."""
    labels = tuple(label for _, own in made for label in own)
    return Dataset("people", tuple(clip for clip, _ in made), labels, ImportReport(()))


ACTIONS = ("idle", "jump", "kick", "punch", "squat", "walk")


def two(size: int) -> Design:
    """A design of two groups of so many subjects."""
    units = tuple(Unit(f"{group}{k}", group, ()) for group in "AB" for k in range(size))
    return Design("group", ("A", "B"), units, "subject")


def tested(use: FloatArray, figures: FloatArray, seed: int) -> tuple[Comparison, ...]:
    """The rows of a comparison of the first half of the people with the second."""
    parameters = GroupParameters(PARAMETERS.permutations, PARAMETERS.resamples, seed=seed)
    names = tuple(("label", action, action) for action in ACTIONS)
    return table_rows(two(len(use) // 2), names, use, figures, parameters)


def power(pools: dict[Difference, Pool], difference: Difference) -> str:
    """How often a planted difference is found with 4, 8 and 16 people a group."""
    plain, other = pools["nothing"], pools[difference]
    tables = [(pool.use(ACTIONS), pool.figures) for pool in (plain, other)]
    rng, cells = np.random.default_rng(0), []
    for size in SIZES:
        hits = 0
        for draw in range(DRAWS):
            chosen = [rng.permutation(POOL)[:size] for _ in tables]
            use, figures = (np.concatenate([t[k][own] for t, own in zip(tables, chosen, strict=True)]) for k in (0, 1))
            rows = tested(use, figures, draw)
            hits += any(row.q <= 0.05 and row.name.startswith(SIGNS[difference]) for row in rows)
        cells.append(f"{hits / DRAWS:.2f}")
    return f"| {difference} | " + " | ".join(cells) + " |"


def false_alarms(pool: Pool) -> Iterator[str]:
    """How often something is found among people who do not differ."""
    use, rng = pool.use(ACTIONS), np.random.default_rng(1)
    curves = [pool.curve(name) for name in (CURVE, "right knee flexion", "trunk flexion")]
    single, families, along, counted = 0, 0, 0, 0
    for split in range(SPLITS):
        chosen = rng.permutation(POOL)[:16]
        rows = tested(use[chosen], pool.figures[chosen], split)
        p = np.array([row.p for row in rows])
        single, counted = single + int((p <= 0.05).sum()), counted + int(np.isfinite(p).sum())
        families += any(row.q <= 0.05 for row in rows)
        curve = curves[split % len(curves)][chosen]
        if np.isfinite(curve).all():
            along += any(c.p <= 0.05 for c in cluster_test(two(8), curve, 500, seed=split).clusters)
    yield f"Of {SPLITS} random splits of people who do not differ, 8 against 8 (500 permutations for the curves):"
    yield ""
    yield "| | share |"
    yield "|---|---|"
    yield f"| single tests with p at most .05, before the correction | {single / counted:.3f} |"
    yield f"| comparisons with any corrected p at most .05 (two families) | {families / SPLITS:.3f} |"
    yield f"| curves of the gait with a stretch of p at most .05 | {along / SPLITS:.3f} |"
    yield ""


def beside_spm1d(pools: dict[Difference, Pool]) -> Iterator[str]:
    """The curve test and that of spm1d on the same curves."""
    try:
        import spm1d
    except ImportError:
        return
    yield "The test along curves beside `spm1d.stats.nonparam.ttest2`, both with 2000 permutations: curves of the gait,"
    yield "8 people against 8. Stretches are in per cent of the cycle."
    yield ""
    yield "| groups, curve | threshold of t: ours | spm1d | stretches: ours | spm1d | p: ours | spm1d |"
    yield "|---|---|---|---|---|---|---|"
    for difference, name in (
        ("slower", CURVE),
        ("wider", "left shoulder elevation"),
        ("slower", "speed of the pelvis"),
    ):
        a, b = (pools[d].curve(name)[:8] for d in ("nothing", difference))
        ours = cluster_test(two(8), np.concatenate([a, b]), 2000)
        np.random.seed(0)  # noqa: NPY002  spm1d draws from it
        theirs = spm1d.stats.nonparam.ttest2(b, a).inference(0.05, two_tailed=True, iterations=2000)
        own = sorted(((np.flatnonzero(c.where), c.p) for c in ours.clusters), key=lambda pair: int(pair[0][0]))
        cells = (
            f"{difference}, {name}",
            f"{ours.threshold:.2f}",
            f"{theirs.zstar:.2f}",
            ", ".join(f"{at[0]}-{at[-1]}" for at, _ in own) or "none",
            ", ".join(f"{c.endpoints[0]:.1f}-{c.endpoints[1]:.1f}" for c in theirs.clusters) or "none",
            ", ".join(f"{p:.4f}" for _, p in own),
            ", ".join(f"{c.P:.4f}" for c in theirs.clusters),
        )
        yield "| " + " | ".join(cells) + " |"
    yield ""


def real() -> Iterator[str]:
    """What is said of exhausted and youthful motion."""
    folder = SHARED / "data" / "bandai_namco_2_part"
    if not folder.is_dir():
        return
    dataset = open_dataset(folder)
    properties = Properties().with_values(by_pattern("dataset-2_{action}_{style}_{take}", dataset.names)[0])
    design = make_design(properties, dataset.names, "style", groups=("youthful", "exhausted"))
    document = compared(dataset, design, None, GroupParameters())
    yield "`bandai_namco_2_part`, exhausted against youthful (clips of one performer, so clips are the unit), in words:"
    yield ""
    yield from (f"- {one['text']}" for one in document["words"])
    yield ""


def speed() -> Iterator[str]:
    """How long a whole comparison takes."""
    yield "A whole comparison with 1000 permutations (labels and motifs known), seconds:"
    yield ""
    yield "| recordings | processor | clock |"
    yield "|---|---|---|"
    folder = SHARED / "data" / "bandai_namco_2_part"
    if folder.is_dir():
        dataset = open_dataset(folder)
        graph = find_motifs(dataset)
        properties = Properties().with_values(by_pattern("dataset-2_{action}_{style}_{take}", dataset.names)[0])
        design = make_design(properties, dataset.names, "style")
        yield timed("`bandai_namco_2_part`, three styles, motifs", lambda: compared(dataset, design, graph, PARAMETERS))
    hour = make_demo(60)
    properties = Properties().with_values(by_pattern("{performer}_{take}", hour.names)[0])
    by_performer = make_design(properties, hour.names, "performer", subject="")
    yield timed("1 h of demo, three performers, labels", lambda: compared(hour, by_performer, None, PARAMETERS))


def timed(name: str, work: Callable[[], object]) -> str:
    """A row of the table."""
    spent, clock = time.process_time(), time.perf_counter()
    work()
    return f"| {name} | {time.process_time() - spent:.1f} | {time.perf_counter() - clock:.1f} |"
