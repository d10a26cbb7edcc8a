"""A report as PDF, through a headless Chromium where the machine has one."""

from __future__ import annotations

import subprocess
import tempfile
from pathlib import Path

from core.errors import AnalysisError
from core.workspace import atomic_file
from webapp.shell.browser import find_browser, headless

_PATIENCE = 120  # seconds


def find_printer() -> str:
    """The browser that prints. Raises AnalysisError, saying what to do, where there is none."""
    return find_browser("A PDF", "write the report as .html and print it from a browser")


def write_pdf(html: str, out: Path) -> None:
    """Prints a report. Raises AnalysisError where there is no browser or it fails, OSError where ``out`` cannot be
    written."""
    browser = find_printer()
    with tempfile.TemporaryDirectory(prefix="motionscape-") as folder:
        page, pdf = Path(folder, "report.html"), Path(folder, "report.pdf")
        page.write_text(html, encoding="utf-8")
        options = ["--no-pdf-header-footer", "--virtual-time-budget=8000"]
        try:
            done = subprocess.run(
                [*headless(browser, Path(folder, "profile")), *options, f"--print-to-pdf={pdf}", page.as_uri()],
                capture_output=True, timeout=_PATIENCE, check=False,
            )  # fmt: skip
        except (OSError, subprocess.TimeoutExpired) as error:
            raise AnalysisError(f"{browser} did not print the report: {type(error).__name__}.") from error
        if not pdf.is_file() or not pdf.read_bytes().startswith(b"%PDF"):
            raise AnalysisError(f"{browser} did not print the report (it ended with code {done.returncode}).")
        with atomic_file(out) as file:
            file.write(pdf.read_bytes())
