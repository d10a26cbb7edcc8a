"""The house rules: who may import whom, how long a file may be, and that the docstring check bites."""

from __future__ import annotations

import ast
import re
import subprocess
import sys
from pathlib import Path, PurePosixPath

import pytest

from scripts.check_docstrings import findings

REPOSITORY = Path(__file__).resolve().parents[1]
SOURCES = [
    path
    for folder in ("core", "webapp", "assets", "scripts", "benchmarks")
    for path in sorted((REPOSITORY / folder).rglob("*"))
    if not {"node_modules", "bundle"} & set(path.parts)
]


def test_core_does_not_load_the_app_or_its_libraries():
    code = (
        "import pkgutil, sys, core\n"
        "for m in pkgutil.walk_packages(core.__path__, 'core.'): __import__(m.name)\n"
        "print([m for m in ('dash', 'plotly', 'flask', 'webapp', 'dash_cytoscape') if m in sys.modules])"
    )
    out = subprocess.run([sys.executable, "-c", code], cwd=REPOSITORY, capture_output=True, text=True, check=True)
    assert out.stdout.strip() == "[]"


def imports_of(path: Path, names: dict[str, Path]) -> set[str]:
    """The modules of ours that a module imports when it is loaded or for its types, by dotted name."""
    found: set[str] = set()
    bodies = [ast.parse(path.read_text(encoding="utf-8")).body]
    for body in bodies:
        for node in body:
            if isinstance(node, ast.ImportFrom) and node.module:
                parts = [f"{node.module}.{one.name}" for one in node.names]
                found.update(part if part in names else node.module for part in parts)
            elif isinstance(node, ast.If | ast.Try):  # such as `if TYPE_CHECKING`
                bodies.append(node.body)
    return found & names.keys()


def test_no_modules_import_one_another():
    """Not for types either: of two modules one is the lower."""
    python = [path for path in SOURCES if path.suffix == ".py" and path.is_relative_to(REPOSITORY)]
    names = {
        ".".join(path.relative_to(REPOSITORY).with_suffix("").parts).removesuffix(".__init__"): path for path in python
    }
    graph = {name: imports_of(path, names) - {name} for name, path in names.items()}
    while free := [name for name, lower in graph.items() if not lower & graph.keys()]:
        graph = {name: lower for name, lower in graph.items() if name not in free}
    while free := graph.keys() - set().union(*graph.values()):  # they only lie above a circle
        graph = {name: lower for name, lower in graph.items() if name not in free}
    assert sorted(graph) == []


@pytest.mark.parametrize("path", [p for p in SOURCES if p.suffix in {".py", ".mjs", ".css"}], ids=lambda p: p.name)
def test_files_stay_readable(path):
    assert len(path.read_text(encoding="utf-8").splitlines()) <= 420


ROOMS = {  # a word of a file's name that speaks of a page -> the folders such a file may lie in
    "library": {"library"},
    "motif": {"motifs"},
    "motifs": {"motifs"},
    "sweep": {"sweeps", "motifs"},  # core computes sweeps where it computes motifs
    "sweeps": {"sweeps", "motifs"},
    "map": {"motion_map"},
    "search": {"search", "retrieval"},
    "grammar": {"grammar"},
}


def test_files_that_speak_of_a_page_lie_in_its_folder():
    listed = subprocess.run(
        ["git", "ls-files", "webapp", "assets", "core", "tests"],
        cwd=REPOSITORY, capture_output=True, text=True, check=True,
    ).stdout.split()  # fmt: skip
    paths = [PurePosixPath(name) for name in listed]
    assert len(paths) > 500
    lost = [
        str(path)
        for path in paths
        for word in re.split(r"[^a-z]+", path.name.lower())
        if word in ROOMS and not ROOMS[word] & set(path.parts[:-1])
    ]
    assert lost == []


def test_the_docstring_check_finds_what_is_missing(tmp_path):
    bad = tmp_path / "bad.py"
    bad.write_text(
        '"""A module."""\nimport numpy as np\n\n'
        'def area(x: np.ndarray) -> float:\n    """The area."""\n    return x.sum()\n\n'
        'def fail():\n    """Does nothing good."""\n    raise ValueError("no")\n\ndef silent():\n    pass\n'
    )
    found = list(findings(bad))
    assert len(found) == 3
    assert "no shape" in found[0] and "raises" in found[1] and "no docstring" in found[2]
