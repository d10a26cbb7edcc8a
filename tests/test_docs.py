"""What the documentation shows exists: commands, settings, environment variables, files and Python examples.

Links, navigation and the names of the API reference are checked when the site is built (scripts/build_docs.py).
A block marked ``python`` is run as it stands, in a folder with small recordings; one marked ``py`` is not.
"""

from __future__ import annotations

import importlib.util
import re
import shlex
import sys
from collections.abc import Iterator
from dataclasses import fields
from pathlib import Path
from types import ModuleType
from typing import NamedTuple

import pytest

from core import Workspace, open_dataset
from core.analyses import METHODS, parameters
from core.demo import write_demo
from core.errors import ParameterError
from webapp.app import create_app
from webapp.cli.main import _parser
from webapp.shell.feature import Feature, features, unregister

ROOT = Path(__file__).resolve().parents[1]
PAGES = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted((ROOT / "docs").rglob("*.md"))]
CODE = ("core", "webapp", "scripts", "benchmarks", "assets", "tests", "Makefile")
BLOCK = re.compile(r"^( *)```(\w+)\n(.*?)^\1```", re.MULTILINE | re.DOTALL)
VARIABLE = re.compile(r"MOTIONSCAPE_[A-Z_]+")
FOLDERS = r"core|webapp|assets|tests|scripts|docs|benchmarks|requirements|\.github"
FILE = re.compile(rf"(?<![\w/.$-])((?:{FOLDERS})/[\w./*-]+)")
PLACEHOLDER = re.compile(r"[A-Z]{3,}|/tempo\b")  # webapp/features/PAGE, and the made-up example of docs/extend
VALUE = re.compile(r"`([a-z_]+) ?= ?([\w.-]+)`")


class Block(NamedTuple):
    """A block of code of a page."""

    page: Path
    language: str
    text: str

    def __str__(self) -> str:
        return f"{self.page.relative_to(ROOT)}:{self.text.split(chr(10), 1)[0][:50]}"


def blocks(language: str) -> Iterator[Block]:
    """All blocks of a language."""
    for page in PAGES:
        for _, name, text in BLOCK.findall(page.read_text(encoding="utf-8")):
            if name == language:
                yield Block(page, name, text)


def commands(block: Block) -> Iterator[list[str]]:
    """The command lines of a block as words; variables that the block sets are replaced by their values."""
    variables: dict[str, str] = {}
    for line in block.text.replace("\\\n", " ").splitlines():
        if setting := re.fullmatch(r'(\w+)="(.*)"', line):
            variables[setting[1]] = setting[2]
            continue
        line = re.sub(r"\$(\w+)", lambda match: variables.get(match[1], match[0]), line)
        words = shlex.split(line, comments=True)
        while words and re.fullmatch(r"[A-Z_]+=.*", words[0]):
            words.pop(0)
        if words:
            yield words


SHELL = [(block, words) for block in blocks("sh") for words in commands(block)]


@pytest.mark.parametrize(
    "words", [words[1:] for _, words in SHELL if words[0] == "motionscape"], ids=lambda words: " ".join(words)[:80]
)
def test_commands_can_be_parsed(words):
    if words == ["--help"]:
        return
    _parser(words).parse_args(words)  # ends the process where it refuses


def test_make_targets_exist():
    targets = re.findall(r"^([a-z-]+):", (ROOT / "Makefile").read_text(encoding="utf-8"), re.MULTILINE)
    shown = {word for _, words in SHELL if words[0] == "make" for word in words[1:] if "=" not in word}
    inline = re.findall(r"`make ([a-z-]+)", "".join(page.read_text(encoding="utf-8") for page in PAGES))
    assert (shown | set(inline)) - set(targets) == set()


def test_benchmarks_and_scripts_exist():
    text = "".join(page.read_text(encoding="utf-8") for page in PAGES)
    modules = set(re.findall(r"python -m ((?:benchmarks|scripts)\.\w+)", text))
    modules |= {f"benchmarks.bench_{name}" for name in re.findall(r"python -m benchmarks ([a-z_]+)", text)}
    assert {name for name in modules if importlib.util.find_spec(name) is None} == set()


