"""Progress on a terminal."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from shutil import get_terminal_size

from core.progress import Report, silent


@contextmanager
def progress_bar(quiet: bool = False) -> Iterator[Report]:
    """A report that draws a bar on stderr, one line in all; silent where ``quiet`` or where stderr is no terminal."""
    if quiet or not sys.stderr.isatty():
        yield silent
        return
    from tqdm import tqdm

    size = get_terminal_size()  # given here because tqdm draws nothing where a terminal does not tell its size
    look = {"bar_format": "{desc} {percentage:3.0f} %|{bar}| {elapsed}", "ncols": size.columns, "nrows": size.lines}
    with tqdm(total=1.0, leave=False, file=sys.stderr, **look) as bar:

        def report(stage: str, fraction: float) -> None:
            if bar.desc != f"{stage}: ":
                bar.set_description(stage)
            bar.n = min(max(fraction, 0.0), 1.0)
            bar.refresh()

        yield report
