"""The bytes of a recording: unpacked, with one kind of line end, and refused where they are no text."""

from __future__ import annotations

import gzip
import re
import zlib
from pathlib import Path

from core.mocap.errors import RecordingError

MAX_BYTES = 2**31  # unpacked
_ALWAYS, _TIMES = 1 << 26, 100  # a .gz may grow to 64 MB, or a hundredfold: motion as text grows about fivefold
LARGEST = 1e9  # no coordinate, length or angle of a person comes near it in any unit
MAX_NAME = 256

_CONTROL = re.compile(rb"[\x00-\x08\x0e-\x19\x1b-\x1f]")
_NUMBER = re.compile(r"[+-]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+-]?[0-9]+)?")


def recording_format(path: str | Path) -> tuple[str, str]:
    """Stem and format of a file name, ``.gz`` set aside: ``"01_06.amc.gz"`` gives ``("01_06", ".amc")``."""
    name = Path(path).name
    if name.lower().endswith(".gz"):
        name = name[:-3]
    return Path(name).stem, Path(name).suffix.lower()


def read_bytes(path: str | Path, notes: list[str] | None = None) -> bytes:
    r"""Content of a text file or of its ``.gz``: UTF-8, no byte-order mark, lines end in ``\n``.

    notes: gets a sentence where the text came in another encoding. Raises RecordingError where there is no such file,
    it cannot be unpacked, is empty, or is not plain text.
    """
    data = _unpacked(Path(path))
    if encoding := _wide_encoding(data):
        try:
            data = data.decode(encoding).encode()
        except UnicodeError:
            raise RecordingError(path, "the text begins as UTF-16 and is damaged", "a whole text file") from None
        if notes is not None:
            notes.append("the text is UTF-16: read as such")
    data = data.removeprefix(b"\xef\xbb\xbf")
    if data.startswith(b"version https://git-lfs"):
        raise RecordingError(path, "a Git LFS pointer stands in place of the recording", "the data; run 'git lfs pull'")
    if b"\r" in data:
        data = data.replace(b"\r\n", b"\n").replace(b"\r", b"\n")
    if not data.strip():
        raise RecordingError(path, "the file is empty")
    # A recording is numbers after its head, so binary content shows early; the readers refuse the rest as no number.
    if odd := _CONTROL.search(data, 0, 1 << 16):
        byte, line = data[odd.start()], line_at(data, odd.start())
        raise RecordingError(path, f"byte 0x{byte:02x}, which no text has", "a text file", line)
    return data


def read_binary(path: str | Path) -> bytes:
    """Content of a file or of its ``.gz``. Raises RecordingError where there is none, or it cannot be unpacked."""
    data = _unpacked(Path(path))
    if not data:
        raise RecordingError(path, "the file is empty")
    if data.startswith(b"version https://git-lfs"):
        raise RecordingError(path, "a Git LFS pointer stands in place of the recording", "the data; run 'git lfs pull'")
    return data


def _wide_encoding(data: bytes) -> str:
    """Name of the two-byte encoding of a text, told by its byte-order mark or by every other byte being 0."""
    if data.startswith((b"\xff\xfe", b"\xfe\xff")):
        return "utf-16"
    head = data[:200]
    if len(head) < 20 or not any(head):
        return ""
    even, odd = head[::2].count(0), head[1::2].count(0)
    if not even and odd == len(head) // 2:
        return "utf-16-le"
    return "utf-16-be" if not odd and even == (len(head) + 1) // 2 else ""


def _unpacked(path: Path) -> bytes:
    try:
        if not path.is_file():
            raise RecordingError(path, "there is no such file" if not path.exists() else "this is not a file")
        if not path.name.lower().endswith(".gz"):
            data = path.read_bytes() if path.stat().st_size <= MAX_BYTES else None
        else:
            most = min(MAX_BYTES, max(_ALWAYS, _TIMES * path.stat().st_size))
            with gzip.open(path) as file:
                data = file.read(most + 1)
            if most < len(data) <= MAX_BYTES:
                raise RecordingError(path, f"grows more than {_TIMES} times when unpacked", "the recording, unpacked")
    except (EOFError, zlib.error, gzip.BadGzipFile) as error:
        raise RecordingError(path, f"cannot be unpacked ({error})", "a complete gzip file") from None
    except (OSError, ValueError) as error:
        if isinstance(error, RecordingError):
            raise
        raise RecordingError(path, f"cannot be read ({getattr(error, 'strerror', None) or error})") from None
    if data is None or len(data) > MAX_BYTES:
        raise RecordingError(path, "more than 2 GB", "a shorter recording; cut it into several files")
    return data


def decoded(data: bytes) -> str:
    """Text of a file's head: UTF-8, else Latin-1, which old Windows tools write."""
    try:
        return data.decode("utf-8")
    except UnicodeDecodeError:
        return data.decode("latin-1")


def line_at(data: bytes, offset: int) -> int:
    """1-based number of the line that holds byte ``offset``."""
    return data.count(b"\n", 0, offset) + 1


def token_at(data: bytes, offset: int) -> str:
    """The word at byte ``offset``, shortened, for a message."""
    words = data[offset : offset + 60].split(None, 1)
    return quoted(words[0].decode("latin-1")) if words else "nothing"


def quoted(word: str) -> str:
    """A word from a file as it may stand in a one-line message: in quotes, escaped, at most 40 characters."""
    return repr(word if len(word) <= 40 else word[:37] + "...")


def number(path: str | Path, word: str, line: int, what: str = "a number") -> float:
    """A finite decimal number of believable size. Raises RecordingError for anything else (nan, hex, 1,5 ...)."""
    value = float(word) if _NUMBER.fullmatch(word) else None
    if value is None:
        raise RecordingError(path, f"{quoted(word)}", what, line)
    if not abs(value) <= LARGEST:
        raise RecordingError(path, f"{quoted(word)} is out of range", f"{what} below {LARGEST:.0e}", line)
    return value


def joint_name(path: str | Path, words: list[str], line: int) -> str:
    """A joint's name. Raises RecordingError where it is missing or absurdly long."""
    name = " ".join(words)
    if not name:
        raise RecordingError(path, "a joint without a name", "a name", line)
    if len(name) > MAX_NAME:
        raise RecordingError(path, f"a joint name of {len(name)} characters", f"at most {MAX_NAME}", line)
    return name
