"""Frames as a film or picture: MP4 (H.264), WebM (VP9), GIF or PNG."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from itertools import pairwise
from pathlib import Path
from typing import IO, TYPE_CHECKING

from core.workspace import atomic_file
from webapp.stage.film import Picture

if TYPE_CHECKING:
    from PIL.Image import Image

# suffix -> codec and its options: constant quality, as good as looks like the Stage
VIDEOS = {
    ".mp4": ("libx264", {"crf": "19", "preset": "medium"}),
    ".webm": ("libvpx-vp9", {"crf": "28", "b:v": "0", "row-mt": "1", "deadline": "good", "cpu-used": "4"}),
}
SUFFIXES = (*VIDEOS, ".gif", ".png")
MOST_RATE = {".gif": 25.0}  # frames a second; browsers slow a GIF down that has more
RATE = 60.0  # frames a second at most, of the others
MOST_FRAMES = {".gif": 1500}  # a GIF is put together in memory


def write_film(out: Path, frames: Iterator[Picture], rate: float, size: tuple[int, int]) -> None:
    """Writes frames (height, width, 3) of ``rate`` a second to a file with one of SUFFIXES. A .png takes the first.

    size: width and height in pixels, even numbers.
    Raises OSError where it cannot be written, and what ``frames`` raises; then there is no file.
    """
    suffix = out.suffix.lower()
    with atomic_file(out) as file:
        if suffix == ".png":
            _image(next(frames)).save(file, format="PNG")
        elif suffix == ".gif":
            _write_gif(file, frames, rate)
        else:
            _write_video(file, suffix, frames, rate, size)


def _write_video(file: IO[bytes], suffix: str, frames: Iterator[Picture], rate: float, size: tuple[int, int]) -> None:
    import av

    codec, options = VIDEOS[suffix]
    with av.open(file, "w", format=suffix[1:]) as container:
        stream = container.add_stream(codec, rate=Fraction(rate).limit_denominator(1001), options=options)
        assert isinstance(stream, av.VideoStream)
        stream.pix_fmt = "yuv420p"
        stream.width, stream.height = size
        for pixels in frames:
            container.mux(stream.encode(av.VideoFrame.from_ndarray(pixels, format="rgb24")))
        container.mux(stream.encode())


def _write_gif(file: IO[bytes], frames: Iterator[Picture], rate: float) -> None:
    from PIL.Image import Dither

    images = [_image(pixels).quantize(255, dither=Dither.NONE) for pixels in frames]
    ends = [round(100 * k / rate) for k in range(len(images) + 1)]  # hundredths of a second, as GIFs count them
    durations = [10 * (end - start) for start, end in pairwise(ends)]
    images[0].save(file, format="GIF", save_all=True, append_images=images[1:], duration=durations, loop=0)


def _image(pixels: Picture) -> Image:
    from PIL import Image

    return Image.fromarray(pixels)
