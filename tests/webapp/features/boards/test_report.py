"""A report holds what its blocks show and its motion, asks no network, and lets nothing of people's texts run."""

from __future__ import annotations

import base64
import json
import re
import threading
import time
import zlib
from dataclasses import replace

import numpy as np
import pytest

from core import analyses
from core.errors import AnalysisError
from core.mocap.clip import Label
from core.workspace import Workspace, WorkspaceError
from core.workspace.blocks import Block
from tests.webapp.generated import walkers
from webapp.app import create_app
from webapp.cli.main import main
from webapp.features.boards import printing, report_writing
from webapp.features.boards.parts import OVERVIEW, Part
from webapp.features.boards.report import MOST_BYTES, make_report
from webapp.features.boards.report_writing import Reports
from webapp.features.boards.text import to_html
from webapp.shell.browser import BROWSER
from webapp.shell.feature import blocks

EVIL = "</script><img src=x onerror=alert(1)>"


@pytest.fixture(scope="module")
def workspace(tmp_path_factory):
    found = Workspace(tmp_path_factory.mktemp("workspace"))
    dataset = walkers(("a", "b"))
    found.add_dataset("walks", replace(dataset, labels=(Label("a", 0, 40, EVIL),)))
    for method in ("motifs", "map"):
        analyses.run(found, analyses.Request("walks", method))
    return found


@pytest.fixture(scope="module")
def made(workspace):
    return make_report(workspace, "walks")


def part_of(html: str, name: str) -> str:
    return re.search(rf'<script type="[^"]+" data-part="{name}">(.*?)</script>', html, re.DOTALL)[1]


def test_it_holds_its_blocks_and_says_what_it_leaves_out(made):
    report = json.loads(part_of(made.html, "report"))
    kinds = [part["kind"] for part in report["parts"]]
    assert kinds == ["numbers", "graph", "map", "matrix", "tracks", "motifs", "overview"]
    assert len(made.left_out) == 2 and "Action string: not computed" in made.left_out[0]
    assert made.size == len(made.html.encode()) < MOST_BYTES


def test_its_motion_is_there_and_its_error_is_stated(made):
    report = json.loads(part_of(made.html, "report"))
    numbers = np.frombuffer(zlib.decompress(base64.b64decode(part_of(made.html, "motion"))), "<i2")
    wanted = sum(
        p["frames"] * 3 * len(report["motion"]["bodies"][p["clip"]]["joints"]) for p in report["motion"]["pieces"]
    )
    assert len(numbers) == wanted > 0
    assert re.search(r"at most 0\.\d mm", made.motion) and made.motion in made.html


def test_it_names_no_address_and_forbids_all(made):
    assert "default-src 'none'" in made.html and "connect-src" not in made.html
    addresses = set(re.findall(r"https?://[^\s\"'<>)\\]+", made.html)) - {"http://www.w3.org/2000/svg"}
    assert {a for a in addresses if not a.startswith("http://www.w3.org/")} == set()
    assert not re.search(r"<(?:link|iframe|img|object)\b", made.html)


def test_texts_of_people_stay_texts(made):
    assert EVIL not in made.html
    assert made.html.count("</script>") == 3
    assert any(
        EVIL in action
        for part in json.loads(part_of(made.html, "report"))["parts"]
        for action in part["content"].get("actions", [])
    )


def test_markdown_lets_no_html_and_no_picture_through():
    html = to_html(
        "# Big\n\n<b onclick=x>bold</b> ![p](http://x.example/p.png) [a](javascript:alert(1)) [b](https://x.example)"
    )
    assert "<h1>Big</h1>" in html and "<b" not in html and "<img" not in html and 'href="javascript' not in html
    assert '<a href="https://x.example">b</a>' in html


def test_what_cannot_be_shown_is_said(workspace):
    made = make_report(workspace, "walks", [Part("nonsense"), Part("text", options={"markdown": "*yes*"})])
    assert (
        "no block of the kind" in made.left_out[0]
        and "<em>yes</em>" in json.loads(part_of(made.html, "report"))["parts"][0]["content"]["html"]
    )
    assert made.motion == "It holds no motion."


def test_every_block_of_the_overview_is_declared():
    assert {part.kind for part in OVERVIEW} <= set(blocks())


def test_the_command_writes_it(workspace, tmp_path, capsys):
    out = tmp_path / "report.html"
    assert main(["report", f"{workspace.path}/walks", "--out", str(out)]) == 0
    said = capsys.readouterr()
    assert re.search(r"\d\.\d MB", said.out) and "left out: Action string" in said.err
    assert out.read_text(encoding="utf-8").startswith("<!doctype html>")


