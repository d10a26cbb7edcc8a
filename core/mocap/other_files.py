"""Files that are not read: what they are, and how their motion can be had as BVH."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path

from core.mocap.text import recording_format

_BLENDER = "open it in Blender and export BVH"
# Every file of a folder as GLB, in one line.
_BLENDER_FOLDER = (
    'open it in Blender and export BVH, or make GLB of all in a folder: blender -b --python-expr "import bpy, glob; '
    "[(bpy.ops.wm.read_factory_settings(use_empty=True), bpy.ops.import_scene.fbx(filepath=f), "
    "bpy.ops.export_scene.gltf(filepath=f[:-4] + '.glb')) for f in glob.glob('*.fbx')]\""
)
_PICKLE = (
    "it may run code when opened and is never read; where you trust it, load it in Python and save its arrays with "
    "numpy.savez('take.npz', poses=..., trans=..., mocap_framerate=60)"
)
_ARRAYS = "no joints or poses are recognised in it; save joints as an array (frames, joints, 3)"
# How a file's name ends -> what the format is called, and how to come to BVH.
_MOTION = {
    ".fbx": ("FBX", _BLENDER_FOLDER),
    ".dae": ("Collada", _BLENDER),
    ".usd": ("USD", _BLENDER),
    ".usda": ("USD", _BLENDER),
    ".usdc": ("USD", _BLENDER),
    ".usdz": ("USD", _BLENDER),
    ".abc": ("Alembic", "it holds surfaces and no skeleton; export BVH from the scene it came from"),
    ".blend": ("Blender file", "export BVH from Blender"),
    ".vmd": ("VMD", "open it in Blender with the MMD Tools add-on, on its model, and export BVH"),
    ".vpd": ("VPD", "open it in Blender with the MMD Tools add-on, on its model, and export BVH"),
    ".pmx": ("PMX", "it is a model without motion"),
    ".pmd": ("PMD", "it is a model without motion"),
    ".trb": ("TRB", "it holds markers; solve a skeleton with the program that recorded it and export BVH"),
    ".npz": ("NumPy arrays", _ARRAYS),
    ".npy": ("NumPy array", _ARRAYS),
    ".pkl": ("pickle", _PICKLE),
    ".pickle": ("pickle", _PICKLE),
    ".pt": ("PyTorch file", "it may run code when opened and is never read; convert the poses to BVH"),
    ".mat": ("MATLAB file", "convert the poses to BVH"),
    ".h5": ("HDF5", "convert the poses to BVH"),
    ".hdf5": ("HDF5", "convert the poses to BVH"),
    ".bip": ("Biped BIP", "load it on a Biped in 3ds Max and export BVH"),
    ".csm": ("Character Studio CSM", "load it on a Biped in 3ds Max and export BVH"),
    ".htr": ("HTR", "open it in MotionBuilder and export BVH"),
    ".ma": ("Maya file", "export FBX from Maya and, through Blender, BVH"),
    ".mb": ("Maya file", "export FBX from Maya and, through Blender, BVH"),
    ".max": ("3ds Max file", "export BVH or FBX from 3ds Max"),
    ".anim": ("animation clip", "export FBX from Unity or Maya and, through Blender, BVH"),
    ".v": ("Vicon V", "export BVH from the program that recorded it"),
    ".tak": ("Motive take", "export BVH from Motive"),
    ".mvn": ("Xsens MVN", "export BVH from MVN"),
    ".zip": ("zip", "unpack it, or drop it on the Library page"),
    ".7z": ("7z", "unpack it"),
    ".rar": ("rar", "unpack it"),
    ".tar": ("tar", "unpack it"),
    ".tgz": ("tar", "unpack it"),
    ".mp4": ("video", "motion is not read from video; a pose tracker makes BVH of it"),
    ".mov": ("video", "motion is not read from video; a pose tracker makes BVH of it"),
    ".avi": ("video", "motion is not read from video; a pose tracker makes BVH of it"),
    ".webm": ("video", "motion is not read from video; a pose tracker makes BVH of it"),
}
_READ_BESIDE = (".asf", ".bin", ".csv")  # skeletons, buffers of glTF and labels, read with the recordings
_NAMED = 3


@dataclass(frozen=True)
class LeftOut:
    """Files of one format that were left out. advice: how to have their motion, empty where they hold none."""

    format: str
    files: tuple[str, ...]
    advice: str = ""

    @property
    def words(self) -> str:
        """Count and format: ``3 FBX``, ``1 other file (notes.txt)``."""
        names = ", ".join(_shown(file) for file in self.files[:_NAMED])
        more = ", ..." if len(self.files) > _NAMED else ""
        if self.advice:
            return f"{len(self.files)} {self.format} ({names}{more})"
        return f"{len(self.files)} other file{'s' * (len(self.files) > 1)} ({names}{more})"


def left_out_files(files: Iterable[str | Path], read: Sequence[str]) -> tuple[LeftOut, ...]:
    """What of these files (paths) is not read, by format, those with motion first.

    read: how the names of recordings end; skeletons and label files are read beside them.
    """
    groups: dict[tuple[str, str], list[str]] = {}
    for file in files:
        ending = recording_format(file)[1]
        if ending in read or ending in _READ_BESIDE:
            continue
        groups.setdefault(_MOTION.get(ending, ("", "")), []).append(str(file))
    found = [LeftOut(name, tuple(paths), advice) for (name, advice), paths in groups.items()]
    return tuple(sorted(found, key=lambda group: (not group.advice, -len(group.files), group.format)))


def in_words(groups: Sequence[LeftOut]) -> str:
    """One sentence: ``3 FBX, 1 VMD left out: ...`` with the way to convert each; empty where nothing is left out."""
    if not groups:
        return ""
    ways: dict[str, list[str]] = {}
    for group in groups:
        if group.advice:
            ways.setdefault(group.advice, []).append(group.format)
    advice = "; ".join(f"{', '.join(formats)}: {way}" for way, formats in ways.items())
    return ", ".join(group.words for group in groups) + " left out" + (f": {advice}" if advice else "")


def what_it_is(path: str | Path) -> str:
    """What a single file is that is no recording, and what to do: ``an FBX file; open it in Blender ...``; or empty."""
    name, advice = _MOTION.get(recording_format(path)[1], ("", ""))
    return f"this is {name}; {advice}" if name else ""


def _shown(file: str) -> str:
    name = Path(file).name
    return "".join(c if c.isprintable() else "?" for c in name[:60])
