"""Damaged files for every reader: nothing but the product's own errors, no reading over 5 s, no memory over 1 GB.

usage: python -m benchmarks.fuzz_readers [SECONDS] [SEED]

Small recordings (and, where they are there, the shared odd ones) are mutated over and over: bytes, words and lines are
changed, repeated, moved or cut. A mutant that breaks a rule is kept in the temporary folder and named.
"""

from __future__ import annotations

import gzip
import io
import json
import os
import random
import resource
import signal
import struct
import sys
import tempfile
import time
import zipfile
from collections import Counter
from collections.abc import Callable
from pathlib import Path

import numpy as np

from core.errors import MotionscapeError
from core.inspection import inspect_file
from core.mocap.asfamc import read_amc, read_asf
from core.mocap.bvh import read_bvh_clips
from core.mocap.corrections import read_corrections
from core.mocap.gltf_writer import write_glb
from core.mocap.labels import read_labels
from core.mocap.readers import is_recording, read_clips
from core.mocap.reading import Reading, settled
from core.progress import silent
from core.workspace.archives import unpack_archives

LONGEST = 5.0  # seconds a reading may take
MOST = 1 << 30  # bytes that reading may add to the process
LARGE = 200_000  # bytes: seeds beyond it are left out, so that many mutants are tried

BVH = """HIERARCHY
ROOT Hips
{
  OFFSET 0 0 0
  CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
  JOINT Chest
  {
    OFFSET 0 20 0
    CHANNELS 3 Zrotation Xrotation Yrotation
    End Site
    {
      OFFSET 0 50 0
    }
  }
}
MOTION
Frames: 12
Frame Time: 0.0333333
""" + "".join(f"0 9{k} 0 0.5 -2 0.5 {k}.25 0 -1e-3\n" for k in range(12))
ASF = """:version 1.10
:units
  mass 1.0
  length 0.45
  angle deg
:root
  order TX TY TZ RX RY RZ
  axis XYZ
  position 0 0 0
  orientation 0 0 0
:bonedata
  begin
    id 1
    name femur
    direction 0 -1 0
    length 7.2
    axis 10 -30 20 XYZ
    dof rx rz
    limits (-90 90)
           (-90 90)
  end
:hierarchy
  begin
    root femur
  end
"""
AMC = "#!OML\n:FULLY-SPECIFIED\n:DEGREES\n" + "".join(f"{k}\nroot 0 17 {k} 0 1 0\nfemur -10 5\n" for k in range(1, 13))
LABELS = "clip,start_frame,end_frame,action\nwalk,0,10,walk\nwalk,10,20,stop\n"
TRC = (
    "PathFileType\t4\t(X/Y/Z)\ta.trc\nDataRate\tCameraRate\tNumFrames\tNumMarkers\tUnits\n60\t60\t12\t2\tmm\n"
    "Frame#\tTime\tLASI\t\t\tRASI\t\t\n\t\tX1\tY1\tZ1\tX2\tY2\tZ2\n\n"
) + "".join(f"{k}\t{k / 60:.3f}\t1{k}.5\t2\t900\t\t\t\n" for k in range(12))
_AXES = [f"{name}_{axis}" for name in ("hips", "l_knee", "r_knee", "head") for axis in "xyz"]
POINTS_CSV = f"time,{','.join(_AXES)}\n" + "".join(f"{k / 30:.4f}{f',{k}.5,1e-1,-2' * 4}\n" for k in range(12))
TIDY_CSV = "frame,joint,x,y,z\n" + "".join(f"{k},{j},{k},0.5,1\n" for k in range(9) for j in ("head", "hips", "knee"))
NUMBERED = "".join(f"{4 * k} " + " ".join(f"{(j + k) / 7:.4f}" for j in range(60)) + "\n" for k in range(12))
MOT = "Coordinates\ninDegrees=yes\nendheader\ntime\tknee_angle_r\tpelvis_tx\n" + "".join(
    f"{k / 100}\t{k}.5\t0.{k}\n" for k in range(9)
)
_FRAMES = "".join(
    f'<frame type="normal"><orientation>1 0 0 0 1 0 0 0</orientation><position>0 {k} 1 0 0 1.2</position></frame>'
    for k in range(5)
)
MVNX = (
    '<mvnx><subject frameRate="60"><segments><segment label="Pelvis" id="1"/><segment label="L5" id="2"/></segments>'
    f"<frames>{_FRAMES}</frames></subject></mvnx>"
)
POINTS_JSON = json.dumps([{"joints": {j: [k, 0.5, 1] for j in ("head", "hips", "knee")}} for k in range(9)])
ARRAY_JSON = json.dumps({"fps": 30, "joints": [[[k, j, 1] for j in range(17)] for k in range(9)]})
BODY = '{"format": "motionscape/body/1", "rigs": [{"rig": ["a", "b"], "body": null, "joints": {"head": "b"}}]}'
_ODD_NUMBERS = b"nan inf -inf 1e400 -1.#IND 0x1A 1,5 99999999999999999999 -1 0 1e-320 null 5-2".split()
_KEYWORDS = b"{ } MOTION HIERARCHY ROOT JOINT End Site OFFSET CHANNELS Frames: Frame Time: EndSite # //".split()
_SECTIONS = b":root :bonedata :units :hierarchy begin end dof limits 7 Xposition Zrotation Xscale".split()
_BYTES = (
    b"\xff\xfe",
    b"\x00",
    b"\xef\xbb\xbf",
    b"\r",
    b"\n\n\n",
    b"{" * 400,
    b"9" * 400,
    b"a" * 3000,
    b"-" * 50,
    b"\xe4\xf6",
)
_WORDS = (*_ODD_NUMBERS, *_KEYWORDS, *_SECTIONS, *_BYTES)


