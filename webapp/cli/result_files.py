"""Files that commands read and write: results of other commands, and the summary of motion that was made."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

from core.workspace import WorkspaceError, atomic_file

if TYPE_CHECKING:
    from core.mocap.dataset import Dataset
    from core.synthesis.packing import Made

T = TypeVar("T")


def write_json(path: Path, document: dict[str, Any]) -> None:
    """Writes JSON atomically; raises OSError."""
    with atomic_file(path) as file:
        file.write(json.dumps(document, ensure_ascii=False, allow_nan=False, separators=(",", ":")).encode())
        file.write(b"\n")


def read_result(path: Path, command: str, from_json: Callable[[Any], T]) -> T:
    """The result in a file that ``command`` wrote. Raises WorkspaceError for another file, OSError."""
    try:
        return from_json(json.loads(path.read_bytes()))
    except (ValueError, KeyError, TypeError, RecursionError) as error:
        raise WorkspaceError(f"{path}: not a file that “motionscape {command}” wrote ({error})") from error


def check_clips(
    path: Path, clips: Iterable[tuple[str, int, float]], used: Iterable[str], dataset: Dataset, source: str
) -> None:
    """Raises WorkspaceError where the result in the file ``path`` is not of these recordings.

    clips: name, frames, fps of each that the result knows; used: those that must be there.
    """
    have = {clip.name: clip.n_frames for clip in dataset.clips}
    for name, frames, _ in clips:
        if have.get(name, frames) != frames:
            raise WorkspaceError(
                f"{path} was made from other recordings: “{name}” has {have[name]} frames here, {frames} there."
            )
    missing = sorted(set(used) - set(have))
    if missing:
        others = f" and {len(missing) - 1} more" if len(missing) > 1 else ""
        raise WorkspaceError(f"{path} names the clip “{missing[0]}”{others}, which {source} does not have.")


def check_made(path: Path, parts: Path | None) -> None:
    """Raises WorkspaceError unless ``path`` is a name for a BVH file, and neither it nor ``parts`` a folder."""
    if path.suffix.lower() != ".bvh":
        raise WorkspaceError(f"{path}: --out names a BVH file, such as walk.bvh.")
    for option, file in (("--out", path), ("--parts", parts)):
        if file is not None and file.is_dir():
            raise WorkspaceError(f"{file} is a folder; {option} names the file to write.")


def made_lines(made: Made, out: Path, parts: Path | None) -> Iterator[str]:
    """The summary that a command prints of motion that it made."""
    yield f"{made.clip.seconds:.1f} s, {made.clip.n_frames} frames, {len(made.seams)} blends"
    skate, speeds = made.skate, made.speeds
    yield (
        f"foot skate, m per second of contact: {skate.kept:.3f} (blending alone {skate.plain:.3f}, "
        f"recordings {skate.source:.3f})"
    )
    yield f"fastest joint, m/s: {speeds.seams:.2f} in the blends, {speeds.sources:.2f} in the recordings"
    yield f"written to {out}" + (f" and {parts}" if parts else "")
