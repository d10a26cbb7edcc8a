"""A dataset on disk: ``dataset.json`` and ``motion.npy``, all numbers of all clips one after another.

The numbers are memory-mapped on loading, so that opening costs no more than the JSON and hours of motion do not fill
memory. Nothing is pickled.
"""

from __future__ import annotations

import json
import math
import os
import shutil
from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import asdict
from pathlib import Path
from typing import Any, BinaryIO

import numpy as np

from core.machine import allow_mapped
from core.mocap.clip import Clip, Label
from core.mocap.dataset import Dataset, clip_digest
from core.mocap.errors import RecordingError
from core.mocap.files import replacing
from core.mocap.reports import FileReport, Finding, ImportReport
from core.mocap.skeleton import Skeleton

FORMAT = "motionscape/dataset/1"
_FLOAT = np.dtype("<f4")
_CHECKED = 1 << 26  # bytes of motion that are read through when a dataset is opened


def save_dataset(folder: str | Path, dataset: Dataset) -> None:
    """Store a dataset as ``folder``, in the place of what was there; whole or not at all.

    Raises OSError where it cannot be written.
    """
    with writing_dataset(folder, dataset.name) as writer:
        for clip, digest in zip(dataset.clips, dataset.digests, strict=True):
            writer.add(clip, digest)
        writer.labels, writer.report = dataset.labels, dataset.report


@contextmanager
def writing_dataset(folder: str | Path, name: str) -> Iterator[DatasetWriter]:
    """Store a dataset clip by clip, for collections larger than memory; in place when the block ends well.

    Raises OSError where it cannot be written; then, as after any other error in the block, nothing is left behind.
    """
    Path(folder).parent.mkdir(parents=True, exist_ok=True)
    with replacing(folder) as fresh:
        fresh.mkdir()
        with (fresh / "motion.npy").open("wb") as file:
            writer = DatasetWriter(file, name)
            yield writer
            writer.finish()
        (fresh / "dataset.json").write_text(json.dumps(writer.head, ensure_ascii=False), encoding="utf-8")


def save_relabelled(folder: str | Path, source: str | Path, labels: Iterable[Label], report: ImportReport) -> None:
    """Store the dataset of the folder ``source`` once more, in the existing ``folder``, with other labels and report.

    The numbers are shared where the disk can (a hard link), so that this costs no room. Raises OSError.
    """
    folder, source = Path(folder), Path(source)
    try:
        os.link(source / "motion.npy", folder / "motion.npy")
    except OSError:
        shutil.copyfile(source / "motion.npy", folder / "motion.npy")
    head = json.loads((source / "dataset.json").read_text(encoding="utf-8"))
    head |= {"labels": [list(label) for label in labels], "report": asdict(report)}
    (folder / "dataset.json").write_text(json.dumps(head, ensure_ascii=False), encoding="utf-8")


class DatasetWriter:
    """Takes the clips of a dataset one by one; set ``labels`` and ``report`` before the end."""

    def __init__(self, file: BinaryIO, name: str):
        self.labels: Iterable[Label] = ()
        self.report = ImportReport()
        self.head: dict[str, Any] = {"format": FORMAT, "name": name, "skeletons": [], "clips": []}
        self._file, self._written = file, 0
        self._skeletons: dict[tuple[Skeleton, float], int] = {}  # equal ones may have come in different units
        self._header()

    def add(self, clip: Clip, digest: str | None = None) -> None:
        """Append a clip; ``digest`` as in Dataset.digests, computed where not given."""
        entry: dict[str, Any] = {
            "name": clip.name,
            "skeleton": self._skeleton(clip.skeleton),
            "fps": clip.fps,
            "frames": clip.n_frames,
        }
        entry |= {
            "start": self._written,
            "translated": sorted(clip.translations),
            "digest": digest or clip_digest(clip),
        }
        entry |= {"notes": clip.notes, "findings": [asdict(finding) for finding in clip.findings], "up": clip.up}
        entry |= {"rest_turned": clip.rest_turned}
        for part in (clip.root_positions, clip.rotations, *(clip.translations[j] for j in sorted(clip.translations))):
            self._file.write(np.ascontiguousarray(part, _FLOAT).data)
            self._written += part.size
        self.head["clips"].append(entry)

    def finish(self) -> None:
        """Write what is known only at the end."""
        self.head["labels"] = [list(label) for label in self.labels]
        self.head["report"] = asdict(self.report)
        self._file.seek(0)
        self._header()  # numpy keeps room in the header for the length to grow

    def _header(self) -> None:
        header = {"descr": _FLOAT.str, "fortran_order": False, "shape": (self._written,)}
        np.lib.format.write_array_header_1_0(self._file, header)

    def _skeleton(self, skeleton: Skeleton) -> int:
        key = skeleton, skeleton.unit
        if key not in self._skeletons:
            self._skeletons[key] = len(self._skeletons)
            self.head["skeletons"].append(skeleton.to_json())
        return self._skeletons[key]


