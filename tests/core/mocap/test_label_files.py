"""Label files beside recordings: which are found, what is taken from them, and what is said of the rest."""

from __future__ import annotations

from pathlib import Path

from core.mocap.clip import Label
from core.mocap.dataset import open_dataset
from core.mocap.label_files import find_label_files, find_labels, take_labels

SEGMENTS = "clip,start_frame,end_frame,action\n"


def written(folder: Path, **files: str) -> Path:
    """The folder with these CSV files; double underscores stand for slashes."""
    for name, text in files.items():
        path = folder / f"{name.replace('__', '/')}.csv"
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    return folder


def test_columns_say_what_is_a_label_file(tmp_path):
    folder = written(
        tmp_path,
        index="clip,content,style\na,walk,sad\n",
        deep__down__x='"Clip";"Start_Frame";"End_Frame";"Label"\na;0;1;x\n',
        labels__broken="nothing of the kind\n",
        manifest="file,format,problem\na,b,c\n",
        sizes="clip,frames,fps\na,3,30\n",
        half="clip,start_frame,action\na,3,x\n",
        empty="",
    )
    (folder / ".hidden.csv").write_text(SEGMENTS)
    (folder / "binary.csv").write_bytes(b"\x00\xff" * 100)
    found = find_label_files(folder)
    names = [(file.path.relative_to(folder).as_posix(), file.whole, file.named) for file in found]
    assert names == [("deep/down/x.csv", False, False), ("index.csv", True, False), ("labels/broken.csv", True, True)]


def test_an_index_only_labels_clips_that_have_no_finer_labels(tmp_path):
    folder = written(tmp_path, index="clip,category\na,dance\nb,dance\n", z=f"{SEGMENTS}a,0,3,turn\na,3,9,step\n")
    labels, reports = find_labels([folder], {"a": 9, "b": 5})
    assert labels == (Label("a", 0, 3, "turn"), Label("a", 3, 9, "step"), Label("b", 0, 5, "dance"))
    assert [(Path(file.path).name, file.verdict) for file in reports] == [("z.csv", "ok"), ("index.csv", "ok")]


def test_what_does_not_fit_is_told_with_its_line_and_not_without_end(tmp_path):
    rows = "".join(f"a,{k},{k},x\n" for k in range(30)) + "".join(f"gone{k},0,1,x\n" for k in range(9))
    labels, told = take_labels(written(tmp_path, l=SEGMENTS + "a,0,2,x\n" + rows) / "l.csv", {"a": 5})
    assert labels == (Label("a", 0, 2, "x"),) and told.verdict == "warning" and len(told.messages) == 15
    assert told.messages[1].startswith("l.csv:3: frames 0 to 0") and told.messages[13] == "18 more rows like these"
    assert told.messages[14].startswith("9 clips it names are not here: gone0 (line 33)")
    assert take_labels(tmp_path / "none.csv", {})[1].verdict == "error"


def test_real_index_files_are_found(shared_data):
    folder = shared_data / "bandai_namco_1"
    clips = ["dataset-1_bow_active_001", "dataset-1_dash_sad_001"]
    labels = open_dataset(folder, clips=clips).labels
    assert [(label.clip, label.action) for label in labels] == [(clips[0], "bow"), (clips[1], "dash")]
    assert [file.path.parent.name for file in find_label_files(shared_data / "labels")].count("mocap6") == 5
    assert find_label_files(shared_data / "malformed") == ()