def mutated(data: bytes, chance: random.Random) -> bytes:
    """The bytes with one to six changes."""
    for _ in range(chance.choice((1, 1, 1, 2, 2, 3, 6))):
        data = chance.choice(_CHANGES)(data, chance) or b""
    return data


def _place(data: bytes, chance: random.Random) -> tuple[int, int]:
    start = chance.randrange(len(data) + 1)
    return start, min(len(data), start + chance.choice((1, 4, 30, 300)))


def _flip(data: bytes, chance: random.Random) -> bytes:
    start, _ = _place(data, chance)
    return data[:start] + bytes([chance.randrange(256)]) + data[start + 1 :]


def _cut(data: bytes, chance: random.Random) -> bytes:
    start, end = _place(data, chance)
    return data[:start] if chance.random() < 0.3 else data[:start] + data[end:]


def _repeat(data: bytes, chance: random.Random) -> bytes:
    start, end = _place(data, chance)
    return data[:end] + data[start:end] * chance.choice((1, 2, 50)) + data[end:]


def _put(data: bytes, chance: random.Random) -> bytes:
    start, _ = _place(data, chance)
    space = b"" if chance.random() < 0.3 else b" "
    return data[:start] + space + chance.choice(_WORDS) + space + data[start:]


def _exchange_word(data: bytes, chance: random.Random) -> bytes:
    words = data.split(b" ")
    words[chance.randrange(len(words))] = chance.choice(_WORDS)
    return b" ".join(words)


def _move_line(data: bytes, chance: random.Random) -> bytes:
    lines = data.split(b"\n")
    line = lines.pop(chance.randrange(len(lines)))
    lines.insert(chance.randrange(len(lines) + 1), line)
    return b"\n".join(lines)


def _re_encode(data: bytes, chance: random.Random) -> bytes:
    text = data.decode("latin-1")
    return text.encode(chance.choice(("utf-16", "utf-16-be", "utf-8-sig", "utf-32")))


_CHANGES: tuple[Callable[[bytes, random.Random], bytes], ...] = (
    *(_flip, _cut, _repeat, _put, _put, _exchange_word, _exchange_word, _move_line),
    _re_encode,
)


class Readers:
    """Every reader by the format of its files, each given a path in a folder of its own."""

    def __init__(self, folder: Path):
        self.folder = folder
        (folder / "good.asf").write_text(ASF)
        self.skeleton = read_asf(folder / "good.asf")
        self.by_format: dict[str, tuple[Callable[[Path], object], list[bytes]]] = {
            ".bvh": (read_bvh_clips, [BVH.encode()]),
            ".bvh.gz": (read_bvh_clips, [gzip.compress(BVH.encode())]),
            ".asf": (read_asf, [ASF.encode()]),
            ".amc": (lambda path: read_amc(path, self.skeleton), [AMC.encode()]),
            "_inspected.bvh": (inspect_file, [BVH.encode()]),
            "_labels.csv": (read_labels, [LABELS.encode()]),
            "_body.json": (read_corrections, [BODY.encode()]),
            ".trc": (read_any, [TRC.encode()]),
            ".csv": (read_any, [POINTS_CSV.encode(), TIDY_CSV.encode()]),
            ".glb": (read_any, [_glb(self.folder)]),
            ".mvnx": (read_any, [MVNX.encode()]),
            ".mot": (read_any, [MOT.encode()]),
            ".c3d": (read_any, [_c3d(), _c3d(">")]),
            ".txt": (read_any, [NUMBERED.encode()]),
            ".json": (read_any, [POINTS_JSON.encode(), ARRAY_JSON.encode()]),
            ".npy": (read_any, [_npy()]),
            ".npz": (read_any, [_npz(), _poses()]),
            ".zip": (self.unpack, [_zip(), _zip("gähen.bvh")]),
        }

    def unpack(self, path: Path) -> object:
        """The zip file unpacked beside itself, as an upload is."""
        place = Path(tempfile.mkdtemp(dir=self.folder))
        path.rename(place / path.name)
        return unpack_archives(place, silent)

    def add_shared(self, data: Path) -> None:
        """The shared odd files as seeds, where they are there and small."""
        for path in sorted(
            p for name in ("wild", "malformed", "formats") for p in (data / name).rglob("*") if p.is_file()
        ):
            if path.suffix in self.by_format and path.stat().st_size < LARGE:
                self.by_format[path.suffix][1].append(path.read_bytes())


