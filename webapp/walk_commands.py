"""``motionscape walk``: new motion along a path through a motif graph, as BVH."""

from __future__ import annotations

import json
from argparse import Namespace
from collections.abc import Iterator
from pathlib import Path

from core.mocap.bvh import write_bvh
from core.mocap.dataset import Dataset
from core.motifs.graph import MotifGraph, dataset_head, from_json
from core.synthesis import Between, NoWay, Random, Walk, make_walk
from core.synthesis.kept import walk_json
from core.synthesis.paths import MOST_SECONDS
from core.workspace import WorkspaceError
from webapp.commands import write_json
from webapp.progress_bar import progress_bar
from webapp.sources import open_source


def walk(asked: Namespace) -> int:
    """Writes the walk that the arguments ask for. Raises WorkspaceError, ValueError or OSError in plain words."""
    path = _path(asked)
    if asked.out.suffix.lower() != ".bvh":
        raise WorkspaceError(f"{asked.out}: --out names a BVH file, such as walk.bvh.")
    graph = read_graph(asked.graph)
    with progress_bar(asked.quiet) as report:
        dataset = open_source(asked, report)
        check_clips(dataset, graph, asked)
        try:
            made = make_walk(
                dataset,
                graph,
                path,
                further=asked.further,
                gaps=asked.gaps,
                dead_end=asked.dead_end,
                keep_feet=not asked.plain,
                name=asked.out.stem,
                report=report,
            )
        except NoWay as error:
            ways = "--gaps detour, --gaps bridge" if error.detour else "--gaps bridge"
            raise WorkspaceError(f"{error} ({ways})") from error
    write_bvh(asked.out, made.clip)
    if asked.parts:
        write_json(asked.parts, {"dataset": dataset_head(dataset), **walk_json(made)})
    if not asked.quiet:
        print("\n".join(_summary(made, asked)))
    return 0


def read_graph(path: Path) -> MotifGraph:
    """The motif graph in a file of ``motionscape motifs``. Raises WorkspaceError for another file, OSError."""
    try:
        return from_json(json.loads(path.read_text(encoding="utf-8")))
    except (ValueError, RecursionError) as error:
        raise WorkspaceError(f"{path}: not a file that “motionscape motifs” wrote ({error})") from error


def check_clips(dataset: Dataset, graph: MotifGraph, asked: Namespace) -> None:
    """Raises WorkspaceError where the graph was not found in these recordings."""
    have = {clip.name: clip.n_frames for clip in dataset.clips}
    for name, frames, _ in graph.clips:
        if have.get(name, frames) != frames:
            raise WorkspaceError(
                f"{asked.graph} was made from other recordings: “{name}” has {have[name]} frames here, {frames} there."
            )
    used = {segment.clip for motif in graph.motifs for segment in motif.segments}
    missing = sorted(used - set(have))
    if missing:
        others = f" and {len(missing) - 1} more" if len(missing) > 1 else ""
        raise WorkspaceError(
            f"{asked.graph} names the clip “{missing[0]}”{others}, which {asked.source} does not have."
        )


def _path(asked: Namespace) -> tuple[int, ...] | Between | Random:
    """What ``--motifs``, ``--start`` with ``--target``, or ``--random`` ask for."""
    ways = [asked.motifs is not None, asked.target is not None, asked.random]
    if sum(ways) != 1:
        raise WorkspaceError("Say which way to go by one of --motifs 3,7,9, --start 3 --target 9, or --random.")
    if asked.motifs is not None:
        return tuple(asked.motifs)
    if asked.random:
        if not 0 < asked.seconds <= MOST_SECONDS:
            raise WorkspaceError(f"--seconds: more than 0 and at most {MOST_SECONDS:g}, not {asked.seconds:g}.")
        return Random(asked.seconds, asked.seed, asked.start)
    if asked.start is None:
        raise WorkspaceError("--target needs --start as well.")
    return Between(asked.start, asked.target, asked.by)


def _summary(made: Walk, asked: Namespace) -> Iterator[str]:
    yield from (f"note: {warning}" for warning in made.warnings)
    shown = " ".join(map(str, made.path[:40])) + (" ..." if len(made.path) > 40 else "")
    yield f"{len(made.path)} motifs: {shown}"
    yield f"{made.clip.seconds:.1f} s, {made.clip.n_frames} frames, {len(made.seams)} blends"
    skate, speeds = made.skate, made.speeds
    yield (
        f"foot skate, m per second of contact: {skate.kept:.3f} (blending alone {skate.plain:.3f}, "
        f"recordings {skate.source:.3f})"
    )
    yield f"fastest joint, m/s: {speeds.seams:.2f} in the blends, {speeds.sources:.2f} in the recordings"
    yield f"written to {asked.out}" + (f" and {asked.parts}" if asked.parts else "")
