"""All frames of the indexed clips, part by part, with one byte for each column."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np

from core.mocap.clip import Clip, Segment
from core.mocap.rigs import Rig, rigs_of
from core.poses.body_parts import LEAVES
from core.progress import Report
from core.retrieval.descriptors import BLOCKS, N_COLUMNS, ROOT, Axes, PartFrames, find_axes, part_frames
from core.retrieval.hits import IndexedClip

UNITS = np.array([1 / 127] * N_COLUMNS + [1 / 25] * len(ROOT), np.float32)
"""What one step of a code stands for, per column: unit vectors to about half a degree, velocities to 4 cm/s (and no
faster than 5 m/s or 5 rad/s)."""

JITTER = 0.9  # from here on a motion jitters
_LONG = 900  # frames of a clip that are plenty to see jitter
_AROUND = 4  # frames beside a stretch that its own depend on
_FOR_AXES = 500  # clips of a skeleton that its axes are taken from


def encode(frames: PartFrames) -> np.ndarray:
    """Frames in parts as codes ``(n, N_COLUMNS + 4)`` int8: the parts, then the root."""
    values = np.concatenate([frames.values, frames.root], axis=1) / UNITS
    return np.clip(np.rint(values), -127, 127).astype(np.int8)


def decode(codes: np.ndarray) -> np.ndarray:
    """Codes ``(n, N_COLUMNS + 4)`` as float32 of that shape."""
    return codes * UNITS


@dataclass(frozen=True, eq=False)
class FrameStore:
    """Codes ``(n, N_COLUMNS + 4)`` int8 of the clips one after another at ``fps``; starts ``(n_clips + 1,)``.

    rigs: those of the clips; axes: of each rig; has: ``(n_clips, 10)`` bool, which leaves each clip has.
    """

    clips: tuple[IndexedClip, ...]
    codes: np.ndarray
    starts: np.ndarray
    has: np.ndarray
    rigs: tuple[Rig, ...]
    axes: tuple[Axes, ...]
    fps: float

    @classmethod
    def build(cls, clips: Iterable[Clip], fps: float, report: Report) -> FrameStore:
        """The frames of some clips, in the order of their names."""
        width = N_COLUMNS + len(ROOT)
        has = np.zeros((0, len(LEAVES)), bool)
        empty = cls((), np.zeros((0, width), np.int8), np.zeros(1, np.int64), has, (), (), fps)
        return empty.add(clips, report)

    def add(self, clips: Iterable[Clip], report: Report) -> FrameStore:
        """With more clips, after those that are there; what is known of a skeleton stays."""
        clips = sorted(clips, key=lambda clip: clip.name)
        rigs, number = rigs_of((clip.skeleton for clip in clips), self.rigs)
        axes = [*self.axes]
        for rig in range(len(self.axes), len(rigs)):
            family = [clip for clip in clips if number[clip.skeleton] == rig]
            axes.append(find_axes(_heard(family[:: max(1, len(family) // _FOR_AXES)], report)))
        codes, has = [], []
        for k, clip in enumerate(clips):
            frames = part_frames(clip, axes[number[clip.skeleton]], self.fps)
            codes.append(encode(frames))
            has.append([leaf in frames.leaves for leaf in LEAVES])
            report("reading postures", (k + 1) / len(clips))
        ends = self.starts[-1] + np.cumsum([len(c) for c in codes])
        return replace(
            self,
            clips=self.clips + tuple(IndexedClip(c.name, c.n_frames, float(c.fps)) for c in clips),
            codes=np.concatenate([self.codes, *codes]),
            starts=np.concatenate([self.starts, ends]).astype(np.int64),
            has=np.concatenate([self.has, np.array(has, bool).reshape(-1, len(LEAVES))]),
            rigs=tuple(rigs),
            axes=tuple(axes),
        )

    @cached_property
    def steady(self) -> bool:
        """Whether most clips move without jitter."""
        some = range(0, len(self.clips), max(1, len(self.clips) // 50))
        return float(np.median([jitter(self.of(k)[:_LONG]) for k in some])) < JITTER if self.clips else True

    def index(self, name: str) -> int:
        """Number of the clip called ``name``; raises KeyError where there is none."""
        for k, clip in enumerate(self.clips):
            if clip.name == name:
                return k
        raise KeyError(f"the index has no clip {name!r}")

    def of(self, clip: int) -> np.ndarray:
        """Codes ``(n, ...)`` of one clip."""
        return self.codes[self.starts[clip] : self.starts[clip + 1]]

    def frame_of(self, clip: int, k: float) -> int:
        """Frame, at the clip's own rate, of frame ``k`` here; its end where ``k`` is past the last."""
        entry = self.clips[clip]
        if k >= self.starts[clip + 1] - self.starts[clip]:
            return entry.frames
        return min(round(k * entry.fps / self.fps), entry.frames - 1)

    def segment(self, clip: int, start: int, end: int) -> Segment:
        """Frames ``[start, end)`` of a clip here as a segment in frames of its own rate."""
        first = self.frame_of(clip, start)
        return Segment(self.clips[clip].name, first, max(self.frame_of(clip, end), first + 1))

    def stretch(self, segment: Segment) -> tuple[int, int, int]:
        """Clip number, start and end here of a segment; at least one frame. Raises KeyError for an unknown clip."""
        clip = self.index(segment.clip)
        n, rate = int(self.starts[clip + 1] - self.starts[clip]), self.fps / self.clips[clip].fps
        start = min(round(segment.start * rate), n - 1)
        return clip, start, max(start + 1, min(round(segment.end * rate), n))

    def encode(self, clip: Clip, start: int = 0, end: int | None = None) -> tuple[np.ndarray, tuple[str, ...]]:
        """Codes ``(n, ...)`` of frames ``[start, end)`` of any clip, of the index or not, and the leaves that it has.

        What lies around the stretch counts for its velocities, as it does in the index.
        """
        end = clip.n_frames if end is None else end
        step = clip.fps / self.fps
        whole = next((k for k in range(_AROUND, 20) if abs(k * step - round(k * step)) < 1e-3), 0)
        before = min(whole, int(start / step))
        while before and abs(before * step - round(before * step)) > 1e-3:
            before -= 1
        first, last = start - round(before * step), min(clip.n_frames, end + round(_AROUND * step))
        rig = next((k for k, rig in enumerate(self.rigs) if rig.fits(clip.skeleton)), None)
        axes = find_axes([clip]) if rig is None else self.axes[rig]
        frames = part_frames(clip.cut(first, last), axes, self.fps)
        n = int((end - start - 1) / step + 1e-6) + 1
        return encode(frames)[before : before + n], frames.leaves

    def pack(self) -> tuple[dict[str, Any], dict[str, np.ndarray]]:
        """As a JSON document and arrays (n, ...)."""
        axes = [
            {
                "names": list(rig.names),
                "directions": np.round(rig.directions, 6).tolist(),
                "leaves": list(own.leaves),
                "bones": list(own.bones),
                "frames": {name: frame.tolist() for name, frame in own.frames.items()},
            }
            for rig, own in zip(self.rigs, self.axes, strict=True)
        ]
        document = {"fps": self.fps, "clips": [list(clip) for clip in self.clips], "axes": axes}
        return document, {"codes": self.codes, "starts": self.starts, "has": self.has}

    @classmethod
    def unpack(cls, document: Mapping[str, Any], arrays: Mapping[str, np.ndarray]) -> FrameStore:
        """Back from :meth:`pack` (n, ...)."""
        rigs = tuple(Rig(tuple(a["names"]), np.array(a["directions"])) for a in document["axes"])
        axes = tuple(
            Axes({k: np.array(v) for k, v in a["frames"].items()}, tuple(a["leaves"]), tuple(a["bones"]))
            for a in document["axes"]
        )
        clips = tuple(IndexedClip(name, int(frames), float(fps)) for name, frames, fps in document["clips"])
        return cls(clips, arrays["codes"], arrays["starts"], arrays["has"], rigs, axes, float(document["fps"]))


