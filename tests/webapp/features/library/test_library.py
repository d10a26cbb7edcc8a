"""The Library page's pure parts: tables, cards, words."""

from __future__ import annotations

import json

import pytest
from plotly.utils import PlotlyJSONEncoder

from core import analyses
from core.demo import make_demo
from core.errors import ParameterError
from core.mocap.clip import Label, Segment
from core.mocap.dataset import Dataset
from core.mocap.reports import FileReport, Finding, ImportReport
from core.workspace import DatasetInfo, Workspace, WorkspaceError
from tests.webapp.generated import walk
from tests.webapp.stored import misfit
from webapp.features.library import adding, callbacks, long_lists, names, reading
from webapp.features.library import layout as pages_layout
from webapp.features.library.cards import dataset_cards, duration
from webapp.features.library.figures import tables as library_tables
from webapp.features.library.layout import trash_list
from webapp.jobs import changes
from webapp.ui import tables

FINDINGS = (Finding("jump", "x", 3, 5), Finding("sides", "y"), Finding("jump", "z", 8, 10))
REPORTS = (
    FileReport("in/a.bvh", "a", "ok", ()),
    FileReport("in/b.bvh", "b", "warning", ("foot skate",), findings=FINDINGS),
    FileReport("in/c.bvh", None, "error", ("c.bvh:7: found NaN; expected a number",)),
)
NO_SKELETON = (
    "d.amc: no skeleton: neither d.asf nor a single .asf file stands beside it; "
    "expected one of them, or one skeleton given for all"
)


def info(name: str, **changes) -> DatasetInfo:
    values = dict(
        id="0" * 16, name=name, fingerprint="f", folder="0" * 16, clips=3, frames=900, seconds=30.0, labels=0,
        warnings=0, errors=0, imported=0.0,
    )  # fmt: skip
    return DatasetInfo(**values | changes)


def test_clips_say_length_labels_and_verdict():
    labels = (Label("b", 0, 60, "walk"), Label("b", 60, 120, "turn"))
    dataset = Dataset("d", (walk("a", 2.0, 60.0), walk("b", 4.0, 60.0)), labels, ImportReport(REPORTS))
    a, b = library_tables.clip_rows(dataset)
    assert (a["frames"], a["seconds"], a["fps"], a["labels"], a["verdict"]) == ("120 frames", 2.0, 60.0, "", "ok")
    assert (b["labels"], b["verdict"], b["messages"]) == ("walk, turn", "warning", "foot skate")
    assert (a["doubts"], a["doubted"]) == (None, "")
    assert (b["doubts"], b["doubted"]) == (3, "jump (2×), left and right")
    fields = [[column["field"] for column in library_tables.clip_columns(d)] for d in (dataset, dataset.select(["a"]))]
    assert "labels" in fields[0] and "labels" not in fields[1]
    assert b["selection"] == {"clip": "b"} and b["href"] == "/clip?dataset=d&clip=b"


def test_the_report_shows_the_worst_first_and_can_be_filtered():
    rows = library_tables.report_rows(REPORTS)
    assert misfit(rows, names.REPORT_ROWS) is None
    assert [row["verdict"] for row in rows] == ["error", "warning", "ok"]
    assert rows[0]["messages"] == "Line 7: found NaN; expected a number." and "selection" not in rows[0]
    assert not any(row["added"] for row in rows)
    later = (*REPORTS, FileReport("x/d.amc", None, "error", (NO_SKELETON,), 1), FileReport("d.bvh", "d", "ok", (), 1))
    rows = [row for row in library_tables.report_rows(later) if row["added"]]
    assert [(row["name"], row["path"]) for row in rows] == [("d.amc", "x/d.amc"), ("d.bvh", "d.bvh")]
    assert rows[0]["messages"].endswith("beside it; add the recording again, together with its .asf file.")
    assert "skeleton given" not in rows[0]["messages"] and "--" not in rows[0]["messages"]


def test_strips_have_addresses_safe_for_any_name():
    address = tables.strip_address("a/b ?", Segment("c#1/ü", 3, 9), 4, "0123456789")
    assert address == "/api/filmstrip/a%2Fb%20%3F/c%231%2F%C3%BC?start=3&end=9&n=4&v=01234567"


