"""Does the motion map find actions by a few postures, as in the usability tests of the 2004 paper?

usage: python -m benchmarks.bench_map_search

First test (its table 1): the keys are the icons nearest to three postures of one labelled instance of an action; the
right action, in another instance, should be among the first five hits; on the paper's 21 x 21 nodes and on the
default's 30 x 30.
Second test (its table 2, "Choice"): one key posture of a clip narrows the clips to few.
"""

from __future__ import annotations

import numpy as np

from benchmarks.recordings import EXERCISES, SHARED, asfamc
from core.demo import make_demo
from core.mocap.clip import Label, Segment
from core.mocap.dataset import Dataset, open_dataset
from core.mocap.labels import read_labels
from core.motion_map.build import MapParameters, build_motion_map
from core.motion_map.motion_map import MotionMap
from core.poses.postures import Postures, postures_of

SEEDS = 8
FIRST = 5  # hits that a person looks at
MOMENTS = (1 / 6, 1 / 2, 5 / 6)  # of the way that the joints travel in the instance: there the postures are taken
GRIDS = ("21x21", "30x30")
STEP = 0.05  # metres by which T grows until there are FIRST hits
INSIDE = 0.5  # of a hit lies in an instance of the action: it is right
TASKS = {
    "demo": ("jump", "punch", "kick", "squat", "cartwheel", "crawl", "roll", "dance"),
    "CMU": ("JumpJack", "KneeRaise", "Squat", "Twist", "ArmCircle", "Jog", "walk", "punch"),
}


def collections() -> dict[str, Dataset]:
    """The demo of six minutes, and seven labelled CMU clips where they are here."""
    found = {"demo": make_demo(minutes=6)}
    folder = asfamc()
    if folder:
        clips = (*EXERCISES, "86_01", "86_09")
        dataset = open_dataset(
            [folder / "13", folder / "14", folder / "86"], skeleton=folder / "86/86.asf", clips=clips
        )
        labels = (*read_labels(SHARED / "data/labels/mocap6"), *read_labels(SHARED / "data/labels/cmu86"))
        found["CMU"] = Dataset(dataset.name, dataset.clips, labels, dataset.report, dataset.fingerprint)
    return found


def key_postures(postures: Postures, instance: Label) -> np.ndarray:
    """Three postures ``(3, d)`` of an instance, at equal shares of the way its joints travel, as on a filmstrip."""
    clip = postures.clips.index(instance.clip)
    scale, first = postures.fps / postures.clip_fps[clip], int(postures.clip_starts[clip])
    low = first + round(instance.start * scale)
    inside = postures.vectors[low : max(first + round(instance.end * scale), low + 2)]
    way = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(inside, axis=0), axis=1))])
    return inside[[int(np.searchsorted(way, share * way[-1])) for share in MOMENTS]]


def icon_keys(motion_map: MotionMap, wanted: np.ndarray) -> list[tuple[int, int]]:
    """The icons nearest to postures ``(n, d)``, one after the other; one icon once in a row."""
    icons = motion_map.icons
    models = motion_map.weights[icons[:, 0], icons[:, 1]]
    keys: list[tuple[int, int]] = []
    for posture in wanted:
        x, y = icons[np.argmin(np.linalg.norm(models - posture, axis=1))]
        if not keys or keys[-1] != (x, y):
            keys.append((int(x), int(y)))
    return keys


def found_with(motion_map: MotionMap, keys: list[tuple[int, int]], instance: Label) -> tuple[list[Segment], float]:
    """Hits beside the instance itself, and the T at which there are FIRST of them: it grows as a person would do it."""
    reach = 0.0
    while True:
        hits = [s for s, _ in motion_map.search(keys, reach) if overlap(s, instance) == 0]
        if len(hits) >= FIRST or reach > 3:
            return hits, reach
        reach += STEP


def overlap(segment: Segment, label: Label) -> int:
    """Frames that both share."""
    return max(0, min(segment.end, label.end) - max(segment.start, label.start)) if segment.clip == label.clip else 0


def rank_of(hits: list[Segment], labels: list[Label]) -> int:
    """Place, from 1, of the first hit that lies in the labels by INSIDE; 0 where none of the first FIRST does."""
    for k, hit in enumerate(hits[:FIRST]):
        if sum(overlap(hit, label) for label in labels) >= INSIDE * hit.n_frames:
            return k + 1
    return 0


