"""Where the bundled front end lies, and which parts of it are not in every page."""

from pathlib import Path

VENDOR = "vendor"  # folder of scripts of others that only some pages load
PARTS = "parts"  # folder of scripts and styles of our own that only some pages, or reports, hold


def assets_folder() -> Path:
    """The bundled front end: in a wheel it lies in the package, in a checkout beside it."""
    packaged = Path(__file__).parents[1] / "assets"
    return packaged if packaged.is_dir() else Path(__file__).parents[2] / "assets" / "bundle"
