"""Names that people give: what is allowed, and paths that stay inside a folder."""

from __future__ import annotations

import re
import unicodedata
from pathlib import Path

from core.workspace.errors import NameRefused

MAX_LENGTH = 100
_FORBIDDEN = set('/\\:*?"<>|')
_RESERVED = {"CON", "PRN", "AUX", "NUL", *(f"{d}{i}" for d in ("COM", "LPT") for i in range(1, 10))}
# Control, format (bidi overrides, zero width), surrogate, private; line and paragraph separators.
_UNSEEN = {"Cc", "Cf", "Cs", "Co", "Cn", "Zl", "Zp"}
_TOKEN = re.compile(r"[0-9a-f]{8,64}")


def check_name(name: str, what: str = "dataset") -> str:
    """``name`` trimmed and in Unicode's composed form (NFC); raises NameRefused, which says why."""
    if not isinstance(name, str):
        raise NameRefused(f"The name of a {what} must be text.")
    name = unicodedata.normalize("NFC", name).strip()
    reason = _refusal(name)
    if reason:
        shown = clean_name(name)[:40]
        raise NameRefused(f"A {what} cannot have this name: {reason}. How about {shown!r}?")
    return name


def clean_name(text: str, default: str = "unnamed") -> str:
    """A usable name made from any text: what is not allowed becomes ``_``; ``default`` where nothing is left."""
    text = unicodedata.normalize("NFC", text if isinstance(text, str) else "")
    text = "".join("_" if c in _FORBIDDEN or unicodedata.category(c) in _UNSEEN else c for c in text)
    text = text.strip().lstrip(".~").rstrip(". ").strip()
    while len(text) > MAX_LENGTH or len(text.encode()) > 2 * MAX_LENGTH:
        text = _shorter(text)
    if not text.strip("_ ."):
        return default
    return f"{text}_" if text.split(".")[0].upper() in _RESERVED else text


def check_token(token: str, what: str) -> str:
    """``token`` where it has the form of the tokens we hand out (hexadecimal); raises NameRefused otherwise."""
    if not isinstance(token, str) or not _TOKEN.fullmatch(token):
        raise NameRefused(f"This is not a valid {what}.")
    return token


def inside(root: Path, *parts: str) -> Path:
    """The path ``root/parts...``; raises NameRefused when it leaves ``root`` (``..``, absolute, symbolic links)."""
    if any("\0" in part for part in parts):
        raise NameRefused("A name contains a NUL character.")
    root = root.resolve()
    path = root.joinpath(*parts)
    resolved = path.resolve()
    if resolved == root or not resolved.is_relative_to(root):
        raise NameRefused("A name points outside the workspace.")
    return path


def _refusal(name: str) -> str:
    unseen = [c for c in name if unicodedata.category(c) in _UNSEEN]
    forbidden = sorted(_FORBIDDEN.intersection(name))
    if not name:
        return "it is empty"
    if unseen:
        return f"it contains an invisible character (U+{ord(unseen[0]):04X})"
    if forbidden:
        return f"it contains {' '.join(forbidden)}"
    if name.startswith(".") or name.endswith("."):
        return "it starts or ends with a dot"
    if name.startswith("~"):
        return "it starts with ~, which stands for motion that is made up"
    if len(name) > MAX_LENGTH or len(name.encode()) > 2 * MAX_LENGTH:
        return f"it is longer than {MAX_LENGTH} letters"
    if name.split(".")[0].upper() in _RESERVED:
        return f"{name.split('.')[0]} is reserved by some systems"
    return ""


def _shorter(text: str) -> str:
    """One character less, from the end of the stem, so that the suffix (``.bvh.gz``) stays."""
    stem, dot, suffix = text.partition(".")
    if not dot or not stem or len(suffix) > 20:
        return text[:-1]
    return stem[:-1] + dot + suffix
