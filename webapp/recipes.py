"""The same result again, elsewhere: a request as a command and as a Python script that give it exactly when run."""

from __future__ import annotations

import shlex
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from core import analyses

_CALLS = {  # method -> what to import, parameters' class, function
    "motifs": ("from core import MotifParameters, Workspace, find_motifs", "MotifParameters", "find_motifs"),
}


def both(workspace: Path, request: analyses.Request) -> dict[str, str]:
    """What the menus of a result offer to copy: label -> text."""
    return {"Copy as command": command(workspace, request), "Copy as Python": script(workspace, request)}


def command(workspace: Path, request: analyses.Request) -> str:
    """``motionscape METHOD SOURCE --options --out FILE``: options that stand at their defaults are left out."""
    words = ["motionscape", request.method, f"{workspace}/{request.dataset}"]
    for name, value in _not_default(request).items():
        words += [f"--{name.replace('_', '-')}", _text(value)]
    return shlex.join([*words, "--out", f"{request.method}.json"])


def script(workspace: Path, request: analyses.Request) -> str:
    """A Python script that computes the result. Raises KeyError for a method without a call of its own."""
    imports, parameters, function = _CALLS[request.method]
    given = ", ".join(f"{name}={value!r}" for name, value in _not_default(request).items())
    lines = [
        imports,
        "",
        f"dataset = Workspace({str(workspace)!r}).open({request.dataset!r})",
        f"result = {function}(dataset, {parameters}({given}))",
        "print(dict(result.metrics))",
    ]
    return "\n".join(lines) + "\n"


def _not_default(request: analyses.Request) -> Mapping[str, Any]:
    filled = analyses.normalise(request).parameters
    return {p.name: filled[p.name] for p in analyses.parameters(request.method) if filled[p.name] != p.default}


def _text(value: Any) -> str:
    return repr(value) if isinstance(value, float) else str(value)
