"""Build the documentation site into build/docs and check it.

usage: python -m scripts.build_docs

Fails where a link, a picture, a navigation entry or an object of the API reference does not exist, and where a page
would load something from another server when it is read.
"""

from __future__ import annotations

import os
import re
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

SITE = Path("build/docs")
OUTSIDE = re.compile(
    r"""<(?:script|img|iframe|source|link(?![^>]*rel="?canonical))\b[^>]*(?:src|href)=["']?((?:https?:)?//[^"' >]+)"""
)
QUIET = {"NO_MKDOCS_2_WARNING": "1"}  # mkdocs-material's notice about its successor


def main() -> int:
    """The exit code."""
    # not --quiet: mkdocs would not count the warnings that it does not print
    command = [sys.executable, "-m", "mkdocs", "build", "--strict"]
    built = subprocess.run(command, env=os.environ | QUIET, stderr=subprocess.PIPE, text=True)
    print("\n".join(line for line in built.stderr.splitlines() if not line.startswith("INFO")), end="")
    if built.returncode:
        return built.returncode
    problems = sorted(set(requests_outside(SITE)))
    print("\n".join(problems) if problems else f"documentation: {SITE}/index.html")
    return bool(problems)


def requests_outside(site: Path) -> Iterator[str]:
    """One line for each thing that a page would load from another server."""
    for page in site.rglob("*.html"):
        for address in OUTSIDE.findall(page.read_text(encoding="utf-8")):
            yield f"{page}: loads {address}"


if __name__ == "__main__":
    sys.exit(main())
