"""The hierarchy of a BVH file, read word by word: line breaks mean nothing, and comments are passed over."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from pathlib import Path

from core.mocap.errors import RecordingError
from core.mocap.number_words import is_numeric, numbers_in
from core.mocap.text import LARGEST, MAX_NAME, decoded, joint_name, line_at, number, quoted

CHANNELS = tuple(f"{axis}{kind}" for kind in ("position", "rotation") for axis in "XYZ")
_KINDS = {
    "position": ("position", "positon", "pos", "translation", "trans", "location", "loc", "p", "t"),
    "rotation": ("rotation", "rot", "r"),
    "scale": ("scale", "scaling", "scl", "s"),
}
_SPELLING = {
    spelling.lower().encode(): f"{axis}{kind}"
    for kind, words in _KINDS.items()
    for axis in "XYZ"
    for word in words
    for spelling in (f"{axis}{word}", f"{axis}_{word}", f"{word}{axis}", f"{word}_{axis}")
}
_KEYWORDS = (b"ROOT", b"JOINT", b"OFFSET", b"CHANNELS", b"{", b"}")
_WORD = re.compile(rb"[{}]|[^\s{}]+")
_JOINED = re.compile(rb"(OFFSET|CHANNELS)([-+.0-9].*)", re.IGNORECASE)
_NUMBER = rb"[ \t]*([-+]?[0-9]+\.?[0-9]*(?:[eE][-+]?[0-9]+)?)"
_PLAIN_OFFSET = re.compile(_NUMBER + rb"[ \t]" + _NUMBER + rb"[ \t]" + _NUMBER + rb"[ \t]*(?=\n)")
_NO_COMMENT = re.compile(rb"[ \t]*(#|//)")  # behind ROOT or JOINT: a name that looks like one
_END = re.compile(rb"END[-_]?(SITE\d*)?[-_:]?")
_MOTION = re.compile(rb"(MOTION|FRAMES?)([:=].*)?", re.DOTALL)
_MOST_WORDS = 32  # of a joint's name


@dataclass
class RawJoint:
    """A joint as the file gives it: the byte where it begins; offset in file units; channels in file order and the
    column of each."""

    name: str
    parent: int
    start: int
    end_site: bool = False
    offset: tuple[float, ...] | None = None
    channels: tuple[str, ...] = ()
    columns: tuple[int, ...] = ()
    children: list[int] = field(default_factory=list)


@dataclass
class RawHierarchy:
    """Joints of all roots, parents first; ``n_columns`` of a frame; ``end``: the byte where the motion begins.

    scaled: names of joints with scale channels, which are left out. decimal_commas: whether numbers are so written.
    """

    joints: list[RawJoint]
    n_columns: int
    end: int
    scaled: list[str]
    decimal_commas: bool


def parse_hierarchy(path: str | Path, data: bytes) -> RawHierarchy:
    """The hierarchy at the beginning of ``data``. Raises RecordingError with the line of the first fault."""
    return _Parser(path, data).parse()


class _Parser:
    """Never recursive, so depth costs nothing; one word is looked at ahead."""

    def __init__(self, path: str | Path, data: bytes):
        self.path, self.data = path, data
        self.words = _WORD.finditer(data)
        self.at, self.word = 0, b""  # where the next word stands, and the word; empty at the end
        self.joints: list[RawJoint] = []
        self.open: list[int] = []  # joints whose braces are open, innermost last
        self.columns = 0
        self.lines: dict[bytes, list[str]] = {}  # what stands behind CHANNELS -> the channels
        self.scaled: list[str] = []
        self.commas, self.points = False, False
        self.step()

    def parse(self) -> RawHierarchy:
        """The hierarchy, up to the word MOTION. Raises RecordingError for anything that does not belong there."""
        start, word = self.next()
        if word.upper() != b"HIERARCHY":
            raise self.error(_quoted(word), "HIERARCHY, as every BVH file begins", start)
        while True:
            start, word = self.next()
            key = word.upper()
            if key == b"}":
                self.close(start)
            elif key == b"OFFSET":
                self.offset(start)
            elif key == b"CHANNELS":
                self.channels(start)
            elif key in (b"ROOT", b"JOINT"):
                self.begin(start, key.decode())
            elif not word or _MOTION.fullmatch(key):
                break
            elif _END.fullmatch(key):
                self.end_site(start, key)
            elif joined := _JOINED.fullmatch(word):
                self.back_to(joined.start(2) + start)
                (self.offset if key.startswith(b"O") else self.channels)(start)
            else:
                raise self.error(_quoted(word), "ROOT, JOINT, End Site, OFFSET, CHANNELS or a brace", start)
        if self.open or not self.joints:
            found = "the hierarchy ends inside " + quoted(self.joints[self.open[-1]].name) if self.open else "no ROOT"
            raise self.error(found, "a closing brace for every joint" if self.open else "ROOT and a joint", start)
        return RawHierarchy(self.joints, self.columns, start, self.scaled, self.commas)

    def error(self, found: str, expected: str, offset: int) -> RecordingError:
        """An error that names the file and the line of a byte."""
        return RecordingError(self.path, found, expected, line_at(self.data, offset))

    def step(self, name: bool = False) -> None:
        """Looks at the next word; comments are passed over where no name must stand."""
        while match := next(self.words, None):
            self.at, self.word = match.start(), match.group()
            if self.word[0] not in b"#/" or name or not self.word.startswith((b"#", b"//")):
                return
            line_end = self.data.find(b"\n", self.at)
            self.words = _WORD.finditer(self.data, line_end if line_end >= 0 else len(self.data))
        self.at, self.word = len(self.data), b""

    def next(self) -> tuple[int, bytes]:
        """Byte offset and text of the next word, empty at the end."""
        found = self.at, self.word
        self.step()
        return found

    def back_to(self, offset: int, name: bool = False) -> None:
        """Goes on reading at a byte; ``name``: what stands there is a name, also where it looks like a comment."""
        self.words = _WORD.finditer(self.data, offset)
        self.step(name)

    def close(self, start: int) -> None:
        """A closing brace. Raises RecordingError where nothing is open, or the joint has no OFFSET."""
        if not self.open:
            raise self.error("}", "no more closing braces than opening ones", start)
        joint = self.joints[self.open.pop()]
        if joint.offset is None:
            raise self.error(f"{quoted(joint.name)} has no OFFSET", "an OFFSET for every joint", joint.start)

    def begin(self, start: int, key: str) -> None:
        """ROOT or JOINT with its name and brace. Raises RecordingError where it stands in the wrong place."""
        parent = self.open[-1] if self.open else -1
        if key == "ROOT" and self.open:
            raise self.error("a ROOT inside a joint", "JOINT", start)
        if key == "JOINT" and parent < 0:
            raise self.error("'JOINT' outside of a joint", "ROOT before it" if not self.joints else "MOTION", start)
        if parent >= 0 and self.joints[parent].end_site:
            raise self.error(f"a joint inside the End Site of {quoted(self.joints[parent].name)}", "none", start)
        if _NO_COMMENT.match(self.data, start + len(key)):
            self.back_to(start + len(key), name=True)
        name = " ".join(self.words_to_brace(key.lower()))
        if not 0 < len(name) <= MAX_NAME:
            joint_name(self.path, name.split(), line_at(self.data, start))
        self.add(RawJoint(name, parent, start))

    def words_to_brace(self, of: str) -> list[str]:
        """The words before an opening brace. Raises RecordingError where none follows."""
        words: list[str] = []
        while True:
            start, word = self.next()
            if word == b"{":
                return words
            if not word or word == b"}" or len(words) > _MOST_WORDS or (words and word.upper() in _KEYWORDS):
                after = quoted(" ".join(words)) if words else of
                raise self.error(_quoted(word) if word else "the file ends", f"{{ after {after}", start)
            words.append(decoded(word))

    def end_site(self, start: int, key: bytes) -> None:
        """An End Site with its brace; it is called like its joint. Raises RecordingError outside of a joint."""
        if not self.open:
            raise self.error("'End Site' outside of a joint", "ROOT before it" if not self.joints else "MOTION", start)
        parent = self.open[-1]
        words = self.words_to_brace("End Site")
        if b"SITE" not in key and words and not words[0].upper().startswith("SITE"):
            raise self.error(quoted(" ".join(["End", *words])), "End Site", start)
        self.add(RawJoint(f"{self.joints[parent].name}_end", parent, start, end_site=True))

    def add(self, joint: RawJoint) -> None:
        """Opens a joint below the one that is open."""
        self.open.append(len(self.joints))
        if joint.parent >= 0:
            self.joints[joint.parent].children.append(len(self.joints))
        self.joints.append(joint)

    def current(self, key: str, start: int) -> RawJoint:
        """The joint that is open. Raises RecordingError where none is."""
        if not self.open:
            raise self.error(f"{key} outside of a joint", "a joint around it", start)
        return self.joints[self.open[-1]]

    def offset(self, start: int) -> None:
        """The three numbers of OFFSET. Raises RecordingError where they are not three, or come twice."""
        joint = self.current("OFFSET", start)
        if joint.offset is not None:
            raise self.error("a second OFFSET", "one OFFSET of 3 numbers a joint", start)
        if plain := _PLAIN_OFFSET.match(self.data, self.at):
            x, y, z = map(float, plain.groups())
            if max(abs(x), abs(y), abs(z)) <= LARGEST and not self.commas:
                joint.offset = (x, y, z)
                self.points |= b"." in plain.group()
                self.back_to(plain.end())
                return
        values: list[float] = []
        while len(values) < 3 or is_numeric(self.word.decode("latin-1")):
            at, word = self.next()
            if not word or word.upper() in _KEYWORDS or _END.fullmatch(word.upper()):
                raise self.error(f"OFFSET with {len(values)} numbers", "one OFFSET of 3 numbers a joint", start)
            values += self.numbers(at, word.decode("latin-1"))
        if len(values) != 3:
            raise self.error(f"OFFSET with {len(values)} numbers", "one OFFSET of 3 numbers a joint", start)
        joint.offset = tuple(values)

    def numbers(self, at: int, word: str) -> list[float]:
        """The numbers in a word of an OFFSET: one, or several that stand without a space between them."""
        self.points |= "." in word
        self.commas |= word.count(",") == 1 and "." not in word
        if self.points and self.commas:
            raise self.error(f"{quoted(word)}: decimal commas and decimal points", "one of them in a file", at)
        found = numbers_in(word, decimal_commas=self.commas)
        if found is None or not all(abs(value) <= LARGEST for value in found):
            return [number(self.path, word, line_at(self.data, at), "a number for OFFSET")]
        return found

    def channels(self, start: int) -> None:
        """The names behind CHANNELS. Raises RecordingError where they are not as many as it says, or come twice."""
        joint = self.current("CHANNELS", start)
        if joint.channels:
            raise self.error(f"a second CHANNELS in {quoted(joint.name)}", "one CHANNELS a joint", start)
        line_at_hand = self.data[self.at : self.data.find(b"\n", self.at)]
        if line_at_hand in self.lines:
            self.take(joint, self.lines[line_at_hand])
            self.back_to(self.at + len(line_at_hand))
            return
        stated = self.next()[1]
        count = int(stated) if stated.isdigit() and len(stated) < 4 else -1
        names: list[str] = []
        while name := _SPELLING.get(self.word.lower()):
            names.append(name)
            self.step()
        if count != len(names):
            known = not self.word or self.word.upper() in _KEYWORDS or _END.fullmatch(self.word.upper())
            if 0 <= len(names) < count and not known:
                raise self.error(f"channel {_quoted(self.word)}", f"one of {', '.join(CHANNELS)}", self.at)
            says = _quoted(stated) if stated else "no count"
            raise self.error(f"CHANNELS says {says} and names {len(names)}", "as many as it says", start)
        if len(set(names)) < count:
            raise self.error(f"a channel comes twice in {quoted(joint.name)}", "each channel once a joint", start)
        self.take(joint, names)
        if len(line_at_hand.split()) == count + 1:
            self.lines[line_at_hand] = names

    def take(self, joint: RawJoint, names: list[str]) -> None:
        """Gives a joint its channels and their columns."""
        kept = [k for k, name in enumerate(names) if name[1:] != "scale"]
        if len(kept) < len(names):
            self.scaled.append(joint.name)
        joint.channels, joint.columns = tuple([names[k] for k in kept]), tuple([self.columns + k for k in kept])
        joint.end_site = joint.end_site and not names
        self.columns += len(names)


def _quoted(word: bytes) -> str:
    return quoted(decoded(word))
