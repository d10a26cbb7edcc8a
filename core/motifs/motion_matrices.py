"""The motions of a motif as matrices side by side: at their own frames, and at equal moments of the common time."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property

import numpy as np

from core.motifs.alignment import at_frames
from core.motifs.blend_space import BlendSpace
from core.motifs.channels import Channels, channels_of

_KNOT = 0.2  # seconds between the stored points of a time warp
MOST_KEPT = 48  # motions kept or principal at most


@dataclass(frozen=True, eq=False)
class Motions:
    """The motions of a motif as numbers; made by :func:`motions_of`.

    values: ``(n_frames, width)`` of all motions, one after the other, each laid upon the reference, which begins over
    the origin; mean: of the values, as stored, ``(width,)``; rates: frames a second of each motion; starts:
    ``(n_motions + 1,)`` offsets. reference: index of the motion whose time is the common time, its frames the moments;
    knots: ``(n_motions, n_knots)`` the time warps as they are stored: the fractional frame of each motion at evenly
    spaced moments, straight between them. postures: principal postures found so far, of the first so many kept motions
    (0: of all motions).
    """

    channels: Channels
    names: tuple[int, ...]
    values: np.ndarray
    mean: np.ndarray
    starts: np.ndarray
    knots: np.ndarray
    reference: int
    rates: tuple[float, ...]
    postures: dict[int, tuple[np.ndarray, np.ndarray]] = field(default_factory=dict)

    @cached_property
    def moved(self) -> np.ndarray:
        """All motions at the moments of the common time, ``(n_motions, n_moments, width)``."""
        return np.stack([self.on_grid(k, self.values[self.part(k)]) for k in range(self.n)])

    @cached_property
    def _gram(self) -> np.ndarray:
        """Inner products of the motions' differences from the reference, ``(n_motions, n_motions)``."""
        flat = self.moved.reshape(self.n, -1)
        flat = flat - flat[self.reference]
        products: np.ndarray = flat @ flat.T
        return products

    @cached_property
    def order(self) -> tuple[int, ...]:
        """Which motions to keep first: the reference, then always the one whose direction takes most of the squared
        distance that is left of all motions."""
        left, order = self._gram.copy(), [self.reference]
        floor = 1e-9 * max(float(np.trace(left)), 1e-12)
        while len(order) < min(self.n, MOST_KEPT):
            own = np.diag(left)
            gain = np.where(own > floor, (left**2).sum(0) / np.maximum(own, floor), 0)
            gain[order] = -1
            best = int(gain.argmax())
            order.append(best)
            if own[best] > floor:
                left = left - np.outer(left[best], left[best]) / own[best]
        return tuple(order)

    def weights(self, kept: int) -> np.ndarray:
        """Best weights of the first ``kept`` motions of :attr:`order` for each motion, ``(n_motions, kept)``, each row
        of sum 1; motions that are kept are themselves."""
        chosen = list(self.order[:kept])
        inner = self._gram[np.ix_(chosen[1:], chosen[1:])]
        ridge = 1e-9 * max(float(np.trace(self._gram)), 1e-12) * np.eye(kept - 1)
        others = np.linalg.solve(inner + ridge, self._gram[chosen[1:]]).T
        weights = np.column_stack([1 - others.sum(1), others])
        weights[chosen] = np.eye(kept)
        return weights

    @cached_property
    def principal(self) -> tuple[np.ndarray, np.ndarray]:
        """PCA of whole motions: mean ``(n_moments * width,)``, and principal motions as rows, most important first."""
        flat = self.moved.reshape(self.n, -1)
        middle = np.tile(self.mean, self.n_moments)
        mean = stored(flat.mean(0) - middle) + middle
        about = flat - mean
        squares, mixtures = np.linalg.eigh(about @ about.T)  # far fewer motions than numbers in one
        some = [k for k in range(self.n - 1, 0, -1) if squares[k] > 1e-9 * max(squares[-1], 1e-12)][:MOST_KEPT]
        return mean, stored(mixtures[:, some].T @ about / np.sqrt(squares[some])[:, None])

    @property
    def n(self) -> int:
        """Number of motions."""
        return len(self.names)

    @property
    def raw(self) -> int:
        """Numbers of the motions as they are."""
        return self.values.size

    @property
    def n_moments(self) -> int:
        """Number of moments of the common time."""
        return len(self.values[self.part(self.reference)])

    def part(self, motion: int) -> slice:
        """Where in ``values`` a motion stands."""
        return slice(int(self.starts[motion]), int(self.starts[motion + 1]))

    def on_grid(self, motion: int, values: np.ndarray) -> np.ndarray:
        """A motion ``(n, width)`` at the moments of the common time: ``(n_moments, width)``."""
        return at_frames(values, self.warp(motion))

    def off_grid(self, moved: np.ndarray) -> np.ndarray:
        """Motions ``(n_motions, n_moments, width)`` of the common time, at their own frames: ``(n_frames, width)``."""
        low, high, part = self._between
        flat = moved.reshape(-1, moved.shape[-1])
        own: np.ndarray = flat[low] * (1 - part) + flat[high] * part
        return own

    @cached_property
    def _between(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """For each frame the moments before and after it, counted through all motions, and how far it is between."""
        last, rows = self.n_moments - 1, []
        for k in range(self.n):
            own = np.arange(self.starts[k + 1] - self.starts[k])
            rows.append(np.interp(own, self.warp(k), np.arange(last + 1)))
        first = np.repeat(np.arange(self.n) * (last + 1), np.diff(self.starts))
        at = np.concatenate(rows)
        low = np.minimum(at.astype(np.int64), max(last - 1, 0))
        return first + low, first + np.minimum(low + 1, last), (at - low)[:, None]

    def warp(self, motion: int) -> np.ndarray:
        """The fractional frame of a motion at each moment of the common time, ``(n_moments,)``."""
        moments = np.arange(self.n_moments)
        if motion == self.reference:
            return moments.astype(np.float64)
        knots = np.linspace(0, self.n_moments - 1, self.knots.shape[1])
        frames: np.ndarray = np.interp(moments, knots, self.knots[motion])
        return frames


def motions_of(space: BlendSpace, fps: float = 30.0) -> Motions:
    """The motions of a blend space as numbers, each laid upon the reference on the ground.

    fps: rate at which they are looked at (slower ones at their own).
    """
    names = space.motions
    placed = [space.blend({name: 1.0}) for name in names]
    channels = channels_of(placed)
    reference = names.index(space.reference)
    encoded = [channels.encode(clip) for clip in placed]
    full = 2 * np.pi * channels.scales[3]
    for values in encoded:  # headings a full turn apart are the same
        values[:, 3] += full * np.round((encoded[reference][:, 3].mean() - values[:, 3].mean()) / full)
    for values in encoded:
        values[:, [0, 2]] -= (space.start * channels.scales[:3])[[0, 2]]
    rates = [min(fps, clip.fps) for clip in placed]
    frames = [_frames(clip.n_frames, clip.fps / rate) for clip, rate in zip(placed, rates, strict=True)]
    moments = frames[reference]
    n_knots = max(2, int(np.ceil(len(moments) / rates[reference] / _KNOT)) + 1)
    at, common = np.linspace(0, moments[-1], n_knots), space.tracks[space.reference].ticks
    warps = np.stack([np.interp(at, common, space.tracks[name].ticks) for name in names])
    warps *= np.array([[rate / clip.fps] for rate, clip in zip(rates, placed, strict=True)])
    values = np.concatenate([at_frames(v, f) for v, f in zip(encoded, frames, strict=True)])
    starts = np.cumsum([0, *map(len, frames)])
    return Motions(channels, names, values, stored(values.mean(0)), starts, stored(warps), reference, tuple(rates))


def _frames(n: int, step: float) -> np.ndarray:
    """Every ``step``-th frame of ``n``, fractional."""
    return np.arange(int((n - 1) / step + 1e-6) + 1) * step


def stored(values: np.ndarray) -> np.ndarray:
    """Numbers as they come back from 16 bits: IEEE half precision, float64, any shape ``(...)``."""
    return np.asarray(values, np.float64).astype(np.float16).astype(np.float64)
