"""``motionscape render`` says what is wrong with what it is given; the films themselves are in tests/browser/clip."""

import pytest

from core.mocap.bvh import write_bvh
from tests.toy_method import make_dataset
from webapp.cli.main import main
from webapp.shell.browser import BROWSER


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    folder = tmp_path_factory.mktemp("recordings")
    for clip in make_dataset().clips[:2]:
        write_bvh(folder / f"{clip.name}.bvh", clip)
    return folder


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (["--out", "film.avi"], "--out names a file .mp4, .webm, .gif or .png"),
        (["--out", "film.mp4"], "--clip says which of the 2 clips"),
        (["--out", "film.mp4", "--clip", "nobody"], "no clip 'nobody'"),
        (["--out", "film.mp4", "--size", "321x180"], "expected even numbers"),
        (["--out", "film.mp4", "--size", "wide"], "expected width and height"),
        (["--out", "film.mp4", "--rate", "0"], "above 0"),
    ],
)
def test_wrong_options_are_named(folder, tmp_path, monkeypatch, capsys, options, words):
    monkeypatch.chdir(tmp_path)
    name = make_dataset().clips[0].name
    options = [*options, "--clip", name] if "--rate" in options else options
    try:
        code = main(["render", str(folder), *options])
    except SystemExit as end:
        code = end.code
    assert code == 2
    assert words in capsys.readouterr().err
    assert list(tmp_path.iterdir()) == []


def test_without_a_browser_it_says_what_to_do(folder, tmp_path, monkeypatch, capsys):
    monkeypatch.setenv(BROWSER, "/nowhere/chromium")
    name = make_dataset().clips[0].name
    assert main(["render", str(folder), "--clip", name, "--out", str(tmp_path / "film.mp4")]) == 2
    assert "A film needs Chromium or Chrome" in capsys.readouterr().err
    assert list(tmp_path.iterdir()) == []
