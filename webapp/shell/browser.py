"""The browser of this machine that prints and paints without a window: Chromium or one of its kind."""

from __future__ import annotations

import os
import shutil
from pathlib import Path

from core.errors import AnalysisError

BROWSER = "MOTIONSCAPE_BROWSER"  # path of the browser, where it is none of NAMES
NAMES = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome", "microsoft-edge", "msedge")
_PLACES = (
    "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome",
    "/Applications/Chromium.app/Contents/MacOS/Chromium",
    r"C:\Program Files\Google\Chrome\Application\chrome.exe",
    r"C:\Program Files (x86)\Microsoft\Edge\Application\msedge.exe",
)


def find_browser(what: str, otherwise: str = "") -> str:
    """Path of the browser. Raises AnalysisError, saying what to do, where there is none.

    what: what needs it, as "A PDF". otherwise: what a person can do without it, as the end of "Install one, ...".
    """
    named = os.environ.get(BROWSER, "")
    candidates = [named] if named else [*(shutil.which(name) or "" for name in NAMES), *_PLACES]
    found = next((path for path in candidates if path and Path(path).is_file()), None)
    if found is None:
        rest = f", or {otherwise}" if otherwise else ""
        raise AnalysisError(
            f"{what} needs Chromium or Chrome, and there is none here. Install one, name it in {BROWSER}{rest}."
        )
    return found


def headless(browser: str, profile: Path) -> list[str]:
    """The words that start it without a window; profile: a folder of its own."""
    options = ["--headless", "--no-sandbox", "--disable-gpu", "--no-first-run", "--disable-extensions"]
    return [browser, *options, "--disable-background-networking", f"--user-data-dir={profile}"]
