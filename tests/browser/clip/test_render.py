"""``motionscape render`` paints clips with the player of the app."""

import av
import numpy as np
import pytest
from PIL import Image

from core.mocap.bvh import write_bvh
from tests.toy_method import make_dataset
from webapp.cli.main import main


@pytest.fixture(scope="module")
def recording(tmp_path_factory):
    """A file, and the clip in it."""
    clip = make_dataset().clips[0]
    path = tmp_path_factory.mktemp("recordings") / f"{clip.name}.bvh"
    write_bvh(path, clip)
    return path, clip


def pictures(path):
    with av.open(str(path)) as film:
        return [frame.to_ndarray(format="rgb24").astype(int) for frame in film.decode(video=0)]


def test_a_film_shows_the_motion_frame_by_frame(recording, tmp_path, capsys):
    path, clip = recording
    out = tmp_path / "walk.mp4"
    assert main(["render", str(path), "--clip", f"{clip.name}:0-12", "--out", str(out), "--size", "320x180"]) == 0
    step = max(1, round(clip.fps / 60))
    found = pictures(out)
    assert len(found) == -(-12 // step)
    assert f"{len(found)} frames" in capsys.readouterr().out
    assert all(picture.shape == (180, 320, 3) and picture.std() > 5 for picture in found)


def test_themes_and_views_differ(recording, tmp_path):
    path, _ = recording
    shown = {}
    for theme, view in [("light", "corner"), ("dark", "corner"), ("light", "side")]:
        out = tmp_path / f"{theme}-{view}.png"
        options = ["--theme", theme, "--view", view, "--size", "160x90", "--quiet"]
        assert main(["render", str(path), "--out", str(out), *options]) == 0
        shown[theme, view] = np.asarray(Image.open(out)).astype(int)
    assert shown["light", "corner"].mean() > shown["dark", "corner"].mean() + 100
    assert np.abs(shown["light", "corner"] - shown["light", "side"]).mean() > 1
