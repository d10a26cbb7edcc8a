"""The command ``render``: a clip as a film or a picture."""

from __future__ import annotations

import math
from argparse import Namespace
from collections.abc import Iterator

from core.errors import ParameterError
from core.mocap.dataset import Dataset
from core.progress import Report
from core.retrieval.queries import parse_stretch
from core.workspace import WorkspaceError
from webapp.cli.progress_bar import progress_bar
from webapp.cli.sources import open_source
from webapp.shell.routes import Interval
from webapp.stage.film import Film, Picture, paint
from webapp.stage.film_files import MOST_FRAMES, MOST_RATE, RATE, SUFFIXES, write_film
from webapp.stage.motion_routes import encode_motion


def render(arguments: Namespace) -> int:
    """Writes the film. Raises WorkspaceError, AnalysisError, ParameterError or OSError in plain words."""
    suffix = arguments.out.suffix.lower()
    if suffix not in SUFFIXES or arguments.out.is_dir():
        raise WorkspaceError(f"{arguments.out}: --out names a file .mp4, .webm, .gif or .png.")
    with progress_bar(arguments.quiet) as report:
        stretch = _stretch(open_source(arguments, report), arguments.clip)
        step, film = _film(stretch, suffix, arguments)
        pictures = _reported(paint(encode_motion(stretch, step), film), film.frames, report)
        write_film(arguments.out, pictures, film.rate, film.size)
    if not arguments.quiet:
        what = "a picture" if suffix == ".png" else f"{film.frames} frames, {film.rate:g} a second"
        print(f"{stretch.clip.name}: {what}; written to {arguments.out}")
    return 0


def _stretch(dataset: Dataset, text: str | None) -> Interval:
    if text is None and len(dataset.names) > 1:
        raise ParameterError(f"--clip says which of the {len(dataset.names)} clips, as CLIP or CLIP:START-END.")
    clip, start, end = parse_stretch(dataset.names[0] if text is None else text, dataset)
    return Interval(dataset, clip, start or 0, clip.n_frames if end is None else end)


def _film(stretch: Interval, suffix: str, arguments: Namespace) -> tuple[int, Film]:
    """Every how many frames of the clip are shown, and the film."""
    fps, n_frames = stretch.clip.fps, stretch.end - stretch.start
    asked = math.inf if arguments.rate is None else arguments.rate
    most = min(asked, MOST_RATE.get(suffix, RATE))
    if most <= 0:
        raise ParameterError(f"--rate {arguments.rate:g}: expected a number of frames a second above 0.")
    step = min(max(1, math.ceil(fps / most - 0.01)), n_frames)
    frames = math.ceil(n_frames / step)
    look = arguments.size, arguments.view, arguments.theme
    if suffix == ".png":
        return 1, Film(n_frames // 2, 1, fps, *look)
    if frames > MOST_FRAMES.get(suffix, frames):
        raise ParameterError(
            f"{frames} frames are too many for a GIF, which takes {MOST_FRAMES[suffix]}: write .mp4 or .webm, name "
            "fewer frames by --clip CLIP:START-END, or lower --rate."
        )
    return step, Film(0, frames, fps / step, *look)


def _reported(frames: Iterator[Picture], count: int, report: Report) -> Iterator[Picture]:
    for k, frame in enumerate(frames):
        report("painting", k / count)
        yield frame
