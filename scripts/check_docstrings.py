"""Public functions of a package must say shapes, units and errors where they have any.

usage: check_docstrings.py PACKAGE_FOLDER...

Rules: every public module, class and function has a docstring; one that takes or returns a numpy array names a shape
(something like ``(n_frames, 3)``) in it or in its class or module; one that raises by itself says so ("Raises",
"Error"). Exit 1 lists what is missing, a line for each finding.
"""

from __future__ import annotations

import ast
import re
import sys
from collections.abc import Iterator
from pathlib import Path

SHAPE = re.compile(r"\(\s*(\.\.\.|[\w* +-]+,|n_\w+|n|m|k)[^)]*\)|scalar")
ERROR = re.compile(r"[Rr]aise|Error|refus")
Function = ast.FunctionDef | ast.AsyncFunctionDef


def findings(path: Path) -> Iterator[str]:
    """A line for each rule broken in the file at ``path``."""
    tree = ast.parse(path.read_text(encoding="utf-8"))
    module = ast.get_docstring(tree) or ""
    if not module:
        yield f"{path}:1: module has no docstring"
    for node in tree.body:
        if isinstance(node, ast.ClassDef) and not node.name.startswith("_"):
            outer = ast.get_docstring(node) or ""
            if not outer:
                yield f"{path}:{node.lineno}: class {node.name} has no docstring"
            for item in node.body:
                if isinstance(item, Function):
                    yield from _function(path, item, outer + module)
        elif isinstance(node, Function):
            yield from _function(path, node, module)


def _function(path: Path, node: Function, context: str) -> Iterator[str]:
    if node.name.startswith("_"):
        return
    where, text = f"{path}:{node.lineno}: {node.name}", ast.get_docstring(node) or ""
    if not text:
        yield f"{where} has no docstring"
        return
    notes = [a.annotation for a in [*node.args.args, *node.args.kwonlyargs] if a.annotation] + [
        node.returns or ast.Constant(None)
    ]
    if any("ndarray" in ast.unparse(n) for n in notes) and not SHAPE.search(text + context):
        yield f"{where} handles arrays but its docstring gives no shape"
    if any(isinstance(n, ast.Raise) and n.exc for n in ast.walk(node)) and not ERROR.search(text + context):
        yield f"{where} raises but its docstring does not say what"


def main(folders: list[str]) -> int:
    """Check every module below the folders; the exit code."""
    found = [line for folder in folders for path in sorted(Path(folder).rglob("*.py")) for line in findings(path)]
    print("\n".join(found) if found else "docstrings: ok")
    return bool(found)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
