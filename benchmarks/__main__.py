"""Run benchmarks and write docs/benchmarks.md.

usage: python -m benchmarks [readers kmeans motifs stage ...]     (all when none is named)

A section that was not run this time keeps what an earlier run wrote.
"""

from __future__ import annotations

import importlib
import re
import sys
from pathlib import Path

DOCUMENT = Path(__file__).resolve().parents[1] / "docs" / "benchmarks.md"
HEAD = """# Benchmarks

Each table was measured in one run on one machine with two shared cores. Compare ratios within a table, never times
between tables. `python -m benchmarks` writes this page, and each section names the command that makes it alone.
Recordings other than the demo are public collections; `MOTIONSCAPE_SHARED` names the folder that holds them.
"""


def available() -> list[str]:
    """Names of the benchmarks: the modules ``bench_NAME.py`` beside this file."""
    return sorted(p.stem.removeprefix("bench_") for p in Path(__file__).parent.glob("bench_*.py"))


def sections(text: str) -> dict[str, str]:
    """Heading -> section of a document, in order."""
    parts = re.split(r"(?m)^(?=## )", text)[1:]
    return {part.splitlines()[0]: part.strip() for part in parts}


def main(names: list[str]) -> int:
    """Run the named benchmarks; exit code 2 for an unknown name."""
    names = [name.replace("-", "_") for name in names]
    unknown = set(names) - set(available())
    if unknown:
        print(f"no benchmark called {', '.join(sorted(unknown))}; there are {', '.join(available())}", file=sys.stderr)
        return 2
    for name in names or available():
        known = sections(DOCUMENT.read_text(encoding="utf-8")) if DOCUMENT.exists() else {}
        known |= sections(importlib.import_module(f"benchmarks.bench_{name}").main())
        DOCUMENT.write_text("\n\n".join([HEAD.strip(), *known.values()]) + "\n", encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
