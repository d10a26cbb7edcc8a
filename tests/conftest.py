"""What every test run shares: the tiers, second runs in CI, fixtures that every test may use.

Tiers: tests in tests/browser carry the marker ``browser``; ``slow`` stands at the test. All others are the fast tier.
"""

from __future__ import annotations

import os
import signal
from pathlib import Path

import pytest
from hypothesis import settings

REPOSITORY = Path(__file__).resolve().parents[1]
FIRST = ("browser", "webapp")  # folders whose tests wait for other processes: the short files of core fill the end

# As many processes as cores run the tests: threads of linear algebra in each would wait for one another. numpy reads
# this when it is first imported; the processes that tests start inherit it.
for variable in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS"):
    os.environ.setdefault(variable, "1")

# Kernels compile within the first example, so none has a deadline; a failure in CI can be had again anywhere.
settings.register_profile("motionscape", deadline=None, derandomize="CI" in os.environ)
settings.load_profile("motionscape")

# A shell's background job ignores interrupts, and so would every process that a test starts and interrupts.
if signal.getsignal(signal.SIGINT) == signal.SIG_IGN:
    signal.signal(signal.SIGINT, signal.default_int_handler)


@pytest.hookimpl(tryfirst=True)  # before tests are selected by their markers
def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Marks browser tests by their folder, long ones first. Where CI=true is set, one that fails runs a second time."""

    def folder(item: pytest.Item) -> str:
        return item.path.relative_to(Path(__file__).parent).parts[0]

    items.sort(key=lambda item: FIRST.index(folder(item)) if folder(item) in FIRST else len(FIRST))
    for item in items:
        if folder(item) == "browser":
            item.add_marker(pytest.mark.browser)
            if os.environ.get("CI") == "true":
                item.add_marker(pytest.mark.flaky(reruns=1))


@pytest.hookimpl(trylast=True)
def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> None:
    """Names every test that needed a second run, just above pytest's closing line."""
    names = sorted({report.nodeid for report in terminalreporter.getreports("rerun")})
    if names:
        terminalreporter.section("needed a second run")
        for name in names:
            terminalreporter.write_line(name)


@pytest.fixture(scope="session")
def shared_data() -> Path:
    """Folder of real recordings beside the checkout (or MOTIONSCAPE_SHARED/data); skips where it is absent."""
    shared = Path(os.environ.get("MOTIONSCAPE_SHARED", REPOSITORY.parent / "shared"))
    if not (shared / "data" / "README.md").is_file():
        pytest.skip(f"real recordings are not here: {shared / 'data'}")
    return shared / "data"
