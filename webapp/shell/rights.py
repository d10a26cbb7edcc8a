"""What every route and callback does to the workspace, and who may ask for it.

Each feature marks its routes and callbacks by the names of their functions (:class:`Rights`), and ``webapp/marks.py``
those that belong to no feature. A function without a mark is refused to everyone who is no editor.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

READS = "reads"  # changes nothing
ASKS = "asks"  # shows a result that is there, or starts a job: the workspace starts none for those who may not
CHANGES = "changes"  # changes a dataset, or what people say of it
BOARDS = "changes boards"  # also for those with the edit link of a board
MANAGES = "manages"  # accounts, the audit log
OPEN = "open"  # answers without an account: the sign-in page and what it needs


@dataclass(frozen=True)
class Rights:
    """Names of functions behind routes and callbacks, as ``module.function`` below ``package``, by what they do."""

    package: str = ""
    reads: tuple[str, ...] = ()
    asks: tuple[str, ...] = ()
    changes: tuple[str, ...] = ()
    boards: tuple[str, ...] = ()
    manages: tuple[str, ...] = ()
    open: tuple[str, ...] = ()

    def marks(self) -> dict[str, str]:
        """Full name of each function -> what it does."""
        kinds = {
            READS: self.reads,
            ASKS: self.asks,
            CHANGES: self.changes,
            BOARDS: self.boards,
            MANAGES: self.manages,
            OPEN: self.open,
        }
        return {f"{self.package}.{name}": kind for kind, names in kinds.items() for name in names}


def name_of(function: Callable[..., Any]) -> str:
    """The name by which a function is marked; functions that are made inside others count by their own name."""
    while hasattr(function, "__wrapped__"):
        function = function.__wrapped__
    return f"{getattr(function, '__module__', '')}.{getattr(function, '__name__', '')}"


def callback_name(callbacks: Mapping[str, Mapping[str, Any]], output: object) -> str:
    """The name of the callback that fills ``output`` (as Dash writes it in a request); empty where there is none."""
    entry = callbacks.get(output) if isinstance(output, str) else None
    return name_of(entry["callback"]) if entry and "callback" in entry else ""
