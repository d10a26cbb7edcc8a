"""Frames become files whose frames, size, pace and colours a reader of films finds again."""

import av
import numpy as np
import pytest
from PIL import Image

from webapp.stage.film_files import write_film

SIZE = (96, 64)
COLOURS = np.array([[230, 40, 40], [40, 200, 60], [50, 60, 220]], np.uint8)


def frames(count):
    for k in range(count):
        picture = np.full((SIZE[1], SIZE[0], 3), 245, np.uint8)
        picture[16:48, 4 * k : 4 * k + 32] = COLOURS[k % 3]
        yield picture


def read(path):
    with av.open(str(path)) as film:
        pictures = [frame.to_ndarray(format="rgb24") for frame in film.decode(video=0)]
        return pictures, float(film.streams.video[0].average_rate)


@pytest.mark.parametrize("suffix", [".mp4", ".webm", ".gif"])
def test_a_film_has_every_frame_at_its_pace(tmp_path, suffix):
    out = tmp_path / f"film{suffix}"
    write_film(out, frames(12), 20.0, SIZE)
    pictures, rate = read(out)
    assert len(pictures) == 12
    assert rate == pytest.approx(20.0)
    for found, painted in zip(pictures, frames(12), strict=True):
        assert found.shape == painted.shape
        assert np.abs(found.astype(int) - painted).mean() < 12  # a codec loses a little at edges of colours


def test_hundredths_of_a_second_of_a_gif_add_up(tmp_path):
    out = tmp_path / "film.gif"
    write_film(out, frames(24), 24.0, SIZE)
    with Image.open(out) as film:
        durations = []
        for k in range(film.n_frames):
            film.seek(k)
            durations.append(film.info["duration"])
    assert sum(durations) == 1000
    assert set(durations) == {40, 50}


def test_a_picture_is_the_first_frame_without_loss(tmp_path):
    out = tmp_path / "picture.png"
    write_film(out, frames(3), 30.0, SIZE)
    with Image.open(out) as picture:
        assert np.array_equal(np.asarray(picture), next(frames(1)))


@pytest.mark.parametrize("suffix", [".mp4", ".webm", ".gif", ".png"])
def test_nothing_is_left_where_painting_fails(tmp_path, suffix):
    def broken():
        if suffix != ".png":
            yield from frames(2)
        raise OSError("no more frames")

    with pytest.raises(OSError, match="no more frames"):
        write_film(tmp_path / f"film{suffix}", broken(), 20.0, SIZE)
    assert list(tmp_path.iterdir()) == []
