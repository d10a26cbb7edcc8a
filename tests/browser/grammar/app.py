"""The workspace of the Grammar page's browser tests: a demo whose grammar has been learned."""

from __future__ import annotations

import fcntl
import os
import shutil
from pathlib import Path

import pytest
from playwright.sync_api import Page, expect

from core import analyses
from core.workspace import Workspace
from tests.browser.app import PATIENCE

QUICK = {"n_terminals": 14, "analysis_fps": 15.0}  # enough for the tests, and soon there
LINK = "/grammar?dataset=demo&grammar-n_terminals=14&grammar-analysis_fps=15.0"


@pytest.fixture(scope="session")
def grammar_workspace(demo_workspace: Path) -> Path:
    """The demo workspace with a grammar, made once a run, whichever processes ask for it."""
    path = demo_workspace.with_name("grammar-workspace")
    with path.with_suffix(".lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        if not path.exists():
            unfinished = path.with_suffix(f".{os.getpid()}")
            shutil.copytree(demo_workspace, unfinished)
            workspace = Workspace(unfinished)
            analyses.run(workspace, analyses.Request("demo", "grammar", QUICK))
            workspace.close()
            unfinished.rename(path)
    return path


@pytest.fixture
def workspace(grammar_workspace: Path, tmp_path: Path) -> Workspace:
    """A fresh copy of it."""
    shutil.copytree(grammar_workspace, tmp_path / "workspace")
    return Workspace(tmp_path / "workspace")


def learned(workspace: Workspace):
    """The grammar that LINK shows."""
    return analyses.stored(workspace, analyses.Request("demo", "grammar", QUICK))


def wait_for_string(page: Page) -> None:
    """Until the recordings are drawn as strings."""
    expect(page.locator(".string-block").first).to_be_visible(timeout=PATIENCE)


def wait_for_routine(page: Page) -> None:
    """Until the new routine of the address is there, and its motion on the Stage."""
    page.wait_for_function(
        "() => document.querySelector('.compose-step') && !document.querySelector('#compose-string.busy')"
        " && motionscape.stage.status === 'ready'"
        " && String(motionscape.stage.frameOf(0)?.dataset).startsWith('~derive~')",
        timeout=PATIENCE,
    )


def actions_of(page: Page) -> list[int]:
    """The actions of the new routine, as one sees them."""
    return [int(chip.get_attribute("data-action")) for chip in page.locator(".compose-step .action-chip").all()]