def read_any(path: Path) -> object:
    """A file of any format as an import reads it, whatever its beginning looks like."""
    is_recording(path)
    return [settled(clip, Reading()) for clip in read_clips(path, Reading())]


def _c3d(order: str = "<") -> bytes:
    """Six frames of three points, in integers."""
    labels, count = b"LASIRASISACR", 3
    parameters = struct.pack("bb", 5, -1) + b"POINT" + struct.pack(f"{order}h", 3) + b"\0"
    body = struct.pack("bB", -1, 2) + bytes([4, count]) + labels + b"\0"
    parameters += struct.pack("bb", 6, 1) + b"LABELS" + struct.pack(f"{order}h", len(body) + 2) + body
    head = struct.pack(f"{order}BBHHHHHf", 2, 80, count, 0, 1, 6, 10, 0.1) + struct.pack(f"{order}HHf", 3, 0, 50.0)
    block = bytes([1, 80, 1, 84 if order == "<" else 86]) + parameters
    data = b"".join(struct.pack(f"{order}4h", k, 100 * j, 900, 0) for k in range(6) for j in range(count))
    return head.ljust(512, b"\0") + block.ljust(512, b"\0") + data


def _glb(folder: Path) -> bytes:
    (folder / "seed.bvh").write_text(BVH)
    write_glb(folder / "seed.glb", read_bvh_clips(folder / "seed.bvh")[0])
    return (folder / "seed.glb").read_bytes()


def _npy() -> bytes:
    file = io.BytesIO()
    np.save(file, np.random.default_rng(0).normal(size=(6, 17, 3)).astype(np.float32))
    return file.getvalue()


def _npz() -> bytes:
    file = io.BytesIO()
    np.savez(file, joints=np.random.default_rng(0).normal(size=(6, 22, 3)), fps=30)
    return file.getvalue()


def _poses() -> bytes:
    file = io.BytesIO()
    np.savez(file, poses=np.zeros((6, 72)), trans=np.zeros((6, 3)), mocap_framerate=60)
    return file.getvalue()


def _zip(name: str = "walks/walk.bvh") -> bytes:
    file = io.BytesIO()
    with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr(name, BVH)
        archive.writestr("labels.csv", LABELS)
    return file.getvalue()


def read_one(read: Callable[[Path], object], path: Path) -> str:
    """What came of reading: "read", "refused", or the rule that was broken. Raises nothing of the reader's."""

    def too_long(_signal: int, _frame: object) -> None:
        raise TimeoutError(f"over {LONGEST:g} s")

    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    old = signal.signal(signal.SIGALRM, too_long)
    signal.setitimer(signal.ITIMER_REAL, LONGEST)
    try:
        read(path)
        outcome = "read"
    except MotionscapeError as error:
        outcome = "refused" if "\n" not in str(error) else "a message of several lines"
    except Exception as error:  # this is what is looked for
        outcome = f"{type(error).__name__}: {str(error)[:80]}"
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, old)
    grown = (resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before) * 1024
    return outcome if grown < MOST else f"took {grown >> 20} MB"


def main(seconds: float = 60.0, seed: int = 0, data: Path | None = None) -> int:
    """Tries mutants for so long; prints what came of them, and gives the number that broke a rule."""
    chance, outcomes, broken = random.Random(seed), Counter[tuple[str, str]](), 0
    with tempfile.TemporaryDirectory() as place:
        readers = Readers(Path(place))
        here = Path(__file__).resolve().parents[1]
        readers.add_shared(data or Path(os.environ.get("MOTIONSCAPE_SHARED", here.parent / "shared")) / "data")
        for read, seeds in readers.by_format.values():  # compiled, or loaded from numba's cache, before the clock runs
            (Path(place) / "first.bvh").write_bytes(seeds[0])
            read_one(read, Path(place) / "first.bvh")
        until, k = time.monotonic() + seconds, 0
        while time.monotonic() < until:
            ending = list(readers.by_format)[k % len(readers.by_format)]
            read, seeds = readers.by_format[ending]
            path = Path(place) / f"mutant{k}{ending}"
            content = mutated(seeds[0] if chance.random() < 0.5 else chance.choice(seeds), chance)
            path.write_bytes(content)
            outcome = read_one(read, path)
            outcomes[ending, outcome if outcome in ("read", "refused") else "BROKEN"] += 1
            if outcome not in ("read", "refused"):
                broken += 1
                kept = Path(tempfile.gettempdir()) / f"fuzz-{seed}-{k}{ending}"
                kept.write_bytes(content)
                print(f"{kept}: {outcome}")
            path.unlink(missing_ok=True)
            k += 1
    print(f"{sum(outcomes.values())} mutants, seed {seed}: {broken} broke a rule")
    for (ending, outcome), count in sorted(outcomes.items()):
        print(f"  {ending:<16}{outcome:<10}{count:8}")
    return broken


if __name__ == "__main__":
    sys.exit(1 if main(*(float(a) if k == 0 else int(a) for k, a in enumerate(sys.argv[1:3]))) else 0)
