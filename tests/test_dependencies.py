"""pyproject.toml declares exactly the libraries that the code imports, and the files in requirements/ fit it."""

from __future__ import annotations

import ast
import re
import sys
import tomllib
from collections.abc import Iterable
from importlib.metadata import packages_distributions
from pathlib import Path

import pytest
from packaging.requirements import Requirement

ROOT = Path(__file__).resolve().parents[1]
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
OWN = {"core", "webapp", "tests", "scripts", "benchmarks"}
LOCKED = {"run": (), "dev": ("dev",), "bench": ("dev", "bench")}  # file in requirements/ -> extras in it


def declared(requirements: Iterable[str]) -> set[str]:
    """Names of distributions, as PyPI writes them in lower case with hyphens."""
    return {normal(re.match(r"[\w.-]+", requirement)[0]) for requirement in requirements}


def normal(name: str) -> str:
    return re.sub(r"[-_.]+", "-", name).lower()


def imported_modules(package: str) -> set[str]:
    """First part of the name of every module that the files of a package import, without Python's own and ours."""
    names = set()
    for path in (ROOT / package).rglob("*.py"):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Import):
                names |= {alias.name.partition(".")[0] for alias in node.names}
            elif isinstance(node, ast.ImportFrom) and node.level == 0:
                names.add(node.module.partition(".")[0])
    return names - set(sys.stdlib_module_names) - OWN


@pytest.fixture(scope="module")
def imported() -> set[str]:
    """Names of the distributions that core and webapp import."""
    owners = packages_distributions()
    modules = imported_modules("core") | imported_modules("webapp")
    return {normal(name) for module in modules for name in owners.get(module, [module])}


def test_every_import_is_declared(imported):
    optional = declared(PROJECT["optional-dependencies"]["celery"])
    assert imported - optional - declared(PROJECT["dependencies"]) == set()


def test_nothing_is_declared_that_is_not_imported(imported):
    assert declared(PROJECT["dependencies"]) - imported == set()


def test_every_direct_dependency_has_a_lower_bound():
    groups = [PROJECT["dependencies"], *PROJECT["optional-dependencies"].values()]
    assert [text for group in groups for text in group if ">=" not in text] == []


def locked_versions(name: str) -> dict[str, str]:
    """Version of each distribution in one of the files in requirements/."""
    text = (ROOT / "requirements" / f"{name}.txt").read_text(encoding="utf-8")
    return {normal(found[1]): found[2] for found in re.finditer(r"^([\w.-]+)==([^ ;]+)", text, re.MULTILINE)}


@pytest.mark.parametrize("name", LOCKED)
def test_locked_versions_are_those_that_the_project_allows(name):
    versions = locked_versions(name)
    wanted = [*PROJECT["dependencies"], *(r for extra in LOCKED[name] for r in PROJECT["optional-dependencies"][extra])]
    for requirement in map(Requirement, wanted):
        locked = versions.get(normal(requirement.name))
        assert locked is not None, f"{requirement.name} is not in requirements/{name}.txt: run make lock"
        assert requirement.specifier.contains(locked), f"{requirement} but {locked} is locked: run make lock"


def test_the_locks_agree():
    run, dev, bench = (locked_versions(name) for name in LOCKED)
    assert run.items() <= dev.items() <= bench.items()


@pytest.mark.parametrize("name", LOCKED)
def test_locks_name_no_registry(name):
    assert "://" not in (ROOT / "requirements" / f"{name}.txt").read_text(encoding="utf-8")
