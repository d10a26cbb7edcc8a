"""A new routine as the commands that make it again (see webapp/shell/recipes.py)."""

from __future__ import annotations

import shlex
from pathlib import Path

from core import analyses
from core.analyses import Request
from webapp.shell.recipes import command


def derive_commands(workspace: Path, request: Request) -> str:
    """The grammar, then the routine: two commands."""
    values = analyses.normalise(request).parameters
    names = {p.name for p in analyses.parameters("grammar")}
    grammar = Request(request.dataset, "grammar", {name: values[name] for name in names})
    words = ["motionscape", "derive", f"{workspace}/{request.dataset}", "--from", "grammar.json"]
    words += ["--sentence", values["sentence"], "--seed", str(values["seed"])]
    words += [*([] if values["keep_feet"] else ["--plain"]), "--out", "routine.bvh"]
    return f"{command(workspace, grammar)}\n{shlex.join(words)}"
