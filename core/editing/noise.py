"""Band-limited Gaussian noise on joint angles, to see what an analysis makes of it (MMG section 5.4)."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from scipy.fft import irfft, next_fast_len

from core.errors import ParameterError
from core.mocap import quaternions as quat
from core.mocap.clip import Clip
from core.mocap.dataset import Dataset

_MIN_WAVES = 8  # frequencies in the band at least, so that a short clip gets noise and not one sine
_CHUNK = 8192  # frames rotated at a time


def band_limited(
    n_frames: int, fps: float, band: tuple[float, float], rng: np.random.Generator, channels: int
) -> np.ndarray:
    """Stationary Gaussian noise of mean 0 and deviation 1 that holds only frequencies in ``band``: ``(n_frames,
    channels)`` float32.

    band: lowest and highest frequency in Hz; what lies above half of ``fps`` is left out. Raises ParameterError where
    nothing of the band is left, or its limits are not in order.
    """
    low, high = band
    top = min(high, fps / 2)
    if not 0 <= low < top:
        raise ParameterError(f"noise from {low:g} to {high:g} Hz is not possible at {fps:g} frames a second")
    n = next_fast_len(max(n_frames, int(np.ceil((_MIN_WAVES + 1) * fps / (top - low)))), real=True)
    frequencies = np.arange(n // 2 + 1) * fps / n
    inside = np.flatnonzero((frequencies >= low) & (frequencies <= top) & (frequencies > 0) & (frequencies < fps / 2))
    spectrum = np.zeros((len(frequencies), channels), np.complex64)
    parts = rng.standard_normal((2, len(inside), channels), np.float32)
    spectrum[inside] = (parts[0] + 1j * parts[1]) * np.float32(n / (2 * np.sqrt(len(inside))))
    return irfft(spectrum, n, axis=0)[:n_frames]


def shake_joints(clip: Clip, degrees: float, band: tuple[float, float], rng: np.random.Generator) -> Clip:
    """The clip with noise on the rotations of all joints but the root, about each of the joint's own three axes.

    degrees: standard deviation per axis; band: Hz, as in :func:`band_limited`, which raises ValueError. Positions and
    rotation of the root, which are no joint angles, stay.
    """
    joints = [j for j, end in enumerate(clip.skeleton.end_sites) if j and not end]
    noise = band_limited(clip.n_frames, clip.fps, band, rng, 3 * len(joints))
    noise = noise.reshape(clip.n_frames, len(joints), 3) * np.float32(np.radians(degrees))
    rotations = np.array(clip.rotations, np.float32)
    for start in range(0, clip.n_frames, _CHUNK):
        part = slice(start, start + _CHUNK)
        rotations[part, joints] = quat.multiply(rotations[part, joints], quat.from_rotvec(noise[part]))
    return replace(clip, rotations=rotations)


def shake_dataset(dataset: Dataset, degrees: float, band: tuple[float, float], seed: int) -> Dataset:
    """The data set with noise on the joints of every clip (see :func:`shake_joints`); same seed, same noise.

    A clip's noise depends on its name and the seed alone, not on the other clips. Raises ValueError as
    :func:`band_limited` does.
    """
    clips = tuple(
        shake_joints(clip, degrees, band, np.random.default_rng([seed, *clip.name.encode()])) for clip in dataset.clips
    )
    marks = tuple(f"{digest} {degrees} {band} {seed}" for digest in dataset.digests)
    return replace(dataset, clips=clips, digests=marks)