def test_cards_invite_where_there_is_nothing():
    assert "Open the demo" in str(dataset_cards([], None))
    text = str(dataset_cards([info("walks", errors=2, warnings=1, labels=7), info("runs")], "walks"))
    assert "2 not read" in text and "1 warning" in text and "7 labels" in text and "All files read" in text
    assert text.count("dataset-card chosen") == 1


def test_names_stay_data():
    text = str(dataset_cards([info("<script>alert(1)</script>")], None))
    assert "dangerously" not in text.lower()


def test_words_for_durations_and_trash():
    assert [duration(s) for s in (42, 1064, 11520)] == ["42 s", "17.7 min", "3.2 h"]
    assert [tables.clock(s) for s in (0, 7.26, 61, 3599.96)] == ["0:00.0", "0:07.3", "1:01.0", "60:00.0"]
    assert "empty" in str(trash_list([])) and "Restore" in str(trash_list([info("old")]))


def test_what_has_arrived_decides_what_can_be_done_with_it():
    arrived = {"done": True, "received": 2, "token": "0" * 16, "recordings": 1, "labels": 1}
    only_labels = arrived | {"recordings": 0}
    assert (
        adding.problem_of(arrived, None)
        == adding.problem_of(arrived, "walks")
        == adding.problem_of(only_labels, "walks")
        == ""
    )
    assert "choose it under" in adding.problem_of(only_labels, None)
    assert "no recording" in adding.problem_of(only_labels | {"labels": 0}, "walks")
    assert "wait until" in adding.problem_of(arrived | {"done": False}, None) and "at least one" in adding.problem_of(
        None, None
    )
    new = adding.request_for(arrived, None, " park ", "add", {"fps": 60.0})
    assert (new.dataset, new.method, new.parameters) == ("park", "import", {"upload": "0" * 16, "fps": 60.0})
    more = adding.request_for(only_labels, "walks", "", "replace", {"unit": "cm"})  # nothing is read
    assert (more.method, more.parameters) == ("add", {"upload": "0" * 16, "labels": "replace"})
    with pytest.raises(WorkspaceError, match="empty"):
        adding.request_for(arrived, None, " ", "add", {})
    names = adding.targets(["a", "b"])
    assert [adding.into(item["value"]) for item in (names[0], *names[1]["items"])] == [None, "a", "b"]


def test_what_was_chosen_of_reading_becomes_a_request():
    assert reading.import_options("auto", "auto", "") == {}
    assert reading.import_options("cm", "z", "24") == {"unit": "cm", "up": "z", "fps": 24.0}
    of_points = reading.import_options("auto", "auto", "", "coco", 6)
    assert of_points == {"points": "coco", "smooth": 6.0}
    with pytest.raises(ParameterError, match="a number"):
        reading.import_options("auto", "auto", "fast")
    again = reading.request_for("walks", ["b", "a"], "auto", "keep", None)
    assert (again.method, again.parameters) == ("reread", {"unit": "auto", "clips": '["a", "b"]'})
    assert "clips" not in reading.request_for("walks", (), "keep", "y", None).parameters
    with pytest.raises(ParameterError, match="Choose what"):
        reading.request_for("walks", (), "keep", "keep", "")
    dataset = Dataset("d", (walk("a", 2.0, 60.0), walk("b", 4.0, 30.0)), (), ImportReport())
    words = reading.read_now(dataset, ())
    assert words.startswith("2 clips of d.") and "Y up; 60 frames per second in 1, 30 frames" in words
    assert "1 clip of d." in reading.read_now(dataset, ["b"])


def test_a_change_is_told_in_one_sentence():
    assert changes.addition_summary("walks", ImportReport(REPORTS)) == "2 clips to walks; 1 not read, 1 warning."
    later = (*REPORTS, FileReport("l.csv", None, "ok", (), 1))
    assert changes.addition_summary("walks", ImportReport(later)) == "labels to walks."


