"""An uploaded recording that is looked for and not imported: read by a job, kept like a result under the job's key."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from core.errors import FormatError
from core.progress import Report
from core.workspace.errors import WorkspaceError
from core.workspace.workspace import Workspace

if TYPE_CHECKING:
    from core.mocap.clip import Clip

FORMAT = "motionscape/recording/1"
SHORTEST = 8  # frames


@dataclass(frozen=True)
class QueryFileParameters:
    """The upload that holds the recording."""

    upload: str


def read_query_file(workspace: Workspace, key: str, values: QueryFileParameters, report: Report) -> Clip:
    """The first recording of an upload, stored under ``key``; the upload is removed, whether it could be read or not.

    Archives are unpacked. Raises RecordingError or WorkspaceError, in plain words, where there is no recording that
    can be read, or it is too short to look for.
    """
    from core.mocap.dataset import read_recordings
    from core.mocap.errors import RecordingError
    from core.workspace.archives import unpack_archives
    from core.workspace.importing import holds_recordings, left_out_words, only_skeleton

    folder = workspace.uploads.path(values.upload)
    try:
        reports = unpack_archives(folder, report)
        if not holds_recordings(folder):
            reasons = [message for file in reports if file.verdict != "ok" for message in file.messages]
            words = " ".join([*reasons, *left_out_words(folder)])
            raise WorkspaceError(words or "There is no recording in this file (BVH, or AMC together with its ASF).")
        file, clip = next(iter(read_recordings(folder, skeleton=only_skeleton(folder), report=report)))
        if isinstance(file, RecordingError):
            raise file
        assert clip is not None
        if clip.n_frames < SHORTEST:
            raise WorkspaceError(f"{clip.name} has {clip.n_frames} frames; a query needs at least {SHORTEST}.")
    finally:
        workspace.uploads.remove(values.upload)
    workspace.results.put(key, *pack_clip(clip))
    return clip


def kept_query(workspace: Workspace, key: str) -> Clip | None:
    """The recording that was stored under ``key``; None where there is none. Raises NameRefused for what is no key,
    ResultDamaged."""
    stored = workspace.results.get(key)
    try:
        return unpack_clip(*stored) if stored else None
    except (ValueError, KeyError, TypeError, IndexError):
        return None


def pack_clip(clip: Clip) -> tuple[dict[str, Any], dict[str, np.ndarray]]:
    """A clip as a document and arrays: ``root (n, 3)`` metres, ``rotations (n, n_joints, 4)``, ``translation_J (n, 3)``
    metres for each joint J that has one."""
    document = {"format": FORMAT, "name": clip.name, "fps": clip.fps, "skeleton": clip.skeleton.to_json()}
    document |= {"notes": list(clip.notes), "findings": [asdict(f) for f in clip.findings], "up": clip.up}
    document |= {"rest_turned": clip.rest_turned}
    arrays = {"root": np.asarray(clip.root_positions), "rotations": np.asarray(clip.rotations)}
    return document, arrays | {f"translation_{j}": np.asarray(track) for j, track in clip.translations.items()}


def unpack_clip(document: Mapping[str, Any], arrays: Mapping[str, np.ndarray]) -> Clip:
    """The clip back from :func:`pack_clip`, arrays ``(n, ...)`` as there. Raises FormatError, KeyError, TypeError."""
    from core.mocap.clip import Clip
    from core.mocap.skeleton import Skeleton
    from core.mocap.storage import findings_from

    if document.get("format") != FORMAT:
        raise FormatError(f"not a recording: expected format {FORMAT}, found {document.get('format')}")
    moving = {int(name.partition("_")[2]): track for name, track in arrays.items() if name.startswith("translation_")}
    skeleton = Skeleton.from_json(document["skeleton"])
    return Clip(
        document["name"],
        skeleton,
        document["fps"],
        arrays["root"],
        arrays["rotations"],
        moving,
        tuple(document["notes"]),
        findings_from(document),
        document.get("up", "y"),
        document.get("rest_turned", False),
    )
