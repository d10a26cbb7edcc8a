"""``motionscape walk``: new motion along a path through a motif graph, as BVH."""

from __future__ import annotations

from argparse import Namespace
from collections.abc import Iterator

from core.mocap.bvh import write_bvh
from core.motifs.graph import dataset_head, from_json
from core.synthesis import Between, NoWay, Random, Walk, make_walk
from core.synthesis.kept_walks import walk_json
from core.synthesis.paths import MOST_SECONDS
from core.workspace import WorkspaceError
from webapp.cli.progress_bar import progress_bar
from webapp.cli.result_files import check_clips, check_made, made_lines, read_result, write_json
from webapp.cli.sources import open_source


def walk(asked: Namespace) -> int:
    """Writes the walk that the arguments ask for. Raises WorkspaceError, ValueError or OSError in plain words."""
    path = _path(asked)
    check_made(asked.out, asked.parts)
    graph = read_result(asked.graph, "motifs", from_json)
    used = {segment.clip for motif in graph.motifs for segment in motif.segments}
    with progress_bar(asked.quiet) as report:
        dataset = open_source(asked, report)
        check_clips(asked.graph, graph.clips, used, dataset, asked.source)
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
    yield from made_lines(made, asked.out, asked.parts)
