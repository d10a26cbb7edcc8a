"""The container of glTF 2.0: JSON, buffers and accessors, from ``.glb`` (VRM, VRMA) and ``.gltf`` files.

Written here because what is needed is small, and because files of strangers are read within limits: nothing outside
the file's own folder, and no number in it that is believed before the bytes are there.
"""

from __future__ import annotations

import base64
import binascii
import json
import struct
from pathlib import Path
from typing import Any

import numpy as np

from core.mocap.errors import RecordingError
from core.mocap.text import decoded, read_binary

_MAGIC, _JSON, _BIN = b"glTF", 0x4E4F534A, 0x004E4942
_COMPONENTS = {5120: "i1", 5121: "u1", 5122: "i2", 5123: "u2", 5125: "u4", 5126: "f4"}
_SIZES = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT2": 4, "MAT3": 9, "MAT4": 16}
_MOST = 20_000_000  # numbers of an accessor
_NOT_READ = ("EXT_meshopt_compression", "KHR_draco_mesh_compression")


class Gltf:
    """A glTF document. Lists of it are given with what is no object left out, so faults of a file do no harm."""

    def __init__(self, path: Path):
        self.path = path
        data = read_binary(path)
        self._binary = b""
        if data.startswith(_MAGIC):
            text, self._binary = _chunks(path, data)
        else:
            text = data
        try:
            document = json.loads(decoded(text.removeprefix(b"\xef\xbb\xbf")))
        except (ValueError, RecursionError) as error:
            raise RecordingError(path, f"not JSON ({' '.join(str(error).split())[:60]})", "glTF") from None
        if not isinstance(document, dict) or not isinstance(document.get("asset"), dict):
            raise RecordingError(path, "no asset in it", "glTF 2.0")
        if str(document["asset"].get("version", "")).startswith("1"):
            raise RecordingError(path, "glTF 1.0", "glTF 2.0; open it in Blender and export it anew")
        self.document = document
        self._buffers: dict[int, bytes] = {}

    def list_of(self, name: str) -> list[dict[str, Any]]:
        """The objects of a list of the document."""
        entries = self.document.get(name)
        return [entry if isinstance(entry, dict) else {} for entry in entries] if isinstance(entries, list) else []

    def accessor(self, index: Any) -> np.ndarray:
        """Numbers ``(count, size)`` of an accessor as float64, normalised ones from -1 to 1; or RecordingError."""
        entry = self._entry("accessors", index)
        count, size = entry.get("count"), _SIZES.get(str(entry.get("type")), 0)
        if not isinstance(count, int) or not size or not 0 <= count * size <= _MOST:
            raise RecordingError(
                self.path, f"an accessor of {str(count)[:20]} {str(entry.get('type'))[:10]}", "a sane one"
            )
        values = np.zeros((count, size))
        if "bufferView" in entry:
            values[:] = self._view(entry, count, size)
        if isinstance(sparse := entry.get("sparse"), dict):
            self._put_sparse(values, entry, sparse)
        return values

    def _entry(self, name: str, index: Any) -> dict[str, Any]:
        entries = self.list_of(name)
        if not isinstance(index, int) or isinstance(index, bool) or not 0 <= index < len(entries):
            raise RecordingError(self.path, f"no number {str(index)[:20]} among {name}", "a whole glTF file")
        return entries[index]

    def _view(self, entry: dict[str, Any], count: int, size: int) -> np.ndarray:
        view = self._entry("bufferViews", entry["bufferView"])
        if isinstance(view.get("extensions"), dict) and any(name in view["extensions"] for name in _NOT_READ):
            raise RecordingError(self.path, "its motion is compressed (meshopt)", "plain glTF; unpack it with gltfpack")
        kind = np.dtype("<" + _COMPONENTS.get(_whole(entry.get("componentType")), "V1"))
        if kind.kind == "V":
            raise RecordingError(self.path, f"component type {str(entry.get('componentType'))[:10]}", "one of glTF 2.0")
        data = self._buffer(view.get("buffer"))
        start, length = _whole(view.get("byteOffset")), _whole(view.get("byteLength"))
        own, width = _whole(entry.get("byteOffset")), kind.itemsize * size
        stride = _whole(view.get("byteStride")) or width
        need = own + (count - 1) * stride + width if count else 0
        if min(start, length, own) < 0 or stride < width or need > length or start + length > len(data):
            raise RecordingError(self.path, "an accessor reaches beyond its buffer", "a whole glTF file")
        if not count:
            return np.zeros((0, size))
        raw = np.frombuffer(data, np.uint8, need, start)[own:]
        rows = np.lib.stride_tricks.as_strided(raw, (count, width), (stride, 1))
        values = np.ascontiguousarray(rows).view(kind).reshape(count, size).astype(float)
        if entry.get("normalized") and kind.kind in "iu":
            values = np.maximum(values / np.iinfo(kind).max, -1.0)
        return values

    def _put_sparse(self, values: np.ndarray, entry: dict[str, Any], sparse: dict[str, Any]) -> None:
        count = sparse.get("count")
        where, what = sparse.get("indices"), sparse.get("values")
        if not isinstance(count, int) or not isinstance(where, dict) or not isinstance(what, dict):
            raise RecordingError(self.path, "a damaged sparse accessor", "a whole glTF file")
        if not 0 <= count <= len(values) or "bufferView" not in where or "bufferView" not in what:
            raise RecordingError(self.path, "a damaged sparse accessor", "a whole glTF file")
        at = self._view(where, count, 1)[:, 0].astype(np.int64)
        if ((at < 0) | (at >= len(values))).any():
            raise RecordingError(self.path, "a sparse accessor reaches beyond its numbers", "a whole glTF file")
        fields = {"componentType": entry.get("componentType"), "normalized": entry.get("normalized")}
        values[at] = self._view(fields | what, count, values.shape[1])

    def _buffer(self, index: Any) -> bytes:
        entry = self._entry("buffers", index)
        if index not in self._buffers:
            self._buffers[index] = self._load(entry)
        return self._buffers[index]

    def _load(self, entry: dict[str, Any]) -> bytes:
        uri = entry.get("uri")
        if uri is None:
            return self._binary
        if not isinstance(uri, str):
            raise RecordingError(self.path, "a buffer without a place", "a whole glTF file")
        if uri.startswith("data:"):
            try:
                return base64.b64decode(uri.partition(",")[2], validate=False)
            except (binascii.Error, ValueError):
                raise RecordingError(self.path, "a damaged buffer", "base64") from None
        name = Path(uri.replace("%20", " "))
        beside = self.path.parent / name
        if name.is_absolute() or ".." in name.parts or ":" in uri or "\0" in uri or not beside.is_file():
            raise RecordingError(
                self.path, f"its buffer {name.name[:60]!r} is not beside it", "both files together, or GLB"
            )
        return read_binary(beside)


def _chunks(path: Path, data: bytes) -> tuple[bytes, bytes]:
    """JSON and binary of a GLB file."""
    found = {_JSON: b"", _BIN: b""}
    if len(data) < 20 or struct.unpack_from("<I", data, 4)[0] != 2:
        raise RecordingError(path, "no GLB of version 2", "glTF 2.0")
    at = 12
    while at + 8 <= len(data):
        length, kind = struct.unpack_from("<II", data, at)
        body = data[at + 8 : at + 8 + length]
        if len(body) < length:
            raise RecordingError(path, "the file is cut off", "a whole GLB file")
        if kind in found and not found[kind]:
            found[kind] = body
        at += 8 + length + (-length % 4)
    return found[_JSON], found[_BIN]


def _whole(value: Any) -> int:
    return value if isinstance(value, int) and not isinstance(value, bool) and abs(value) < 2**40 else 0