def run_tasks(dataset: Dataset, actions: tuple[str, ...], seeds: int = SEEDS, **settings) -> dict[str, list[tuple]]:
    """Action -> per seed (rank of the first right hit or 0, T, number of keys, share of the first five that are right).

    Each seed gives another map, and another instance of the action to take postures from.
    """
    found: dict[str, list[tuple]] = {action: [] for action in actions}
    postures = postures_of(dataset)
    for seed in range(seeds):
        motion_map = build_motion_map(dataset, MapParameters(seed=seed, **settings))
        for action in actions:
            instances = [label for label in dataset.labels if label.action == action]
            query = instances[seed % len(instances)]
            others = [label for label in instances if label is not query]
            keys = icon_keys(motion_map, key_postures(postures, query))
            hits, reach = found_with(motion_map, keys, query)
            right = [rank_of([hit], others) for hit in hits[:FIRST]]
            found[action].append((rank_of(hits, others), reach, len(keys), float(np.mean(right)) if right else 0.0))
    return found


def successes(found: dict[str, list[tuple]]) -> list[int]:
    """Per seed the number of tasks whose right action is among the first five hits."""
    return [sum(rows[seed][0] > 0 for rows in found.values()) for seed in range(len(next(iter(found.values()))))]


def share_of_time(dataset: Dataset, action: str) -> float:
    """Of all frames, those with the label: how often a hit would be right by chance."""
    rates = {clip.name: clip.fps for clip in dataset.clips}
    return sum((la.end - la.start) / rates[la.clip] for la in dataset.labels if la.action == action) / dataset.seconds


def choice_rows(dataset: Dataset, n: int = 10) -> list[tuple[str, int, int, int]]:
    """Per clip (name, clips with a hit at T = 0, .2, .4 m) for its one most peculiar posture.

    The key is the node nearest to the clip's posture that lies farthest from the mean posture of the collection.
    """
    motion_map = build_motion_map(dataset, MapParameters())
    postures = postures_of(dataset)
    apart = np.linalg.norm(postures.vectors - postures.vectors.mean(axis=0), axis=1)
    rows = []
    for clip in np.linspace(0, len(postures.clips) - 1, min(n, len(postures.clips))).round().astype(int):
        low, high = postures.clip_starts[clip], postures.clip_starts[clip + 1]
        key, _ = motion_map.nearest(postures.vectors[low + int(apart[low:high].argmax())])
        counts = [len({s.clip for s, _ in motion_map.search([key], reach)}) for reach in (0.0, 0.2, 0.4)]
        rows.append((postures.clips[clip], *counts))
    return rows


def rows_of(name: str, dataset: Dataset, grid: str) -> tuple[list[str], str]:
    """Table rows of a collection on a grid, and its summary."""
    found, rows = run_tasks(dataset, TASKS[name], grid=grid), []
    for action, tries in found.items():
        ranks = [row[0] for row in tries]
        ok = sum(rank > 0 for rank in ranks)
        place = f"{np.median([rank for rank in ranks if rank]):g}" if ok else "-"
        right, reach = np.mean([row[3] for row in tries]), np.median([row[1] for row in tries])
        chance = share_of_time(dataset, action)
        rows.append(
            f"| {name} | {grid} | {action} | {ok} of {SEEDS} | {place} | {right:.2f} | {chance:.2f} | {reach:.2f} |"
        )
    counts = successes(found)
    return rows, f"{name}, {grid}: {np.median(counts):g} of {len(found)} (by seed {', '.join(map(str, counts))})"


def main() -> str:
    """Measure, print and return the Markdown section."""
    rows, summaries = [], []
    for name, dataset in collections().items():
        for grid in GRIDS:
            more, summary = rows_of(name, dataset, grid)
            rows += more
            summaries.append(summary)
    folder = asfamc()
    wide = open_dataset(folder, skeleton=folder / "86/86.asf") if folder else make_demo(minutes=6)
    choices = choice_rows(wide)
    lines = [
        "## Finding motion on the map",
        "",
        "Keys: the icons nearest to three postures (at a sixth, half and five sixths of the way the joints travel) "
        f"of one labelled instance; T grows by {STEP} m until there are {FIRST} hits outside that instance. Right: "
        f"{INSIDE:.0%} of a hit lies in another instance. {SEEDS} map seeds, each searched with another instance. "
        f"Tasks with the right action in the first {FIRST} hits, median over seeds: {'; '.join(summaries)}.",
        "",
        "| collection | grid | find | in the first five | median place | right of five | share of time | T, median |",
        "|---|---|---|---|---|---|---|---|",
        *rows,
        "",
        f"Choice: one key, the posture of a clip that is farthest from the mean posture, on 30 x 30 nodes; clips of "
        f"{len(wide.clips)} with a hit. `python -m benchmarks.bench_map_search`",
        "",
        "| clip | T = 0 | T = .2 m | T = .4 m |",
        "|---|---|---|---|",
        *(f"| {clip} | {a} | {b} | {c} |" for clip, a, b, c in choices),
    ]
    section = "\n".join(lines)
    print(section)
    return section


if __name__ == "__main__":
    main()
