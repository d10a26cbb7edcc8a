"""Every id of a component or a store is declared once, in the ``names`` module of its part, and used from there."""

from __future__ import annotations

import ast
import importlib
import json
import re
import subprocess
import sys
from collections import Counter
from functools import cache
from pathlib import Path
from types import ModuleType

import pytest
from dash import dcc
from hypothesis import given
from hypothesis import strategies as st

from scripts.generate_ids import FEATURES, ROOMS, ids_of
from tests.webapp.shell.test_shapes import RUBBISH
from webapp.app import create_app
from webapp.shell.feature import features
from webapp.shell.identifiers import Family, Group, Id, Pattern, Prefix, Store, constant, declared
from webapp.shell.shapes import problem

REPOSITORY = Path(__file__).resolve().parents[2]
PYTHON = [path for path in sorted((REPOSITORY / "webapp").rglob("*.py")) if path.name != "names.py"]
MODULES = [path for path in sorted((REPOSITORY / "assets").glob("*/*.mjs")) if path.name != "ids.mjs"]
TAKES_ID = {"Input", "Output", "State", "set_props", "sends"}
FINDS = r"(?:(?<!\.)find|need|setLink|gridApi|setStore|set_props|document\.getElementById|put|sends|whole)"


def names_modules() -> dict[str, ModuleType]:
    """Part of the app -> the module that declares its ids."""
    parts = ["shell", "jobs", "stage", *(f"features.{name}" for name in FEATURES)]
    return {part: importlib.import_module(f"webapp.{part}.names") for part in parts}


@cache
def identifiers() -> tuple[Id | Prefix | Pattern, ...]:
    return tuple(one for module in names_modules().values() for _, one in declared(module))


IDS = {str(one) for one in identifiers() if isinstance(one, Id)}
KINDS = {one.kind for one in identifiers() if isinstance(one, Pattern)}
PREFIXES = tuple(str(one) for one in identifiers() if isinstance(one, Prefix))
# words that are classes, too: allowed where no id is expected
SHEETS = "\n".join(path.read_text(encoding="utf-8") for path in REPOSITORY.glob("assets/*/*.css"))
CLASSES = {*re.findall(r"\.([a-z][\w-]*)", SHEETS), "map-way", "compose-most"}
STORES = {str(one): one for one in identifiers() if isinstance(one, Store)}


@pytest.fixture(scope="module")
def app(tmp_path_factory):
    return create_app(tmp_path_factory.mktemp("workspace"))


def is_declared(one: object) -> bool:
    if isinstance(one, dict):
        return one.get("type") in KINDS
    return one in IDS or str(one).startswith(PREFIXES)


def test_every_id_is_declared_once():
    homes = Counter(f"{one.kind}, a pattern" if isinstance(one, Pattern) else str(one) for one in identifiers())
    assert [one for one, n in homes.items() if n > 1] == []


@pytest.mark.parametrize("module", names_modules().values(), ids=lambda module: module.__name__)
def test_constants_are_called_like_their_ids(module):
    plain = [(name, one) for name, one in vars(module).items() if isinstance(one, Id | Prefix)]
    assert [(name, one) for name, one in plain if name != constant(one)] == []


def test_the_callbacks_use_declared_ids_only(app):
    used = [(one["id"], callback["output"]) for callback in app._callback_list for one in callback["inputs"]]
    used += [(one["id"], callback["output"]) for callback in app._callback_list for one in callback["state"]]
    for callback in app._callback_list:
        outputs = re.findall(r"(?:^|\.\.\.?)((?:\{.*?\}|[^.{]+))\.[a-zA-Z_]+", callback["output"].strip("."))
        used += [(one, callback["output"]) for one in outputs]
    ids = [(json.loads(one) if one.startswith("{") else one, where) for one, where in used]
    assert len(ids) > 500
    assert [(one, where) for one, where in ids if not is_declared(one)] == []


