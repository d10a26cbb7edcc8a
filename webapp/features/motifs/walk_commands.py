"""``motionscape walk``: new motion along a path through a motif graph, as BVH."""

from __future__ import annotations

from argparse import Namespace
from collections.abc import Iterator

from core.mocap.bvh import write_bvh
from core.mocap.rigs import comparable, comparable_groups
from core.motifs.graph import dataset_head, from_json
from core.synthesis import Between, NoWay, Random, Walk, make_walk
from core.synthesis.kept_walks import walk_json
from core.synthesis.paths import MOST_SECONDS
from core.workspace import WorkspaceError
from webapp.cli.progress_bar import progress_bar
from webapp.cli.result_files import check_clips, check_made, made_lines, read_result, write_json
from webapp.cli.sources import open_source


def walk(arguments: Namespace) -> int:
    """Writes the walk that the arguments ask for. Raises WorkspaceError, ValueError or OSError in plain words."""
    path = _path(arguments)
    check_made(arguments.out, arguments.parts)
    graph = read_result(arguments.graph, "motifs", from_json)
    used = {segment.clip for motif in graph.motifs for segment in motif.segments}
    with progress_bar(arguments.quiet) as report:
        dataset = open_source(arguments, report)
        check_clips(arguments.graph, graph.clips, used, dataset, arguments.source)
        dataset = comparable(dataset.select(used)) if len(comparable_groups(dataset)) > 1 else dataset
        try:
            walk = make_walk(
                dataset,
                graph,
                path,
                further=arguments.further,
                gaps=arguments.gaps,
                dead_end=arguments.dead_end,
                keep_feet=not arguments.plain,
                name=arguments.out.stem,
                report=report,
            )
        except NoWay as error:
            ways = "--gaps detour, --gaps bridge" if error.detour else "--gaps bridge"
            raise WorkspaceError(f"{error} ({ways})") from error
    write_bvh(arguments.out, walk.clip)
    if arguments.parts:
        write_json(arguments.parts, {"dataset": dataset_head(dataset), **walk_json(walk)})
    if not arguments.quiet:
        print("\n".join(_summary(walk, arguments)))
    return 0


def _path(arguments: Namespace) -> tuple[int, ...] | Between | Random:
    """What ``--motifs``, ``--start`` with ``--target``, or ``--random`` ask for."""
    ways = [arguments.motifs is not None, arguments.target is not None, arguments.random]
    if sum(ways) != 1:
        raise WorkspaceError("Say which way to go by one of --motifs 3,7,9, --start 3 --target 9, or --random.")
    if arguments.motifs is not None:
        return tuple(arguments.motifs)
    if arguments.random:
        if not 0 < arguments.seconds <= MOST_SECONDS:
            raise WorkspaceError(f"--seconds: more than 0 and at most {MOST_SECONDS:g}, not {arguments.seconds:g}.")
        return Random(arguments.seconds, arguments.seed, arguments.start)
    if arguments.start is None:
        raise WorkspaceError("--target needs --start as well.")
    return Between(arguments.start, arguments.target, arguments.by)


def _summary(walk: Walk, arguments: Namespace) -> Iterator[str]:
    yield from (f"note: {warning}" for warning in walk.warnings)
    shown = " ".join(map(str, walk.path[:40])) + (" ..." if len(walk.path) > 40 else "")
    yield f"{len(walk.path)} motifs: {shown}"
    yield from made_lines(walk, arguments.out, arguments.parts)
