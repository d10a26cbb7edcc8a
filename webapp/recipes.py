"""The same result again, elsewhere: a request as a command and as a Python script that give it exactly when run."""

from __future__ import annotations

import shlex
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from core import analyses
from core.analyses import Request

_COMMANDS = ("motifs", "stability", "map", "grammar")  # those whose options are the parameters of the method


def both(workspace: Path, request: Request) -> dict[str, str]:
    """What the menus of a result offer to copy: label -> text; the command only where there is one."""
    made = {"Copy as Python": script(workspace, request)}
    if request.method in _COMMANDS:
        return {"Copy as command": command(workspace, request), **made}
    two = {"walk": walk_commands, "derive": derive_commands}.get(request.method)
    return {"Copy as commands": two(workspace, request), **made} if two else made


def command(workspace: Path, request: Request, out: str = "") -> str:
    """``motionscape METHOD SOURCE --options --out FILE``: options that stand at their defaults are left out."""
    words = ["motionscape", request.method, f"{workspace}/{request.dataset}"]
    for name, value in _not_default(request).items():
        words += [f"--{name.replace('_', '-')}", _text(value)]
    return shlex.join([*words, "--out", out or f"{request.method}.json"])


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


def derive_commands(workspace: Path, request: Request) -> str:
    """The grammar, then the routine: two commands."""
    values = analyses.normalise(request).parameters
    names = {p.name for p in analyses.parameters("grammar")}
    grammar = Request(request.dataset, "grammar", {name: values[name] for name in names})
    words = ["motionscape", "derive", f"{workspace}/{request.dataset}", "--from", "grammar.json"]
    words += ["--sentence", values["sentence"], "--seed", str(values["seed"])]
    words += [*([] if values["keep_feet"] else ["--plain"]), "--out", "routine.bvh"]
    return f"{command(workspace, grammar)}\n{shlex.join(words)}"


def compare_commands(workspace: Path, first: Request, second: Request) -> str:
    """Both motif graphs, then the comparison: three commands."""
    made = [command(workspace, request, f"{name}.json") for name, request in (("a", first), ("b", second))]
    return "\n".join([*made, "motionscape compare a.json b.json --out comparison.json"])


def compare_script(workspace: Path, first: Request, second: Request) -> str:
    """A Python script that finds both motif graphs and compares them."""
    lines = [
        "from core import MotifParameters, Workspace, find_motifs",
        "from core.motifs.compare import compare",
        "",
        f"dataset = Workspace({str(workspace)!r}).open({first.dataset!r})",
        *(f"{name} = find_motifs(dataset, MotifParameters({_given(r)}))" for name, r in (("a", first), ("b", second))),
        "result = compare(a, b)",
        "print([(fate.motif, fate.change, fate.partners) for fate in result.a])",
    ]
    return "\n".join(lines) + "\n"


def script(workspace: Path, request: Request) -> str:
    """A Python script that gives the result, computed where it is not kept."""
    given = _given(request)
    if request.method == "motifs":
        lines = [
            "from core import MotifParameters, Workspace, find_motifs",
            "",
            f"dataset = Workspace({str(workspace)!r}).open({request.dataset!r})",
            f"result = find_motifs(dataset, MotifParameters({given}))",
            "print(dict(result.metrics))",
        ]
    else:
        lines = [
            "from core import Workspace",
            "from core.analyses import Request, run",
            "",
            f"workspace = Workspace({str(workspace)!r})",
            f"request = Request({request.dataset!r}, {request.method!r}, dict({given}))",
            "result = run(workspace, request)",
            "print(result)",
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


def _not_default(request: Request) -> Mapping[str, Any]:
    filled = analyses.normalise(request).parameters
    return {p.name: filled[p.name] for p in analyses.parameters(request.method) if filled[p.name] != p.default}


def _given(request: Request) -> str:
    return ", ".join(f"{name}={value!r}" for name, value in _not_default(request).items())


def _text(value: Any) -> str:
    return repr(value) if isinstance(value, float) else str(value)
