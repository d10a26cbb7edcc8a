"""What the API pages of the documentation site show, made readable. A griffe extension, named in mkdocs.yml.

Sphinx roles such as ``:func:`~core.module.name``` become plain code, and a setting that is declared as
``parameter(30.0, "Frames a second.")`` has the default 30.0 and the help text as its docstring.
"""

from __future__ import annotations

import ast
import re
from typing import Any

import griffe

ROLE = re.compile(r":(?:func|class|mod|meth|data|attr|exc):`~?([^`]+)`")


class Readable(griffe.Extension):
    """Rewrites docstrings and the values of settings while the code is read."""

    def on_object(self, *, obj: griffe.Object, **_: Any) -> None:
        """Called once for each module, class, function and attribute."""
        if obj.docstring:
            obj.docstring.value = ROLE.sub(r"`\1`", obj.docstring.value)

    def on_attribute_instance(self, *, node: Any, attr: griffe.Attribute, **_: Any) -> None:
        """Called for each attribute: its value in place of the call that declares it."""
        call = getattr(node, "value", None)
        if not isinstance(call, ast.Call) or not isinstance(call.func, ast.Name):
            return
        given = {keyword.arg: keyword.value for keyword in call.keywords}
        if call.func.id == "parameter":
            given |= dict(zip(("default", "help"), call.args, strict=False))
        elif call.func.id == "field":
            given["help"] = help_of(given.get("metadata"))
        else:
            return
        if given.get("default"):
            attr.value = ast.unparse(given["default"])
        if given.get("help") and not attr.docstring:
            attr.docstring = griffe.Docstring(text_of(given["help"]), parent=attr)


def help_of(metadata: ast.expr | None) -> ast.expr | None:
    """The value of the key "help" in a dict that is written out."""
    if not isinstance(metadata, ast.Dict):
        return None
    pairs = zip(metadata.keys, metadata.values, strict=True)
    return next((value for key, value in pairs if isinstance(key, ast.Constant) and key.value == "help"), None)


def text_of(node: ast.expr) -> str:
    """Text that is written out, also in several parts; values that are filled in are left out."""
    if isinstance(node, ast.BinOp):
        return text_of(node.left) + text_of(node.right)
    if isinstance(node, ast.JoinedStr):
        return "".join(map(text_of, node.values))
    return node.value if isinstance(node, ast.Constant) and isinstance(node.value, str) else ""