@pytest.mark.parametrize(
    ("source", "out", "words"),
    [
        ("walks", "report.docx", ".html, .pdf or .zip"),
        ("nobody", "r.html", "nobody"),
        ("../elsewhere", "r.html", "import it first"),
    ],
)
def test_the_command_says_what_is_wrong(workspace, tmp_path, capsys, source, out, words):
    assert main(["report", f"{workspace.path}/{source}", "--out", str(tmp_path / out)]) == 2
    assert words in capsys.readouterr().err
    assert not (tmp_path / out).exists()


def test_a_pdf_needs_a_browser_and_says_so(monkeypatch):
    monkeypatch.setenv(BROWSER, "/nowhere/chromium")
    with pytest.raises(AnalysisError, match="name it in MOTIONSCAPE_BROWSER, or write"):
        printing.find_printer()


def test_a_board_is_written_by_its_name_in_reading_order(workspace, tmp_path, capsys):
    blocks = [Block("b", "graph", 0, 3, 8, 4, {"title": "Second"}), Block("a", "text", 0, 0, 12, 2, {"title": "First"})]
    board = workspace.boards.create("Ours", [*blocks, Block("c", "map", 0, 9, 4, 4, {"dataset": "elsewhere"})])
    out = tmp_path / "board.html"
    assert main(["report", f"{workspace.path}/walks", "--board", "Ours", "--out", str(out), "--quiet"]) == 0
    report = json.loads(part_of(out.read_text(encoding="utf-8"), "report"))
    assert report["title"] == "Ours" and [part["title"] for part in report["parts"]] == ["First", "Second", ""]
    assert "another dataset" in report["parts"][2]["content"]["html"]
    workspace.boards.delete(board.id)
    assert main(["report", f"{workspace.path}/walks", "--board", "Ours", "--out", str(out), "--quiet"]) == 2
    assert "no board called" in capsys.readouterr().err


def test_a_bundle_goes_to_another_workspace_and_back_by_the_commands(workspace, tmp_path, capsys):
    out = tmp_path / "walks.zip"
    assert main(["report", f"{workspace.path}/walks", "--out", str(out)]) == 0
    assert main(["import-bundle", str(tmp_path / "other"), str(out), "--name", "strolls"]) == 0
    assert "strolls: added" in capsys.readouterr().out
    assert Workspace(tmp_path / "other").info("strolls").fingerprint == workspace.info("walks").fingerprint
    assert main(["import-bundle", str(tmp_path / "other"), str(tmp_path / "nothing.zip")]) == 2
    assert "no such file" in capsys.readouterr().err


def test_the_app_writes_a_report_and_says_its_size_first(workspace):
    client = create_app(workspace.path).server.test_client()

    def ask(path: str):
        return client.get(f"/api/report/{path}", headers={"Host": "localhost"})

    state = ask("walks").json
    for _ in range(600):
        if state["ready"] or state["error"]:
            break
        time.sleep(0.1)
        state = ask("walks").json
    assert state["ready"] and state["motion"]
    (job,) = (job for job in workspace.jobs.list() if job.request["method"] == "report")
    assert job.title == "Report: walks: overview" and job.state == "done"
    answer = ask(f"walks/{state['key']}")
    assert len(answer.data) == state["size"] and answer.data.startswith(b"<!doctype html>")
    assert "walks%3A%20overview.html" in answer.headers["Content-Disposition"]
    assert ask("walks/" + "0" * 32).status_code == 404 and ask("nobody").status_code == 400
    assert ask("walks?form=exe").status_code == 400


def test_a_report_is_stopped_from_the_job_bar(workspace, monkeypatch):
    reports, begun = Reports(workspace), threading.Event()

    def endless(_workspace, _name, _parts, _title, report):
        begun.set()
        for _ in range(2000):
            report("drawing", 0.5)
            time.sleep(0.01)
        raise AssertionError("nobody stopped it")

    monkeypatch.setattr(report_writing, "make_report", endless)
    reports.ask("walks", None, "pdf")
    assert begun.wait(30)
    job = workspace.jobs.latest(reports.ask("walks", None, "pdf")["key"])
    assert job.state == "running" and job.request["parameters"] == {"form": "pdf", "board": ""}
    workspace.jobs.cancel(job.id)
    for _ in range(300):
        if reports.ask("walks", None, "pdf")["error"]:
            break
        time.sleep(0.05)
    assert reports.ask("walks", None, "pdf")["error"] == "Writing the report was stopped."
    assert workspace.jobs.get(job.id).state == "cancelled"

    def refused(*_):
        raise WorkspaceError("The disk is full.")

    monkeypatch.setattr(report_writing, "make_report", refused)
    key = reports.ask("walks", None, "pdf", again=True)["key"]
    for _ in range(300):
        if not workspace.jobs.latest(key).alive:
            break
        time.sleep(0.05)
    assert workspace.jobs.latest(key).error == "The disk is full."
