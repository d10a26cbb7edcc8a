"""A cache of recent results in memory, shared by all threads of a process."""

from __future__ import annotations

from collections.abc import Callable, Hashable
from threading import Condition
from typing import Generic, TypeVar

from cachetools import LRUCache

Key = TypeVar("Key", bound=Hashable)
Value = TypeVar("Value")


class RecentCache(Generic[Key, Value]):
    """The values of the ``size`` keys used last; safe to share between threads.

    Raises ValueError for a size below 1.
    """

    def __init__(self, size: int) -> None:
        if size < 1:
            raise ValueError(f"a cache holds at least one value, not {size}")
        self._values: LRUCache[Key, Value] = LRUCache(size)
        self._in_progress: set[Key] = set()
        self._condition = Condition()

    def get(self, key: Key) -> Value | None:
        """The value of a key, or None."""
        with self._condition:
            return self._values.get(key)

    def put(self, key: Key, value: Value) -> None:
        """Stores a value; a full cache drops the one used longest ago."""
        with self._condition:
            self._values[key] = value

    def get_or_compute(self, key: Key, compute: Callable[[], Value]) -> Value:
        """The value of a key, from ``compute`` where it is not stored; exceptions of ``compute`` are raised.

        A thread that wants a value which another one is computing waits for it; all others go on. ``compute`` must not
        ask for its own key.
        """
        with self._condition:
            self._condition.wait_for(lambda: key not in self._in_progress)
            if key in self._values:
                return self._values[key]
            self._in_progress.add(key)
        try:
            value = compute()
            self.put(key, value)
            return value
        finally:
            with self._condition:
                self._in_progress.discard(key)
                self._condition.notify_all()

    def discard(self, key: Key) -> None:
        """Removes a key, if it is stored."""
        with self._condition:
            self._values.pop(key, None)

    def clear(self) -> None:
        """Removes all keys."""
        with self._condition:
            self._values.clear()

    def values(self) -> list[Value]:
        """All values, in no particular order."""
        with self._condition:
            return list(self._values.values())

    def __contains__(self, key: Key) -> bool:
        with self._condition:
            return key in self._values

    def __len__(self) -> int:
        with self._condition:
            return len(self._values)