def test_environment_variables_are_documented_and_exist():
    used = set()
    for place in CODE:
        files = (ROOT / place).rglob("*") if (ROOT / place).is_dir() else [ROOT / place]
        for file in files:
            if file.suffix in (".py", ".sh", ".mjs", "") and file.is_file() and "node_modules" not in file.parts:
                used |= set(VARIABLE.findall(file.read_text(encoding="utf-8")))
    table = (ROOT / "docs" / "reference" / "commands.md").read_text(encoding="utf-8")
    assert set(re.findall(rf"^\| `({VARIABLE.pattern})` \|", table, re.MULTILINE)) == used
    assert set(VARIABLE.findall("".join(page.read_text(encoding="utf-8") for page in PAGES))) <= used


def test_all_that_a_feature_can_bring_is_described():
    text = (ROOT / "docs" / "extend" / "add_a_page.md").read_text(encoding="utf-8")
    table = text.partition("## What a feature can bring")[2].partition("\n## ")[0]
    cells = "".join(re.findall(r"^\| (`.*?) \|", table, re.MULTILINE))
    assert set(re.findall(r"`(\w+)`", cells)) - {"Feature"} == {field.name for field in fields(Feature)}


def test_all_routes_are_described(tmp_path):
    rules = {re.sub(r"<\w+:", "<", rule.rule) for rule in create_app(tmp_path).server.url_map.iter_rules()}
    text = (ROOT / "docs" / "reference" / "pages.md").read_text(encoding="utf-8")
    described = set(re.findall(r"`(/api/[^`]+)`", text.partition("## Routes")[2]))
    assert described == {rule for rule in rules if rule.startswith("/api/")}


def test_values_of_settings_can_be_used():
    known = [parameter for method in METHODS for parameter in parameters(method)]
    for page in (ROOT / "docs" / "methods").glob("*.md"):
        for name, value in VALUE.findall(page.read_text(encoding="utf-8")):
            assert any(parameter.name == name and accepts(parameter, value) for parameter in known), (page, name, value)


def accepts(parameter, value: str) -> bool:
    try:
        parameter.parse(value)
    except ParameterError:
        return False
    return True


def test_files_that_are_named_exist():
    missing = [
        f"{page.relative_to(ROOT)}: {name}"
        for page in PAGES
        for name in FILE.findall(page.read_text(encoding="utf-8"))
        if not PLACEHOLDER.search(name) and not any(ROOT.glob(name.rstrip("/.")))
    ]
    assert missing == []


def test_pages_that_the_code_names_exist():
    named = set()
    for place in CODE:
        for file in (ROOT / place).rglob("*.*"):
            if file.suffix in (".py", ".mjs", ".css") and "node_modules" not in file.parts:
                named |= set(re.findall(r"docs/[\w/]+\.(?:md|svg|png)", file.read_text(encoding="utf-8")))
    assert {name for name in named if not (ROOT / name).is_file()} == set()


def test_links_of_the_readme_lead_somewhere():
    for page in (ROOT / "README.md", ROOT / "CONTRIBUTING.md", ROOT / "CHANGELOG.md"):
        links = re.findall(r"\]\(([^)#\s]+)", page.read_text(encoding="utf-8"))
        assert [link for link in links if "://" not in link and not (ROOT / link).exists()] == []


@pytest.fixture
def unchanged_lists():
    """Methods and features that an example registers are gone after it."""
    methods, known = dict(METHODS), features()
    yield
    METHODS.clear()
    METHODS.update(methods)
    for feature in [feature for feature in features() if feature not in known]:
        unregister(feature.path)


@pytest.fixture(scope="module")
def recordings(tmp_path_factory) -> Path:
    """A folder with the names that the examples use: ``recordings/walk_01.bvh`` and others, and ``new/``."""
    folder = tmp_path_factory.mktemp("examples")
    for name, minutes in (("recordings", 1), ("new", 0.3)):
        first = write_demo(folder / name, minutes)[0]
        labels = folder / name / "labels.csv"
        labels.write_text(labels.read_text(encoding="utf-8").replace(first.stem, "walk_01"), encoding="utf-8")
        first.rename(first.with_name("walk_01.bvh"))
    return folder


@pytest.mark.parametrize("block", list(blocks("python")), ids=str)
def test_python_examples_run(block, recordings, unchanged_lists, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    for name in ("recordings", "new"):
        Path(name).symlink_to(recordings / name)
    if 'workspace.open("bandai")' in block.text:  # the one example that begins with a data set
        Workspace("workspace").add_dataset("bandai", open_dataset("recordings"))
    example = ModuleType("example")
    monkeypatch.setitem(sys.modules, "example", example)  # dataclasses look up their module
    exec(compile(block.text, str(block), "exec", dont_inherit=True), vars(example))
