"""Arguments of the commands of the page Clip."""

from __future__ import annotations

import argparse
from pathlib import Path

from webapp.cli.arguments import SOURCE_HELP, common, number


def render(parser: argparse.ArgumentParser) -> None:
    """Arguments of ``render``."""
    from webapp.stage.film import THEMES, VIEWS

    parser.add_argument("source", metavar="SOURCE", help=SOURCE_HELP)
    clip = "the clip, or frames of it; the end is excluded (default: the only clip of SOURCE)"
    parser.add_argument("--clip", metavar="CLIP[:START-END]", help=clip)
    out = "film (.mp4, .webm, .gif) or picture (.png, of the frame in the middle) to write"
    parser.add_argument("--out", type=Path, required=True, metavar="FILE", help=out)
    size = "width and height in pixels (default 1280x720)"
    parser.add_argument("--size", type=_size, default=(1280, 720), metavar="WxH", help=size)
    parser.add_argument("--view", choices=VIEWS, default="corner", help="where the camera stands (default corner)")
    parser.add_argument("--theme", choices=THEMES, default="light", help="colours (default light)")
    rate = "frames a second of the film at most: every so many frames of the clip are shown (default 60; GIF: 25)"
    parser.add_argument("--rate", type=number, metavar="N", help=rate)
    common(parser)


def _size(text: str) -> tuple[int, int]:
    parts = text.lower().split("x")
    if len(parts) != 2 or not all(part.isdecimal() and len(part) <= 4 for part in parts):
        raise argparse.ArgumentTypeError(f"{text[:60]!r}: expected width and height, as 1280x720")
    width, height = int(parts[0]), int(parts[1])
    if width % 2 or height % 2 or not (64 <= width <= 7680 and 64 <= height <= 7680):
        raise argparse.ArgumentTypeError(f"{text[:60]!r}: expected even numbers from 64 to 7680, as 1280x720")
    return width, height
