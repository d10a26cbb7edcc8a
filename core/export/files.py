"""Feature tables as files: npz for numpy, Parquet for data frames."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from core.errors import ParameterError
from core.export.features import FeatureTable
from core.mocap.files import replacing

SUFFIXES = (".npz", ".parquet")


def write_features(path: str | Path, table: FeatureTable) -> None:
    """Writes a table by the suffix of ``path``, atomically. Raises ParameterError for another suffix, OSError.

    npz: the arrays of :class:`FeatureTable` under their names (text as fixed-width strings: no pickles). Parquet: one
    row a frame with the columns clip, subject, split, frame, seconds, label, left_foot_contact, right_foot_contact,
    ``<joint>.x|y|z`` (metres), ``<joint> <angle>`` (degrees) and ``pose.0`` ...
    """
    path = Path(path)
    if path.suffix.lower() not in SUFFIXES:
        raise ParameterError(f"{path.name}: features are written as {' or '.join(SUFFIXES)}")
    write = _write_npz if path.suffix.lower() == ".npz" else _write_parquet
    with replacing(path) as temporary:
        write(temporary, table)


def _write_npz(path: Path, table: FeatureTable) -> None:
    text = {name: np.array(getattr(table, name)) for name in ("clips", "subjects", "splits", "joints", "actions")}
    arrays: dict[str, Any] = {
        name: getattr(table, name)
        for name in ("clip_starts", "frames", "positions", "angles", "contacts", "poses", "labels")
    }
    empty = {name: values.astype("U1") for name, values in text.items() if values.size == 0}
    with path.open("wb") as file:
        arrays |= text | empty | {"fps": np.array(table.fps), "angle_names": np.array(table.angle_names)}
        np.savez_compressed(file, **arrays)


def _write_parquet(path: Path, table: FeatureTable) -> None:
    import pyarrow as pa
    import pyarrow.parquet as pq

    lengths = np.diff(table.clip_starts)

    def of_clips(values: tuple[str, ...]) -> pa.Array:
        return pa.DictionaryArray.from_arrays(
            np.repeat(np.arange(len(values), dtype=np.int32), lengths), pa.array(values)
        )

    within = np.arange(len(table.frames)) - np.repeat(table.clip_starts[:-1], lengths)
    labels = pa.DictionaryArray.from_arrays(
        pa.array(table.labels.astype(np.int32), mask=table.labels < 0), pa.array(table.actions, pa.string())
    )
    columns = {
        "clip": of_clips(table.clips),
        "subject": of_clips(table.subjects),
        "split": of_clips(table.splits),
        "frame": table.frames,
        "seconds": (within / table.fps).astype(np.float32),
        "label": labels,
        "left_foot_contact": table.contacts[:, 0],
        "right_foot_contact": table.contacts[:, 1],
    }
    for j, joint in enumerate(table.joints):
        columns |= {f"{joint}.{axis}": table.positions[:, j, k] for k, axis in enumerate("xyz")}
    columns |= {name: table.angles[:, k] for k, name in enumerate(table.angle_names)}
    columns |= {f"pose.{k}": table.poses[:, k] for k in range(table.poses.shape[1])}
    with path.open("wb") as file:  # ours, for its errors name the file
        pq.write_table(pa.table({name: pa.array(values) for name, values in columns.items()}), file)
