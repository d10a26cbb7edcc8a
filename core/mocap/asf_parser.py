"""The text of an ASF file, checked line by line, as plain values in the file's own units."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path

from core.mocap.errors import RecordingError
from core.mocap.reports import Finding
from core.mocap.text import MAX_NAME, number, quoted

Line = tuple[int, list[str]]
_ROOT_DOF = ("tx", "ty", "tz", "rx", "ry", "rz")
_BONE_DOF = ("rx", "ry", "rz", "tx", "ty", "tz", "l")
_TURNS = ("rx", "ry", "rz")


@dataclass
class RawBone:
    """A bone as the file gives it: unit direction, length, axis angles, order of rotations, degrees of freedom."""

    name: str
    line: int
    direction: tuple[float, ...] | None = None
    length: float | None = None
    axis: tuple[float, ...] = (0.0, 0.0, 0.0)
    order: str = "xyz"
    dof: tuple[str, ...] = ()
    limits: int = 0


@dataclass
class RawAsf:
    """The sections of a file. ``parents`` and ``children`` are by name; the root is called "root"."""

    length_unit: float = 1.0
    radians: bool = False
    root: RawBone = field(default_factory=lambda: RawBone("root", 0))
    root_position: tuple[float, ...] = (0.0, 0.0, 0.0)
    bones: dict[str, RawBone] = field(default_factory=dict)
    parents: dict[str, str] = field(default_factory=dict)
    children: dict[str, list[str]] = field(default_factory=dict)
    notes: list[str] = field(default_factory=list)
    findings: list[Finding] = field(default_factory=list)


def parse_asf(path: str | Path, text: str) -> RawAsf:
    """Parse and check the text of an ASF file. Raises RecordingError with the line of the first fault."""
    return _Parser(path).parse(text)


class _Parser:
    def __init__(self, path: str | Path):
        self.path, self.asf = path, RawAsf()
        self.uneven: list[str] = []  # bones whose direction is no unit vector
        self.limits: list[str] = []  # bones whose limits do not fit their degrees of freedom
        self.stretched: list[str] = []  # bones that may also shift or become longer
        self.ignored: dict[str, int] = {}  # unknown keywords -> line

    def error(self, found: str, expected: str = "", line: int | None = None) -> RecordingError:
        """An error that names the file, and the line where it is known."""
        return RecordingError(self.path, found, expected, line)

    def parse(self, text: str) -> RawAsf:
        """Reads the whole text. Raises RecordingError where a section is missing or damaged."""
        sections = self.sections(text)
        readers = {"units": self.units, "root": self.root, "bonedata": self.bonedata, "hierarchy": self.hierarchy}
        for name, read in readers.items():
            if name in sections:
                read(*sections[name])
            elif name != "units":
                raise self.error(f"no :{name} section", "an ASF skeleton with :root, :bonedata and :hierarchy")
        self.check()
        self.say()
        return self.asf

    def say(self) -> None:
        """What was passed over or mended."""
        if self.uneven:
            words = f"the direction of {_some(self.uneven)} is no unit vector: made one"
            self.asf.findings.append(Finding("direction", words))
        if self.stretched:
            words = f"{_some(self.stretched)} may shift or change length (dof l, tx, ty, tz): these values are left out"
            self.asf.findings.append(Finding("dof", words))
        if self.limits:
            words = f"the limits of {_some(self.limits)} do not fit the degrees of freedom: limits are not used"
            self.asf.findings.append(Finding("limits", words))
        if self.ignored:
            self.asf.notes.append(f"unknown words in :bonedata, left out: {_some(list(self.ignored))}")

    def sections(self, text: str) -> dict[str, tuple[int, list[Line]]]:
        """Name -> line of its heading and its lines, as words; comments and blank lines left out."""
        found: dict[str, tuple[int, list[Line]]] = {}
        lines: list[Line] | None = None
        for at, raw in enumerate(text.split("\n"), 1):
            words = (raw if "#" not in raw else re.split(r"(?:^|\s)#", raw)[0]).split()
            if not words:
                continue
            if words[0].startswith(":"):
                name = words[0][1:].lower()
                if name in found:
                    raise self.error(f"a second :{name[:40]} section", "one", at)
                lines = [(at, words[1:])] if words[1:] else []
                found[name] = (at, lines)
            elif lines is None:
                raise self.error(f"{quoted(words[0])}", "a section such as :units, as in every ASF skeleton", at)
            else:
                lines.append((at, words))
        return found

    def units(self, at: int, lines: list[Line]) -> None:
        """The unit of length and that of angles. Raises RecordingError for an angle that is none, or a length of 0."""
        pairs = [(line, words[k : k + 2]) for line, words in lines for k in range(0, len(words), 2)]
        for line, words in pairs:
            key, value = words[0].lower(), words[1] if len(words) > 1 else ""
            if key == "length":
                self.asf.length_unit = number(self.path, value, line, "a length unit")
                if self.asf.length_unit < 1e-6:
                    raise self.error(f"length unit {value}", "a positive number", line)
            elif key == "angle":
                if value.lower()[:3] not in ("deg", "rad"):
                    raise self.error(f"angle unit {quoted(value)}", "deg or rad", line)
                self.asf.radians = value.lower().startswith("rad")

    def root(self, at: int, lines: list[Line]) -> None:
        """The root's channels, axes, place and turn."""
        root = RawBone("root", at, dof=_ROOT_DOF)
        for line, words in lines:
            key, values = words[0].lower(), words[1:]
            if key == "order":
                root.dof = self.dof(values, line, _ROOT_DOF)
            elif key == "axis":
                root.order = self.order(values, line)
            elif key == "position":
                self.asf.root_position = self.numbers(values, 3, line, "position")
            elif key == "orientation":
                root.axis = self.numbers(values, 3, line, "orientation")
        self.asf.root = root

    def bonedata(self, at: int, lines: list[Line]) -> None:
        """All bones. Raises RecordingError where there is none, or one comes twice."""
        for start, block in self.blocks(at, lines):
            bone = self.bone(start, block)
            if bone.name in self.asf.bones or bone.name == "root":
                raise self.error(f"a second bone {quoted(bone.name)}", "each bone once", start)
            self.asf.bones[bone.name] = bone
        if not self.asf.bones:
            raise self.error(":bonedata without bones", "at least one bone", at)

    def blocks(self, at: int, lines: list[Line]) -> Iterator[tuple[int, list[Line]]]:
        """What stands between each ``begin`` and ``end``."""
        block: list[Line] | None = None
        for line, words in lines:
            word = words[0].lower()
            if word == "begin" and block is None:
                at, block = line, []
            elif word == "end" and block is not None:
                yield at, block
                block = None
            elif block is None or word == "begin":
                raise self.error(quoted(words[0]), "'begin'" if block is None else "'end' before it", line)
            else:
                block.append((line, words))
        if block is not None:
            raise self.error("'begin' without 'end': the file is cut off", "'end'", at)

    def bone(self, start: int, block: list[Line]) -> RawBone:
        """One bone from the lines between ``begin`` and ``end``. Raises RecordingError for a line that means
        nothing.
        """
        bone = RawBone("", start)
        for line, words in block:
            key, values = words[0].lower(), words[1:]
            if key == "name":
                bone.name = self.name(values, line)
            elif key == "direction":
                bone.direction = self.numbers(values, 3, line, "direction")
            elif key == "length":
                bone.length = self.numbers(values, 1, line, "length")[0]
            elif key == "axis":
                bone.axis = self.numbers(values[:3], 3, line, "axis")
                bone.order = self.order(values[3:], line) if values[3:] else "xyz"
            elif key == "dof":
                bone.dof = self.dof(values, line, _BONE_DOF)
            elif key == "limits" or key.startswith("("):
                bone.limits += " ".join(words).count("(")
            elif key not in ("id", "bodymass", "cofmass"):
                if not key.isalpha():
                    raise self.error(quoted(words[0]), "name, direction, length, axis, dof or limits", line)
                self.ignored.setdefault(words[0][:20], line)
        self.check_bone(bone)
        return bone

    def check_bone(self, bone: RawBone) -> None:
        """Raises RecordingError where name, direction or length are missing or impossible; notes what was only odd."""
        if not bone.name:
            raise self.error("a bone without a name", "a name", bone.line)
        where = f"the bone {quoted(bone.name)}"
        if bone.direction is None or bone.length is None:
            what = "length" if bone.direction is not None else "direction"
            raise self.error(f"{where} has no {what}", f"a {what}", bone.line)
        if bone.length < 0 or bone.length > 1e6:
            raise self.error(f"{where} has length {bone.length:g}", "a length from 0 to 1e6", bone.line)
        size = sum(d * d for d in bone.direction) ** 0.5
        if bone.length > 0 and size < 1e-6:
            raise self.error(f"{where} has no direction", "a direction other than 0 0 0", bone.line)
        if bone.length > 0 and abs(size - 1) > 0.01:
            self.uneven.append(bone.name)
        if bone.limits not in (0, len(bone.dof), sum(dof in _TURNS for dof in bone.dof)):
            self.limits.append(bone.name)
        if set(bone.dof) - set(_TURNS):
            self.stretched.append(bone.name)

    def name(self, values: list[str], line: int) -> str:
        """The one word of a name. Raises RecordingError."""
        if len(values) != 1 or len(values[0]) > MAX_NAME:
            raise self.error(
                "a bone name of " + ("no" if not values else "several or too long") + " words", "one", line
            )
        return values[0]

    def numbers(self, values: list[str], n: int, line: int, what: str) -> tuple[float, ...]:
        """Exactly ``n`` numbers. Raises RecordingError."""
        if len(values) != n:
            raise self.error(f"{len(values)} values for {what}", str(n), line)
        return tuple(number(self.path, v, line, f"a number for {what}") for v in values)

    def order(self, values: list[str], line: int) -> str:
        """The order of three axes, in small letters. Raises RecordingError."""
        order = values[0].lower() if len(values) == 1 else ""
        if sorted(order) != ["x", "y", "z"]:
            raise self.error(f"axis order {quoted(' '.join(values))}", "XYZ or another order of the three", line)
        return order

    def dof(self, values: list[str], line: int, known: tuple[str, ...]) -> tuple[str, ...]:
        """Degrees of freedom, each of ``known`` and once. Raises RecordingError."""
        dof = tuple(v.lower() for v in values)
        for word in dof:
            if word not in known:
                raise self.error(f"degree of freedom {quoted(word)}", f"one of {', '.join(known)}", line)
        if len(set(dof)) < len(dof):
            raise self.error("a degree of freedom comes twice", "each once", line)
        return dof

    def hierarchy(self, at: int, lines: list[Line]) -> None:
        """Which bone hangs from which."""
        for start, block in self.blocks(at, lines):
            for line, words in block or [(start, [])]:
                self.link(line, words)

    def link(self, line: int, words: list[str]) -> None:
        """The bones of one line: the first is the parent of the others. Raises RecordingError for a second parent."""
        words = [self.known(name, line) for name in words]
        for child in words[1:]:
            if child == "root" or child in self.asf.parents:
                raise self.error(f"the bone {quoted(child)} hangs from two parents or is the root", "one parent", line)
            self.asf.parents[child] = words[0]
            self.asf.children.setdefault(words[0], []).append(child)

    def known(self, name: str, line: int) -> str:
        """The bone of this name, whatever its capitals where no two bones differ in them only."""
        names = ["root", *self.asf.bones]
        if name in names:
            return name
        alike = [known for known in names if known.lower() == name.lower()]
        if len(alike) != 1:
            raise self.error(f"the bone {quoted(name)} has no data", "a bone of :bonedata", line)
        return alike[0]

    def check(self) -> None:
        """Every bone hangs, through its parents, from the root."""
        reached, stack = set(), ["root"]
        while stack:
            parent = stack.pop()
            reached.add(parent)
            stack.extend(self.asf.children.get(parent, ()))
        for name, bone in self.asf.bones.items():
            if name not in reached:
                found = f"the bone {quoted(name)} does not hang from the root"
                raise self.error(found, "every bone in the hierarchy, no circles", bone.line)


def _some(names: list[str]) -> str:
    return ", ".join(names[:3]) + (f" and {len(names) - 3} more" if len(names) > 3 else "")
