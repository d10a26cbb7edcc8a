"""Search by words, without any names or labels: does a text find the clips whose names say the same?

usage: python -m benchmarks words
"""

from __future__ import annotations

import csv
import re
import time
from collections.abc import Iterable
from dataclasses import dataclass, replace

import numpy as np

from benchmarks.labelled import Collection, bandai_namco, demo_cuts
from benchmarks.recordings import SHARED
from core.evaluation.ranking import ClipLabels
from core.mocap.clip import Clip, Segment
from core.mocap.dataset import Dataset, open_dataset
from core.retrieval.words.search import WordSearch
from core.retrieval.words.texts import Written, alike

FIRST = 10
LOOKED_AT = ("bandai_namco_2_part", "demo", "CMU", "UTKinect")
"""Collections that the words' thresholds were tried on."""


@dataclass(frozen=True)
class Found:
    """Of a query: clips that it means, P@10 (of at most as many as there are), mAP; and those of BM25's like."""

    query: str
    relevant: int
    precision: float
    mean: float
    chance: float
    shuffled: float


def cmu() -> Collection | None:
    """The CMU recordings; a clip's content is its category, as it is searched for."""
    folder = SHARED / "data" / "cmu"
    if not folder.is_dir():
        return None
    says = {"climb/playground": "climb", "basketball/dribble": "dribble", "swordplay": "swordplay"}
    with (folder / "index.csv").open(newline="") as file:
        content = {row["clip"]: says.get(row["category"], row["category"]) for row in csv.DictReader(file)}
    parts = [
        open_dataset(folder / "bvh"),
        open_dataset(folder / "asfamc", skeleton=folder / "asfamc" / "86" / "86.asf"),
    ]
    clips = tuple(clip for part in parts for clip in part.clips if clip.name in content)
    return Dataset("cmu", clips), ClipLabels(content, dict.fromkeys(content, ""))


def utkinect() -> Collection | None:
    """The ten actions of UTKinect, cut out of the recordings of points."""
    folder = SHARED / "data" / "utkinect"
    if not folder.is_dir():
        return None
    clips: list[Clip] = []
    content: dict[str, str] = {}
    dataset = open_dataset(folder)
    recording = ""
    for line in (folder / "actionLabel.txt").read_text().splitlines():
        if re.fullmatch(r"s\d+_e\d+", line.strip()):
            recording = f"joints_{line.strip()}"
        match = re.match(r"(\w+): (\d+) (\d+)", line)
        if match and recording in dataset.names:
            numbers = np.loadtxt(folder / f"{recording}.txt", usecols=0)
            start, end = int(match[2]) - int(numbers[0]), int(match[3]) - int(numbers[0])
            clip = dataset.clip(recording)
            start, end = max(0, start), min(end, clip.n_frames)
            if end - start > 5:
                clips.append(clip.cut(start, end, f"{recording}_{match[1]}"))
                content[clips[-1].name] = match[1]
    return Dataset("utkinect", tuple(clips)), ClipLabels(content, dict.fromkeys(content, ""))


COLLECTIONS = {
    "bandai_namco_1": lambda: bandai_namco("bandai_namco_1"),
    "bandai_namco_2_part": lambda: bandai_namco("bandai_namco_2_part"),
    "CMU": cmu,
    "UTKinect": utkinect,
    "demo": demo_cuts,
}


def measures(order: Iterable[str], relevant: set[str]) -> tuple[float, float]:
    """P@10, of at most as many as there are, and average precision of clips in an order."""
    right = np.array([name in relevant for name in order])
    first = min(FIRST, len(relevant))
    precisions = (np.cumsum(right) / np.arange(1, len(right) + 1))[right]
    return float(right[:first].mean()), float(precisions.sum() / len(relevant))


def shuffled(query: str, content: dict[str, str], seed: int = 0) -> float:
    """P@10 of search in names that belong to other clips."""
    names = sorted(content)
    others = np.random.default_rng(seed).permutation(names)
    written = [Written(Segment(n, 0, 1), content[other], True) for n, other in zip(names, others, strict=True)]
    order = [names[k] for k in np.argsort(-alike(query, written), kind="stable")]
    return measures(order, {n for n in names if content[n] == query})[0]


def found_in(collection: Collection, least: int = 2) -> list[Found]:
    """Each content with ``least`` clips or more as a query, as it stands in the names."""
    dataset, labels = collection
    dataset = replace(dataset, labels=())
    names = {f"clip{k:04d}": clip.name for k, clip in enumerate(dataset.clips)}
    unnamed = Dataset("unnamed", tuple(replace(c, name=n) for n, c in zip(names, dataset.clips, strict=True)))
    words = WordSearch(unnamed, names=False)
    content = {name: labels.content[old] for name, old in names.items()}
    rows = []
    for query in sorted(set(content.values())):
        relevant = {name for name, own in content.items() if own == query}
        if len(relevant) >= least:
            hits = words.search(query).hits or ()
            order = [hit.segment.clip for hit in hits] or sorted(content)
            share = len(relevant) / len(content)
            rows.append(Found(query, len(relevant), *measures(order, relevant), share, shuffled(query, content)))
    return rows


def main() -> str:
    """The Markdown section, also printed."""
    rows, means, started = [], [], time.process_time()
    for name, make in COLLECTIONS.items():
        collection = make()
        if collection is None:
            continue
        found = found_in(collection)
        mark = ", looked at" if name in LOOKED_AT else ""
        rows += [
            f"| {name}{mark} | {f.query} | {f.relevant} | {f.precision:.2f} | {f.mean:.2f} | {f.chance:.2f} "
            f"| {f.shuffled:.2f} |"
            for f in found
        ]
        mean = np.mean([(f.precision, f.mean, f.chance, f.shuffled) for f in found], axis=0)
        means.append(f"| {name}{mark} | {len(found)} | " + " | ".join(f"{value:.2f}" for value in mean) + " |")
    head = "P@10 | mAP | chance | shuffled names |"
    text = "\n".join(
        [
            "## Search: words",
            "",
            "Contents of clips as queries, as they stand in names and descriptions, without names or labels being "
            "known to the search. P@10 is of at most as many clips as there are. Chance is the share of such clips; "
            "shuffled: the search in names (tf-idf) with the names of other clips. Thresholds were tried on the "
            f"collections that were looked at; {time.process_time() - started:.0f} s of processor time. "
            "`python -m benchmarks words`",
            "",
            f"| collection | queries | {head}",
            "|---|---|---|---|---|---|",
            *means,
            "",
            f"| collection | query | clips | {head}",
            "|---|---|---|---|---|---|---|",
            *rows,
        ]
    )
    print(text)
    return text


if __name__ == "__main__":
    main()