def test_a_report_offers_what_there_is():
    chips = {chip["value"]: chip["label"] for chip in pages_layout.report_chips(ImportReport(REPORTS))}
    assert chips == {"all": "All 3", "error": "Not read 1", "warning": "Warnings 1", "ok": "Fine 1"}
    later = ImportReport((*REPORTS, FileReport("l.csv", None, "ok", (), 1)))
    assert {"value": "added", "label": "Added last 1"} in pages_layout.report_chips(later)


def test_the_page_shows_the_limits(monkeypatch):
    limits = pages_layout.Limits(1 << 20, 2 << 20, 5)
    monkeypatch.setattr(pages_layout.Limits, "from_environment", lambda: limits)
    assert limits.sentence() in str(pages_layout.page())


def test_of_thousands_of_clips_the_server_sends_those_that_are_asked_for(tmp_path, monkeypatch):
    monkeypatch.setattr(long_lists, "LONG", 2)
    workspace = Workspace(tmp_path / "space")
    clips = tuple(walk(name, 0.2 + 0.1 * k, 60.0) for k, name in enumerate(("b 1", "a 2", "b 10", "c 3")))
    files = tuple(FileReport(f"{clip.name}.bvh", clip.name, "ok") for clip in clips)
    workspace.add_dataset("many", Dataset("many", clips, (Label("c 3", 0, 5, "wave"),), ImportReport(files)))
    assert long_lists.is_long(workspace, "many") and not long_lists.is_long(workspace, "none")
    table = long_lists.clips_of(workspace, "many")
    request = {"startRow": 1, "endRow": 3, "filterModel": {}, "sortModel": [{"colId": "clip", "sort": "asc"}]}
    block = table.block(request)
    assert [row["clip"] for row in block["rowData"]] == ["b 1", "b 10"] and block["rowCount"] == 4
    assert table.block(request)["rowData"][0] == library_tables.clip_rows(workspace.open("many"))[0]
    tables_of = callbacks.detail(workspace, "many", {})
    assert '"getRowsResponse": {"rowData": [{"key": "b 1"' in json.dumps(tables_of, cls=PlotlyJSONEncoder)
    only_b = {"clip": {"filterType": "text", "type": "startsWith", "filter": "b"}}
    assert long_lists.matching(workspace, "many", only_b) == ["b 1", "b 10"]
    every = {"dataset": "many", "filter": only_b}
    assert long_lists.chosen_names(workspace, "many", [{"clip": "c 3"}], every) == ["b 1", "b 10"]
    assert long_lists.chosen_names(workspace, "many", [{"clip": "c 3"}], None) == ["c 3"]
    workspace.remove_clips("many", ["b 1"])
    assert long_lists.matching(workspace, "many", only_b) == ["b 10"]
    assert long_lists.files_of(workspace, "many", "all").block(request)["rowCount"] == 3


def test_a_long_table_has_no_columns_that_only_a_browser_with_all_rows_can_show():
    shown = library_tables.long_columns([*library_tables.CLIP_COLUMNS, *library_tables.REPORT_COLUMNS])
    assert not any({"autoHeight", "wrapText", "filterValueGetter"} & set(column) for column in shown)
    assert "clips" in str(pages_layout.clips_chosen(0, 7)) and pages_layout.clips_chosen(0) is None


def test_everything_can_be_analysed_with_one_button(tmp_path, monkeypatch):
    space = Workspace(tmp_path / "everything")
    space.add_dataset("toy", make_demo(minutes=0.3))
    button = callbacks.analyse_button(space, "toy")
    assert len(button.title.splitlines()) == len(analyses.EVERYTHING)
    started, said = [], []

    def start(workspace, request):
        started.append(request)
        return analyses.submit(workspace, request)

    monkeypatch.setattr(callbacks.jobs, "start", start)
    monkeypatch.setattr(callbacks, "set_props", lambda *_: None)
    monkeypatch.setattr(callbacks, "_notify", said.append)
    callbacks.perform(space, {"action": "analyse", "dataset": "toy"})
    assert [request.method for request in started] == list(analyses.EVERYTHING)
    for request in started:
        space.results.put(analyses.key(space, request), {})
    assert callbacks.analyse_button(space, "toy") is None
    callbacks.perform(space, {"action": "analyse", "dataset": "toy"})
    assert len(started) == len(analyses.EVERYTHING) and "is analysed" in str(said[-1])
