"""Workers without work stay for a while, with everything imported, and are called for the next job.

Each listens at a socket in a folder that only this account may enter, one folder for each set of surroundings: the
code, the Python that runs it and the settings that it reads from the environment. To call a worker, its socket is
renamed, which only one caller can do, and the path of a workspace is sent to it. It sleeps while nobody calls.
"""

from __future__ import annotations

import contextlib
import hashlib
import os
import socket
import sys
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache
from pathlib import Path

STAY = 300.0  # seconds a worker stays without work
ALONE = 15.0  # seconds it stays where who called it last is gone
MOST = 2  # idle workers of the same surroundings
POSSIBLE = hasattr(socket, "AF_UNIX") and hasattr(os, "getuid")
_SETTINGS = ("MOTIONSCAPE_", "PYTHON", "OMP_", "OPENBLAS_", "MKL_", "NUMBA_", "LD_", "DYLD_", "TMPDIR", "HOME")
_TAKEN = ".called"
_CALL = 10.0  # seconds between two looks at whether the caller is still there; that a call may take to arrive


def call(workspace_path: str | Path) -> bool:
    """Sends an idle worker to the workspace; False where there is none."""
    if not POSSIBLE:
        return False
    with contextlib.suppress(OSError):
        for waiting in sorted(_folder().glob("*.idle")):
            if _send(waiting, str(workspace_path)):
                return True
    return False


def wait(caller: int, stay: float = STAY) -> tuple[str, int] | None:
    """Waits to be called; the path of the workspace and the caller's process, or None when it is time to leave.

    caller: the process that this worker was started by or worked for last.
    """
    if not POSSIBLE:
        return None
    with contextlib.suppress(OSError), _listening() as (listener, place):
        listener.settimeout(min(_CALL, stay))
        waited, alone = 0.0, 0.0
        while waited < stay and alone < ALONE:
            with contextlib.suppress(TimeoutError):
                return _read(listener)
            waited += listener.gettimeout() or 0.0
            alone = 0.0 if _lives(caller) else alone + _CALL
        try:
            place.unlink()
        except FileNotFoundError:  # someone has just taken it
            with contextlib.suppress(TimeoutError):
                return _read(listener)
    return None


@contextmanager
def _listening() -> Iterator[tuple[socket.socket, Path]]:
    """A socket at a place of its own. Raises OSError where that is not possible, or enough others wait."""
    place = _folder() / f"{os.getpid()}.idle"
    if sum(1 for _ in place.parent.glob("*.idle")) >= MOST:
        raise OSError("enough workers wait")
    with socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as listener:
        place.unlink(missing_ok=True)
        listener.bind(str(place))
        try:
            yield listener, place
        finally:
            for left in (place, place.with_suffix(_TAKEN)):
                left.unlink(missing_ok=True)
            with contextlib.suppress(OSError):  # the last one leaves nothing behind
                place.parent.rmdir()


def _send(waiting: Path, workspace_path: str) -> bool:
    taken = waiting.with_suffix(_TAKEN)
    try:
        waiting.rename(taken)
    except FileNotFoundError:  # another was quicker, or it has left
        return False
    try:
        with socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as sender:
            sender.sendto(f"{os.getpid()} {workspace_path}".encode(), str(taken))
        return True
    except OSError:  # its worker was ended: nobody listens
        taken.unlink(missing_ok=True)
        return False


def _read(listener: socket.socket) -> tuple[str, int]:
    caller, path = listener.recv(65536).decode().split(" ", 1)
    return path, int(caller)


def _lives(process: int) -> bool:
    import psutil

    return psutil.pid_exists(process)


def _folder() -> Path:
    """The folder of the sockets. Raises OSError where another account has made it."""
    folder = Path(tempfile.gettempdir()) / f"motionscape-{os.getuid()}-{_surroundings()}"
    with contextlib.suppress(FileExistsError):
        folder.mkdir(mode=0o700)
    state = folder.lstat()
    if state.st_uid != os.getuid() or state.st_mode & 0o077 or folder.is_symlink():
        raise OSError(f"{folder} is not ours alone")
    return folder


def _surroundings() -> str:
    """A mark of the code and of the settings of this process."""
    settings = sorted((name, value) for name, value in os.environ.items() if name.startswith(_SETTINGS))
    mark = repr((sys.executable, _code(), settings))
    return hashlib.blake2b(mark.encode(), digest_size=6).hexdigest()


@cache
def _code() -> tuple[str, int]:
    """Where the code lies, and its newest change when this is first asked."""
    code = Path(__file__).resolve().parents[2]
    newest = max(file.stat().st_mtime_ns for part in ("core", "webapp") for file in (code / part).rglob("*.py"))
    return str(code), newest
