"""A walk, or a comparison of two results, as commands and as Python (see webapp/shell/recipes.py)."""

from __future__ import annotations

import shlex
from pathlib import Path

from core import analyses
from core.analyses import Request
from webapp.shell.recipes import command, keyword_arguments


def walk_commands(workspace: Path, request: Request) -> str:
    """The motif graph, then the walk through it: two commands."""
    values = analyses.normalise(request).parameters
    names = {p.name for p in analyses.parameters("motifs")}
    graph = Request(request.dataset, "motifs", {name: values[name] for name in names})
    words = ["motionscape", "walk", f"{workspace}/{request.dataset}", "--from", "motifs.json", *_path(values["path"])]
    words += ["--further"] if values["further"] else []
    words += [] if values["keep_feet"] else ["--plain"]
    words += ["--gaps", values["gaps"], "--dead-end", values["dead_end"], "--out", "walk.bvh"]
    return f"{command(workspace, graph)}\n{shlex.join(words)}"


def compare_commands(workspace: Path, first: Request, second: Request) -> str:
    """Both motif graphs, then the comparison: three commands."""
    commands = [command(workspace, request, f"{name}.json") for name, request in (("a", first), ("b", second))]
    return "\n".join([*commands, "motionscape compare a.json b.json --out comparison.json"])


def compare_script(workspace: Path, first: Request, second: Request) -> str:
    """A Python script that finds both motif graphs and compares them."""
    lines = [
        "from core import MotifParameters, Workspace, find_motifs",
        "from core.motifs.compare import compare",
        "",
        f"dataset = Workspace({str(workspace)!r}).open({first.dataset!r})",
        *(
            f"{name} = find_motifs(dataset, MotifParameters({keyword_arguments(r)}))"
            for name, r in (("a", first), ("b", second))
        ),
        "result = compare(a, b)",
        "print([(fate.motif, fate.change, fate.partners) for fate in result.a])",
    ]
    return "\n".join(lines) + "\n"


def _path(text: str) -> list[str]:
    """The options that stand for a path as links have it (core/synthesis/paths.py)."""
    kind, *rest = text.split(":")
    if kind == "random":
        start = ["--start", rest[2]] if len(rest) > 2 else []
        return ["--random", "--seconds", rest[0], "--seed", rest[1], *start]
    if kind in ("fewest", "used"):
        return ["--start", rest[0], "--target", rest[1], "--by", kind]
    return ["--motifs", text.replace("-", ",")]
