"""Small pictures of saved views, made by the browser that saved them."""

from __future__ import annotations

import base64
import binascii
import hashlib

from core.workspace import ResultDamaged, Workspace, WorkspaceError

FORMAT = "motionscape/picture/1"
LARGEST = 60_000  # bytes
_BEGINS = "data:image/jpeg;base64,"


def keep_picture(workspace: Workspace, view: str, version: int, address: str) -> None:
    """Keeps a picture; address: as ``data:image/jpeg;base64,...``. Raises WorkspaceError for anything else."""
    if not address.startswith(_BEGINS) or len(address) > 2 * LARGEST:
        raise WorkspaceError("The picture of a view is a small JPEG.")
    try:
        picture = base64.b64decode(address.removeprefix(_BEGINS), validate=True)
    except binascii.Error as error:
        raise WorkspaceError("The picture of a view is a small JPEG.") from error
    if len(picture) > LARGEST or not picture.startswith(b"\xff\xd8\xff"):
        raise WorkspaceError("The picture of a view is a small JPEG.")
    document = {"format": FORMAT, "picture": base64.b64encode(picture).decode()}
    workspace.results.put(_key(view, version), document)


def picture_of(workspace: Workspace, view: str, version: int) -> bytes | None:
    """The picture of a version of a view, or of the newest before it that has one; None where none has."""
    for earlier in range(version, max(version - 20, 0), -1):
        try:
            found = workspace.results.get(_key(view, earlier))
        except ResultDamaged:
            continue
        if found is not None and found.document.get("format") == FORMAT:
            return base64.b64decode(found.document["picture"])
    return None


def _key(view: str, version: int) -> str:
    return hashlib.blake2b(f"picture {view} {version}".encode(), digest_size=16).hexdigest()