def test_the_pages_use_declared_ids_and_their_stores_hold_what_they_may(app):
    for page in (app.layout, *(feature.page() for feature in features())):
        for component in page._traverse():
            one = getattr(component, "id", None)
            if one is None:
                continue
            assert is_declared(one), one
            assert isinstance(component, dcc.Store) == (one in STORES), one
            if isinstance(component, dcc.Store) and getattr(component, "data", None) is not None:
                assert problem(component.data, STORES[one].content) is None


def is_literal(node: ast.AST) -> bool:
    constant_text = isinstance(node, ast.Constant) and isinstance(node.value, str)
    return constant_text or isinstance(node, ast.JoinedStr | ast.Dict)


@pytest.mark.parametrize("path", PYTHON, ids=lambda path: str(path.relative_to(REPOSITORY)))
def test_no_id_is_written_out_in_python(path):
    written = []
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Call):
            called = getattr(node.func, "attr", getattr(node.func, "id", ""))
            first = node.args[:1] if called in TAKES_ID else []
            ids = [*first, *(word.value for word in node.keywords if word.arg == "id" and called != "notice")]
            written += [f"line {one.lineno}: {ast.unparse(one)}" for one in ids if is_literal(one)]
        elif isinstance(node, ast.Constant) and node.value in IDS - CLASSES and "-" in str(node.value):
            written.append(f"line {node.lineno}: {node.value}")
    assert written == []


@pytest.mark.parametrize("path", MODULES, ids=lambda path: str(path.relative_to(REPOSITORY)))
def test_no_id_is_written_out_in_the_browsers_modules(path):
    written = []
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        code = re.sub(r"(^\s*/?\*.*|/\*.*?\*/|(^|\s)//.*)", "", line)
        quoted = re.findall(rf"\b{FINDS}\(\s*[\"'`]([a-z][^\"'`]*)[\"'`]", code)
        quoted += re.findall(r"(?:dataset\.store|\.id)\s*={1,3}\s*[\"'`]([^\"'`]*)[\"'`]", code)
        selectors = re.findall(r"[\"'`][^\"'`]*#([a-z][\w-]*)", code)
        words = [one for one in re.findall(r"[\"'`]([^\"'`]*)[\"'`]", code) if "-" in one and one not in CLASSES]
        found = [*quoted, *(one for one in (*selectors, *words) if one in IDS)]
        written += [f"line {number}: {one}" for one in dict.fromkeys(found)]
    assert written == []


def view_keys(part: str) -> set[str]:
    """The keys of links that code in a folder of ``webapp`` or ``assets`` may name: of its own page, else of any."""
    views = {name: module.View.__annotations__ for name, module in names_modules().items() if name.startswith("feat")}
    own = views.get(f"features.{part}")
    return set(own or {key for view in views.values() for key in view})


def is_view(node: ast.AST) -> bool:
    """Whether an expression is what a page shows: ``view``, ``shown.view``, ``(view or {})``."""
    if isinstance(node, ast.BoolOp):
        return is_view(node.values[0])
    return getattr(node, "attr", getattr(node, "id", "")) in {"view", "search_view"}


def python_link_keys(tree: ast.AST) -> list[ast.Constant]:
    """The literal keys by which Python reads a view, and those that it puts into the store ``view-change``."""
    keys: list[ast.AST | None] = []
    for node in ast.walk(tree):
        if isinstance(node, ast.Subscript) and is_view(node.value):
            keys.append(node.slice)
        elif isinstance(node, ast.Compare) and isinstance(node.ops[0], ast.In) and is_view(node.comparators[0]):
            keys.append(node.left)
        elif isinstance(node, ast.Call) and getattr(node.func, "attr", "") == "get" and is_view(node.func.value):
            keys.append(node.args[0])
        elif isinstance(node, ast.Call) and any(getattr(one, "id", "") == "VIEW_CHANGE" for one in node.args[:1]):
            data = [part for part in node.args[1:] if isinstance(part, ast.Dict)]
            data += [value for part in data for value in part.values if isinstance(value, ast.Dict)]
            keys += [key for part in data for key in part.keys if getattr(key, "value", "") != "data"]
    return [key for key in keys if isinstance(key, ast.Constant)]


