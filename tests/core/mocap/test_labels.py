"""Labels: CSV in, CSV out, and what does not fit the clips."""

from __future__ import annotations

import pytest

from core.mocap.clip import Label
from core.mocap.errors import RecordingError
from core.mocap.labels import WHOLE_CLIP, fit_labels, read_labels, write_labels


def _read(tmp_path, text: str):
    (tmp_path / "a.csv").write_bytes(text.encode())
    return read_labels(tmp_path / "a.csv")


def test_segments(tmp_path):
    text = 'clip,start_frame,end_frame,action,end_earliest\na,0,10,walk,8\n\n"b, c",5,6,"jump, high",6\n'
    expected = (Label("a", 0, 10, "walk"), Label("b, c", 5, 6, "jump, high"))
    assert _read(tmp_path, text) == expected
    assert _read(tmp_path, "\ufeff" + text.replace("\n", "\r\n")) == expected
    assert _read(tmp_path, "action;clip;end_frame;start_frame\nwalk;a;10;0\n") == expected[:1]


def test_whole_clips(tmp_path):
    labels = _read(tmp_path, "clip,content,style,frames\na,walk,sad,10\nb,run,giant,12\n")
    assert labels == (Label("a", 0, WHOLE_CLIP, "walk"), Label("b", 0, WHOLE_CLIP, "run"))
    assert fit_labels(labels, {"a": 10, "b": 12}) == ((Label("a", 0, 10, "walk"), Label("b", 0, 12, "run")), ())


def test_what_does_not_fit_is_said():
    labels = [Label("a", 0, 12, "walk"), Label("a", 20, 30, "run"), Label("z", 0, 3, "sit")]
    fitted, messages = fit_labels(labels, {"a": 10})
    assert fitted == (Label("a", 0, 10, "walk"),)
    assert len(messages) == 3 and "cut" in messages[0] and "left out" in messages[1] and "z" in messages[2]


@pytest.mark.parametrize(
    "text, line, words",
    [
        ("", None, "empty"),
        ("a,b\n1,2\n", 1, "columns"),
        ("clip,action,start_frame\na,walk,1\n", 1, "start_frame and end_frame"),
        ("clip,start_frame,end_frame,action\na,0,10\n", 2, "3 values"),
        ("clip,start_frame,end_frame,action\na,0,1,x\na,ten,10,walk\n", 3, "'ten'"),
        ("clip,start_frame,end_frame,action\na,-1,10,walk\n", 2, "'-1'"),
        ("clip,start_frame,end_frame,action\na,10,10,walk\n", 2, "end after"),
        ("clip,start_frame,end_frame,action\n,1,10,walk\n", 2, "no clip"),
        ("clip,start_frame,end_frame,action\na,1,10,\n", 2, "no action"),
    ],
)
def test_bad_files_are_refused_in_one_line(tmp_path, text, line, words):
    with pytest.raises(RecordingError, match=words) as caught:
        _read(tmp_path, text)
    assert caught.value.line == line and "\n" not in str(caught.value)


def test_round_trip_and_folders(tmp_path):
    labels = (Label("a", 0, 10, "walk"), Label("a", 10, 12, "jump, high"))
    folder = tmp_path / "labels"
    (folder / "more").mkdir(parents=True)
    write_labels(folder / "a.csv", labels)
    write_labels(folder / "more" / "b.csv", labels[:1])
    assert read_labels(folder) == (*labels, labels[0])
    (tmp_path / "none").mkdir()
    with pytest.raises(RecordingError, match="no labels"):
        read_labels(tmp_path / "none")


def test_real_labels(shared_data):
    assert len(read_labels(shared_data / "labels/mocap6")) == 30
    assert len(read_labels(shared_data / "labels")) == 42
    index = read_labels(shared_data / "bandai_namco_1/index.csv")
    assert len(index) == 174 and index[0].action == "bow"
