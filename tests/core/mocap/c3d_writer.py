"""Writes small C3D files in every byte order, for tests."""

from __future__ import annotations

import struct
from collections.abc import Sequence

import numpy as np


def c3d(
    points: np.ndarray, labels: Sequence[str], order: str = "intel", real: bool = True, unit="mm", rate=50.0
) -> bytes:
    """Bytes of a C3D file. points: (n_frames, n_points, 3), NaN where lost; order: intel, dec or sgi."""
    end, processor = {"intel": ("<", 84), "dec": ("<", 85), "sgi": (">", 86)}[order]
    n, count = points.shape[:2]

    def reals(values) -> bytes:
        values = np.atleast_1d(np.asarray(values, np.float32))
        if order != "dec":
            return values.astype(f"{end}f4").tobytes()
        words = (values * 4).astype("<f4").view("<u2").reshape(-1, 2)[:, ::-1]
        return words.astype("<u2").tobytes()

    step = float(np.nanmax(np.abs(points))) / 30000 or 1.0
    scale = -step if real else step
    blocks = bytearray()

    def record(name: str, group: int, kind: int, shape: Sequence[int], body: bytes) -> None:
        data = struct.pack("bB", kind, len(shape)) + bytes(shape) + body + b"\0"
        blocks.extend(
            struct.pack("bb", len(name), group) + name.encode() + struct.pack(f"{end}h", len(data) + 2) + data
        )

    blocks += struct.pack("bb", 5, -1) + b"POINT" + struct.pack(f"{end}h", 3) + b"\0"
    record("USED", 1, 2, (), struct.pack(f"{end}h", count))
    record("FRAMES", 1, 2, (), struct.pack(f"{end}h", n))
    record("SCALE", 1, 4, (), reals(scale))
    record("RATE", 1, 4, (), reals(rate))
    record("UNITS", 1, -1, (len(unit),), unit.encode())
    width = max(map(len, labels))
    record("LABELS", 1, -1, (width, count), "".join(label.ljust(width) for label in labels).encode())
    blocks += bytes(2)
    n_blocks = -(-(len(blocks) + 4) // 512)
    start = 2 + n_blocks
    record_start = bytes([1, 80, n_blocks, processor])
    head = bytearray(512)
    head[:2] = bytes([2, 80])
    struct.pack_into(f"{end}HHHH", head, 2, count, 0, 1, n)
    head[12:16] = reals(scale)
    struct.pack_into(f"{end}HH", head, 16, start, 0)
    head[20:24] = reals(rate)
    lost = np.isnan(points).any(axis=2)
    values = np.concatenate([np.nan_to_num(points), np.where(lost, -1.0, 0.0)[..., None]], axis=2)
    if real:
        body = reals(values.ravel())
    else:
        values[..., :3] = np.round(values[..., :3] / step)
        body = values.astype(f"{end}i2").tobytes()
    return bytes(head) + (record_start + bytes(blocks)).ljust(512 * n_blocks, b"\0") + body