@pytest.mark.parametrize("path", PYTHON, ids=lambda path: str(path.relative_to(REPOSITORY)))
def test_python_names_declared_keys_of_links_only(path):
    known = view_keys(path.parts[path.parts.index("features") + 1] if "features" in path.parts else "")
    used = [(key.lineno, key.value) for key in python_link_keys(ast.parse(path.read_text(encoding="utf-8")))]
    assert [(line, key) for line, key in used if key not in known] == []


@pytest.mark.parametrize("path", MODULES, ids=lambda path: str(path.relative_to(REPOSITORY)))
def test_the_browsers_modules_name_declared_keys_of_links_only(path):
    known = view_keys(path.parent.name)
    code = re.sub(r"^\s*/?\*.*|/\*.*?\*/|(?:^|\s)//.*", "", path.read_text(encoding="utf-8"), flags=re.MULTILINE)
    used = re.findall(r"(?<![\w.])(?:now\.)?view\??\.([a-zA-Z]\w*)", code)
    for written in re.findall(r"\bchangeView\(\{(.*?)\}\)", code, flags=re.DOTALL):
        used += re.findall(r"(?:^|,)\s*([a-zA-Z]\w*)\s*:", written)
    assert [key for key in used if key not in known] == []


def test_undeclared_keys_of_links_are_noticed():
    """The tests above can fail."""
    text = "view.get('walk'); (view or {})['wlak']; sends(VIEW_CHANGE, {'sied': 1})\n"
    text += "set_props(VIEW_CHANGE, {'data': {'a': 1}})"
    assert [key.value for key in python_link_keys(ast.parse(text))] == ["walk", "wlak", "sied", "a"]
    assert "walk" in view_keys("motifs") and "walk" not in view_keys("search") and "walk" in view_keys("shell")


def test_every_id_that_is_declared_is_used():
    texts = {path: path.read_text(encoding="utf-8") for path in (*PYTHON, *MODULES)}
    words = set(re.findall(r"\w+", "\n".join(texts.values())))
    unused = []
    for module in names_modules().values():
        for name, value in vars(module).items():
            if isinstance(value, Id | Prefix | Pattern | Family | Group) and name not in words:
                unused.append(f"{module.__name__}.{name}")
    assert unused == []


@pytest.mark.parametrize("room", ROOMS)
def test_the_browsers_ids_are_those_of_python(room):
    assert (REPOSITORY / "assets" / room / "ids.mjs").read_text(encoding="utf-8") == ids_of(room)


def test_names_are_light():
    """The command line loads them with the features, and must start quickly."""
    code = "import sys; import " + ", ".join(f"webapp.features.{name}.names" for name in FEATURES)
    code += "; print([one for one in ('dash', 'numpy', 'flask') if one in sys.modules])"
    out = subprocess.run([sys.executable, "-c", code], cwd=REPOSITORY, capture_output=True, text=True, check=True)
    assert out.stdout.strip() == "[]"


@given(RUBBISH)
def test_no_store_stumbles_over_rubbish(value):
    for store in STORES.values():
        words = problem(value, store.content, store)
        assert words is None or words.startswith(store)


@given(st.data())
def test_what_misses_a_part_or_has_a_wrong_one_does_not_fit(data):
    store = data.draw(st.sampled_from([one for one in STORES.values() if hasattr(one.content, "__annotations__")]))
    broken = {key: object() for key in store.content.__annotations__}
    if any(problem(value, part) for value, part in zip(broken.values(), store.content.__annotations__, strict=False)):
        assert problem(broken, store.content)
