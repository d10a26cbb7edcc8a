"""numba's compiler behind a signature that type checkers understand: a compiled kernel keeps the types it declares."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeVar, cast

import numba

Kernel = TypeVar("Kernel", bound=Callable[..., Any])


def njit(*, nogil: bool = False, fastmath: bool | set[str] = False) -> Callable[[Kernel], Kernel]:
    """Compiles the decorated function when it is first called; the machine code is kept on disk beside its source.

    Args:
        nogil: Other Python threads go on while the kernel runs.
        fastmath: Which rearrangements of floating point arithmetic are allowed (``True``: all of them).
    """
    return cast("Callable[[Kernel], Kernel]", numba.njit(cache=True, nogil=nogil, fastmath=fastmath))


def warm_up() -> None:
    """Gets numba ready to load kernels, which takes longer than to load one; no thread is started."""
    _smallest(0)


@njit()
def _smallest(number: int) -> int:
    return number
