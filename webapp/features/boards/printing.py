"""A report as PDF, through a headless Chromium where the machine has one."""

from __future__ import annotations

import os
import shutil
import subprocess
import tempfile
from pathlib import Path

from core.errors import AnalysisError
from core.workspace import atomic_file

BROWSER = "MOTIONSCAPE_BROWSER"  # path of the browser that prints, where it is none of NAMES
NAMES = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome", "microsoft-edge", "msedge")
_PATIENCE = 120  # seconds
_PLACES = (
    "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome",
    "/Applications/Chromium.app/Contents/MacOS/Chromium",
    r"C:\Program Files\Google\Chrome\Application\chrome.exe",
    r"C:\Program Files (x86)\Microsoft\Edge\Application\msedge.exe",
)


def find_browser() -> str:
    """The browser that prints. Raises AnalysisError, saying what to do, where there is none."""
    named = os.environ.get(BROWSER, "")
    candidates = [named] if named else [*(shutil.which(name) or "" for name in NAMES), *_PLACES]
    found = next((path for path in candidates if path and Path(path).is_file()), None)
    if found is None:
        raise AnalysisError(
            f"A PDF needs Chromium or Chrome, and there is none here. Install one, name it in {BROWSER}, or write the "
            "report as .html and print it from a browser."
        )
    return found


def write_pdf(html: str, out: Path) -> None:
    """Prints a report. Raises AnalysisError where there is no browser or it fails, OSError where ``out`` cannot be
    written."""
    browser = find_browser()
    with tempfile.TemporaryDirectory(prefix="motionscape-") as folder:
        page, pdf = Path(folder, "report.html"), Path(folder, "report.pdf")
        page.write_text(html, encoding="utf-8")
        options = ["--headless", "--no-sandbox", "--disable-gpu", "--no-first-run", "--disable-extensions"]
        options += [
            f"--user-data-dir={Path(folder, 'profile')}",
            "--no-pdf-header-footer",
            "--virtual-time-budget=8000",
        ]
        try:
            done = subprocess.run(
                [browser, *options, f"--print-to-pdf={pdf}", page.as_uri()],
                capture_output=True, timeout=_PATIENCE, check=False,
            )  # fmt: skip
        except (OSError, subprocess.TimeoutExpired) as error:
            raise AnalysisError(f"{browser} did not print the report: {type(error).__name__}.") from error
        if not pdf.is_file() or not pdf.read_bytes().startswith(b"%PDF"):
            raise AnalysisError(f"{browser} did not print the report (it ended with code {done.returncode}).")
        with atomic_file(out) as file:
            file.write(pdf.read_bytes())