def load_dataset(folder: str | Path) -> Dataset:
    """Open a stored dataset; its frame arrays are memory-mapped and private: changing them never changes the files.

    Raises RecordingError where the folder is no dataset or is damaged.
    """
    folder = Path(folder)
    try:
        head = json.loads((folder / "dataset.json").read_text(encoding="utf-8"))
        if head["format"] != FORMAT:
            raise RecordingError(folder, f"a dataset of format {head['format']!r}", FORMAT)
        allow_mapped((folder / "motion.npy").stat().st_size)
        # a file without numbers cannot be mapped
        numbers = np.load(folder / "motion.npy", mmap_mode="c" if head["clips"] else None, allow_pickle=False)
        _check_finite(numbers, folder)
        skeletons = [Skeleton.from_json(entry) for entry in head["skeletons"]]
        clips = tuple(_clip(entry, skeletons, np.asarray(numbers)) for entry in head["clips"])
        files = (
            FileReport(**{**f, "messages": tuple(f["messages"]), "findings": findings_from(f)})
            for f in head["report"]["files"]
        )
        return Dataset(
            name=head["name"],
            clips=clips,
            labels=tuple(Label(*label) for label in head["labels"]),
            report=ImportReport(tuple(files), tuple(head["report"]["messages"])),
            digests=tuple(entry["digest"] for entry in head["clips"]),
        )
    except RecordingError:
        raise
    except FileNotFoundError:
        raise RecordingError(folder, "no dataset here", "a folder with dataset.json and motion.npy") from None
    except (OSError, EOFError, ValueError, KeyError, TypeError, IndexError, AttributeError, RecursionError) as error:
        raise RecordingError(folder, f"a damaged dataset ({error})", "one that was imported; import it again") from None


def size_of_motion(folder: str | Path) -> int:
    """Bytes of a stored dataset's numbers on the disk, -1 where the file is gone.

    To read numbers that a mapped file has lost ends the process, so whoever keeps a dataset open compares before.
    """
    try:
        return (Path(folder) / "motion.npy").stat().st_size
    except OSError:
        return -1


def _check_finite(numbers: np.ndarray, folder: Path) -> None:
    """Raises RecordingError where a small dataset holds what is no number; larger ones are read when they are used."""
    if numbers.nbytes <= _CHECKED and not np.isfinite(numbers).all():
        raise RecordingError(folder, "numbers in motion.npy are not finite", "a whole dataset; import it again")


def findings_from(entry: Mapping[str, Any]) -> tuple[Finding, ...]:
    """The findings in the JSON of a clip or of a file's report; older ones only have sentences, called warnings."""
    plain = (Finding("other", message) for message in entry.get("warnings", ()))
    return (*plain, *(Finding(**finding) for finding in entry.get("findings", ())))


def _clip(entry: Mapping[str, Any], skeletons: list[Skeleton], numbers: np.ndarray) -> Clip:
    skeleton, n = skeletons[entry["skeleton"]], entry["frames"]
    at = entry["start"]
    parts = []
    for shape in ((n, 3), (n, skeleton.n_joints, 4), *[(n, 3)] * len(entry["translated"])):
        size = math.prod(shape)
        parts.append(numbers[at : at + size].reshape(shape))  # raises ValueError where the file is too short
        at += size
    return Clip(
        name=entry["name"],
        skeleton=skeleton,
        fps=entry["fps"],
        root_positions=parts[0],
        rotations=parts[1],
        translations=dict(zip(entry["translated"], parts[2:], strict=True)),
        notes=tuple(entry["notes"]),
        findings=findings_from(entry),
        up=entry.get("up", "y"),
        rest_turned=entry.get("rest_turned", False),
    )
