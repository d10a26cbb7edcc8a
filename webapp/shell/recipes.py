"""Recipes that reproduce a result: its request as a command and as a Python script."""

from __future__ import annotations

import shlex
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from core import analyses
from core.analyses import Request
from webapp.shell.feature import features


def texts(workspace: Path, request: Request) -> dict[str, str]:
    """What the menus of a result offer to copy: label -> text; the command only where a feature gives one."""
    texts = {"Copy as Python": script(workspace, request)}
    recipe = next((f.recipes[request.method] for f in features() if request.method in f.recipes), None)
    if recipe is None:
        return texts
    commands = recipe(workspace, request)
    return {"Copy as commands" if "\n" in commands else "Copy as command": commands, **texts}


def command(workspace: Path, request: Request, out: str = "") -> str:
    """``motionscape METHOD SOURCE --options --out FILE``: options that stand at their defaults are left out."""
    words = ["motionscape", request.method, f"{workspace}/{request.dataset}"]
    for name, value in _not_default(request).items():
        words += [f"--{name.replace('_', '-')}", _text(value)]
    return shlex.join([*words, "--out", out or f"{request.method}.json"])


def script(workspace: Path, request: Request) -> str:
    """A Python script that gives the result, computed where it is not kept."""
    options = keyword_arguments(request)
    if request.method == "motifs":
        lines = [
            "from core import MotifParameters, Workspace, find_motifs",
            "",
            f"dataset = Workspace({str(workspace)!r}).open({request.dataset!r})",
            f"result = find_motifs(dataset, MotifParameters({options}))",
            "print(dict(result.metrics))",
        ]
    else:
        lines = [
            "from core import Workspace",
            "from core.analyses import Request, run",
            "",
            f"workspace = Workspace({str(workspace)!r})",
            f"request = Request({request.dataset!r}, {request.method!r}, dict({options}))",
            "result = run(workspace, request)",
            "print(result)",
        ]
    return "\n".join(lines) + "\n"


def _not_default(request: Request) -> Mapping[str, Any]:
    filled = analyses.normalise(request).parameters
    return {p.name: filled[p.name] for p in analyses.parameters(request.method) if filled[p.name] != p.default}


def keyword_arguments(request: Request) -> str:
    """The parameters of a request that are not at their defaults, as Python's keyword arguments."""
    return ", ".join(f"{name}={value!r}" for name, value in _not_default(request).items())


def _text(value: Any) -> str:
    return repr(value) if isinstance(value, float) else str(value)