def _heard(clips: Sequence[Clip], report: Report) -> Iterator[Clip]:
    """The clips, one after the other, as bodies that are looked at."""
    for k, clip in enumerate(clips):
        report("reading bodies", k / len(clips))
        yield clip


def jitter(codes: np.ndarray) -> float:
    """How much of the motion of codes ``(n, ...)`` is jitter: size of second differences in that of first ones.

    About .5 to .7 for recordings, 1.7 for noise that is new in every frame.
    """
    first = np.diff(codes[:, :N_COLUMNS].astype(np.float32), axis=0)
    second = np.diff(first, axis=0)
    return float(np.sqrt((second**2).mean() / max((first**2).mean(), 1e-9))) if len(second) else 0.0


def evenly_spread(n: int, most: int) -> np.ndarray:
    """At most ``most`` of ``n`` indices, evenly spread: ``(k,)`` int64."""
    return np.unique(np.linspace(0, n - 1, min(n, most)).astype(np.int64))


def column_weights(weights: Mapping[str, float]) -> np.ndarray:
    """Factor of every column of the parts, ``(N_COLUMNS,)``: 1 where all leaves weigh the same, 0 for weight 0."""
    factors = np.zeros(N_COLUMNS, np.float32)
    for leaf, columns in BLOCKS.items():
        factors[columns] = np.sqrt(len(LEAVES) * weights.get(leaf, 0.0))
    return factors
