"""Parameters of methods, read from the fields of a dataclass for the command line, the app and checks.

A field's annotation gives its type (``int``, ``float``, ``bool``, ``str``, ``Literal[...]`` and unions of these); its
metadata may give ``label``, ``help``, ``min``, ``max``, ``step``, ``choices`` and ``advanced``.
"""

from __future__ import annotations

import json
import math
import types
from collections.abc import Mapping
from dataclasses import MISSING, dataclass, field, fields
from functools import cache
from typing import Any, Literal, Union, get_args, get_origin, get_type_hints

from core.errors import ParameterError


def parameter(
    default: Any,
    help: str,
    low: float | None = None,
    high: float | None = None,
    step: float | None = None,
    choices: tuple[Any, ...] = (),
    advanced: bool = False,
    label: str = "",
) -> Any:
    """A field of a parameters' dataclass, with the metadata that this module reads."""
    limits = {"min": low, "max": high, "step": step, "choices": choices}
    return field(default=default, metadata={"help": help, "label": label, "advanced": advanced, **limits})


@dataclass(frozen=True)
class Parameter:
    """One parameter. ``kinds``: the types a value may have; ``words``: values that are meant literally (``auto``);

    ``label``: its everyday name, made from ``name`` where the field gives none.
    """

    name: str
    default: Any
    kinds: tuple[type, ...]
    words: tuple[Any, ...] = ()
    minimum: float | None = None
    maximum: float | None = None
    help: str = ""
    step: float | None = None
    advanced: bool = False
    label: str = ""

    @property
    def required(self) -> bool:
        """Whether it must be given."""
        return self.default is None and None not in self.words

    @property
    def expected(self) -> str:
        """What a value may be, in words."""
        kinds = {int: "a whole number", float: "a number", str: "text", bool: "true or false"}
        words = [" or ".join("nothing" if word is None else str(word) for word in self.words)] if self.words else []
        numbers = [kinds[float if float in self.kinds else kind] for kind in self.kinds if kind is not bool][:1]
        if bool in self.kinds:
            numbers = [kinds[bool]]
        if numbers and self.minimum is not None and self.maximum is not None:
            numbers[0] += f" from {self.minimum:g} to {self.maximum:g}"
        elif numbers and self.minimum is not None:
            numbers[0] += f", at least {self.minimum:g}"
        elif numbers and self.maximum is not None:
            numbers[0] += f", at most {self.maximum:g}"
        return " or ".join(words + numbers)

    def parse(self, value: Any) -> Any:
        """The value of this parameter in ``value``, a number, or text from a link or a command line.

        Raises ParameterError, saying what is expected.
        """
        for word in self.words:
            if value == word or (isinstance(value, str) and value.strip().lower() == str(word).lower()):
                return word
        for kind in self.kinds:
            parsed = _as_kind(value, kind)
            if parsed is not None and self._in_range(parsed):
                return parsed
        shown = repr(value)[:60]
        raise ParameterError(f"{self.name}: {shown} cannot be used; expected {self.expected}")

    def _in_range(self, value: Any) -> bool:
        if isinstance(value, bool | str):
            return True
        low = -math.inf if self.minimum is None else self.minimum
        high = math.inf if self.maximum is None else self.maximum
        return math.isfinite(value) and low <= value <= high


def write_value(value: Any) -> str:
    """A value as people write it, without losing a digit: :meth:`Parameter.parse` reads exactly the same back."""
    if isinstance(value, bool):
        return str(value).lower()
    return repr(value).removesuffix(".0") if isinstance(value, float) else str(value)


@cache
def parameters_of(kind: type) -> tuple[Parameter, ...]:
    """The parameters that the dataclass ``kind`` describes, in its order. Raises TypeError for other annotations."""
    hints = get_type_hints(kind)
    return tuple(_read(field, hints[field.name]) for field in fields(kind) if field.init)


def fill(kind: type, values: Mapping[str, Any]) -> dict[str, Any]:
    """All parameters of ``kind`` as plain values: checked, defaults filled in. Raises ParameterError."""
    known = {parameter.name: parameter for parameter in parameters_of(kind)}
    for name in values:
        if name not in known:
            raise ParameterError(f"{str(name)[:60]}: no such parameter; there are {', '.join(known)}")
    missing = [name for name, p in known.items() if p.required and name not in values]
    if missing:
        raise ParameterError(f"{missing[0]}: must be given; expected {known[missing[0]].expected}")
    return {name: p.parse(values[name]) if name in values else p.default for name, p in known.items()}


def build(kind: type, values: Mapping[str, Any]) -> Any:
    """An instance of ``kind`` from ``values``. Raises ParameterError, also for what the checks of ``kind`` refuse."""
    return kind(**fill(kind, values))


def read_object(text: str, name: str) -> dict[str, Any]:
    """The JSON object in the text of the parameter ``name``. Raises ParameterError for anything else."""
    try:
        values = json.loads(text)
    except ValueError:
        values = None
    if not isinstance(values, dict):
        raise ParameterError(f"{name}: expected the other parameters as a JSON object")
    return values


def _read(field: Any, hint: Any) -> Parameter:
    kinds, words = _kinds(hint, field.name)
    meta = field.metadata
    default = _default(field)
    if meta.get("choices"):
        kinds, words = (), tuple(meta["choices"])
    elif str in kinds and len(kinds) > 1:  # a number, or the one word that is its default
        kinds, words = tuple(kind for kind in kinds if kind is not str), (*words, default)
    return Parameter(
        field.name,
        default,
        kinds,
        words,
        minimum=meta.get("min"),
        maximum=meta.get("max"),
        help=meta.get("help", ""),
        step=meta.get("step"),
        advanced=meta.get("advanced", False),
        label=meta.get("label") or field.name.replace("_", " ").capitalize(),
    )


def _default(field: Any) -> Any:
    if field.default is not MISSING:
        return field.default
    return None if field.default_factory is MISSING else field.default_factory()


def _kinds(hint: Any, name: str) -> tuple[tuple[type, ...], tuple[Any, ...]]:
    if get_origin(hint) in (Union, types.UnionType):
        parts = [_kinds(part, name) for part in get_args(hint)]
        return sum((kinds for kinds, _ in parts), ()), sum((words for _, words in parts), ())
    if get_origin(hint) is Literal:
        return (), get_args(hint)
    if hint is type(None):
        return (), (None,)
    if hint in (int, float, bool, str):
        return (hint,), ()
    raise TypeError(f"{name}: parameters are numbers, text, truth values or Literals, not {hint}")


def _as_kind(value: Any, kind: type) -> Any:
    if kind is bool:
        return value if isinstance(value, bool) else {"true": True, "false": False}.get(str(value).strip().lower())
    if kind is str:
        return value if isinstance(value, str) else None
    if isinstance(value, bool) or not isinstance(value, int | float | str):
        return None
    try:
        number = float(value)
        if kind is float:
            return number + 0.0  # so that minus zero is zero
        return _exact_int(value, number) if number.is_integer() else None
    except (ValueError, OverflowError):
        return None


def _exact_int(value: int | float | str, number: float) -> int:
    """``value``, whose nearest float is ``number``, with all its digits."""
    try:
        return int(value)
    except ValueError:  # text such as "3.0" or "1e3"
        return int(number)
