"""Rows of numbers, gathered block by block: in memory while they are few, in a file beyond that."""

from __future__ import annotations

import tempfile
from typing import IO

import numpy as np

_IN_MEMORY = 256 << 20  # bytes


class Rows:
    """Blocks of equally long rows of float32, one below the other."""

    def __init__(self, in_memory: int = _IN_MEMORY) -> None:
        self._most, self._bytes, self._width = in_memory, 0, 0
        self._blocks: list[np.ndarray] = []
        self._file: IO[bytes] | None = None

    def add(self, block: np.ndarray) -> None:
        """Put a block ``(n, width)`` below the others. Raises OSError where the disk is full."""
        block = np.ascontiguousarray(block, np.float32)
        self._bytes, self._width = self._bytes + block.nbytes, block.shape[1]
        self._blocks.append(block)
        if self._bytes > self._most:
            self._file = self._file or tempfile.TemporaryFile()  # noqa: SIM115
            for waiting in self._blocks:
                waiting.tofile(self._file)
            self._blocks.clear()

    def array(self) -> np.ndarray:
        """All rows ``(n, width)``; mapped, where they are in a file, which goes when nobody uses the array any more.

        Raises ValueError where there is no row.
        """
        if self._file is None:
            return np.concatenate(self._blocks)
        self._file.flush()
        return np.memmap(self._file, np.float32, "r", shape=(self._bytes // 4 // self._width, self._width))
