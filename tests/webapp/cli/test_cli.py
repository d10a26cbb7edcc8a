"""The command line as a user meets it: in processes of its own."""

import contextlib
import io
import json
import os
import signal
import subprocess
import sys
import time
from dataclasses import replace
from typing import NamedTuple

import pytest

from core.analyses import METHODS, parameters
from core.mocap.bvh import write_bvh
from core.workspace import Workspace
from tests.toy_method import REPOSITORY, make_dataset
from webapp.cli import main

KINDS = (
    *(
        "serve",
        "user",
        "audit",
        "doctor",
        "import",
        "import-bundle",
        "labels",
        "properties",
        "inspect",
        "reread",
        "body",
        "demo",
        "map",
        "search",
        "evaluate",
        "export",
        "motifs",
        "sweep",
        "compare",
        "compare-groups",
        "stability",
        "walk",
        "grammar",
        "derive",
        "render",
        "report",
    ),
)


class Outcome(NamedTuple):
    """What a command has printed."""

    stdout: str
    stderr: str


def run(*arguments, code=0):
    """Runs a command in this process, which spares the imports."""
    out, err = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        try:
            ended = main.main(list(map(str, arguments)))
        except SystemExit as end:
            ended = end.code
    assert ended == code, err.getvalue()
    return Outcome(out.getvalue(), err.getvalue())


@pytest.fixture(scope="module")
def demo(tmp_path_factory):
    folder = tmp_path_factory.mktemp("demo") / "demo"
    run("demo", folder, "--minutes", 0.5, "--quiet")
    return folder


@pytest.fixture
def recordings(tmp_path):
    folder = tmp_path / "recordings"
    folder.mkdir()
    for clip in make_dataset().clips:
        write_bvh(folder / f"{clip.name}.bvh", clip)
    return folder


def test_help_lists_the_commands_and_needs_no_heavy_module():
    loaded = "import sys; from webapp.cli import main\ntry: main.main(['--help'])\nexcept SystemExit: pass\n"
    loaded += "print(sorted({'numpy', 'numba', 'dash', 'faiss', 'sklearn'} & set(sys.modules)), file=sys.stderr)"
    done = subprocess.run([sys.executable, "-c", loaded], capture_output=True, text=True, cwd=REPOSITORY)
    assert all(f"    {kind}" in [line[: 4 + len(kind)] for line in done.stdout.splitlines()] for kind in KINDS)
    assert done.stderr.strip() == "[]"
    assert set(main.commands()) == set(KINDS)


def test_help_of_motifs_comes_from_the_parameters():
    text = " ".join(run("motifs", "--help").stdout.split())
    for parameter in parameters("motifs"):
        assert f"--{parameter.name.replace('_', '-')}" in text
        if parameter.name != "seed":
            assert " ".join(parameter.help.split())[:30] in text
    assert "WORKSPACE/NAME" in text and set(METHODS) >= {"motifs"}
    assert "motionscape" in run("--version").stdout


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ([], "required: COMMAND"),
        (["fly"], "invalid choice: 'fly'"),
        (["motifs"], "required: SOURCE, --out"),
        (["motifs", "nowhere", "--out", "m.json"], "no such file or folder"),
        (["motifs", ".", "--out", "m.json", "--kappa", "many"], "auto or a whole number"),
        (["motifs", ".", "--out", "m.json", "--min-letters", "20", "--max-letters", "9"], "must not exceed"),
        (["motifs", ".", "--out", "."], "is a folder"),
        (["motifs", ".", "--out", "m.json"], "no recording"),
        (["motifs", ".", "--out", "m.json", "--seed", "-1"], "expected"),
        (["motifs", ".", "--out", "m.json", "--fps", "0"], "frame rate"),
        (["motifs", ".", "--out", "m.json", "--colour", "red"], "unrecognized"),
        (["import", "space", "nowhere"], "no such file or folder"),
        (["inspect", "."], "no recordings"),
        (["demo", "d", "--minutes", "nan"], "minutes from"),
        (["serve", "--port", "70000"], "port"),
    ],
)
def test_wrong_usage_is_one_line_and_exit_code_2(tmp_path, monkeypatch, arguments, words):
    monkeypatch.chdir(tmp_path)
    done = run(*arguments, code=2)
    assert words in done.stderr
    assert done.stderr.count("\n") == 1 and done.stderr.startswith("motionscape")
    assert done.stdout == "" and list(tmp_path.iterdir()) == []


def test_a_process_ends_with_the_exit_code_and_no_traceback(tmp_path):
    (tmp_path / "bad.bvh").write_text("nothing")
    for arguments, code in (["inspect", "bad.bvh"], 2), (["fly"], 2), (["--version"], 0):
        command = [sys.executable, "-m", "webapp.cli", *arguments]
        environment = os.environ | {"PYTHONPATH": str(REPOSITORY)}
        done = subprocess.run(command, capture_output=True, text=True, cwd=tmp_path, env=environment, timeout=120)
        assert done.returncode == code and "Traceback" not in done.stderr + done.stdout


def test_the_demo_is_the_same_for_the_same_seed(demo, tmp_path):
    done = run("demo", tmp_path / "again", "--minutes", 0.5)
    assert "labelled motion" in done.stdout
    files = sorted(path.name for path in demo.iterdir())
    assert "labels.csv" in files and any(name.endswith(".bvh") for name in files)
    assert all((demo / name).read_bytes() == (tmp_path / "again" / name).read_bytes() for name in files)
    (tmp_path / "file").write_text("")
    assert "is a file" in run("demo", tmp_path / "file", code=2).stderr


def test_inspect_gives_one_line_a_file_and_fails_where_one_is_unreadable(recordings):
    good = run("inspect", recordings)
    assert [line.split()[0] for line in good.stdout.splitlines()] == ["ok", "ok"] or "warning" in good.stdout
    assert len(good.stdout.splitlines()) == 2
    (recordings / "bad\nname.bvh").write_text("HIERARCHY\noops\n")
    (recordings / "alone.asf").write_text(":version 1.10\n")
    bad = run("inspect", recordings, code=2)
    lines = bad.stdout.splitlines()
    assert len(lines) == 4 and sum(line.startswith("error") for line in lines) == 2
    told = json.loads(run("inspect", recordings, "--json", code=2).stdout)
    assert told["format"] == "motionscape/inspection/1"
    assert sorted(f["verdict"] for f in told["files"])[:2] == ["error", "error"]
    assert all(f["messages"] for f in told["files"] if f["verdict"] == "error")
    quiet = run("inspect", recordings, "--quiet", "--clips", "walk_0,alone", code=2)
    assert len([line for line in quiet.stdout.splitlines() if line.startswith("error")]) == 1
    assert run("inspect", recordings / "nowhere.bvh", code=2).stdout.startswith("error")


def test_import_names_reports_and_refuses(recordings, tmp_path):
    space = tmp_path / "space"
    (recordings / "bad.bvh").write_text("nothing")
    labels = tmp_path / "labels.csv"
    labels.write_text("clip,start_frame,end_frame,action\nwalk_1,0,5,walk\n")
    done = run("import", space, recordings, "--name", "Läufe", "--labels", labels)
    assert "2 clips, 81 frames" in done.stdout and "1 labels" in done.stdout
    assert done.stderr.startswith("error") and done.stderr.count("\n") == 1
    assert Workspace(space).info("Läufe").errors == 1
    run("import", space, recordings / "walk_0.bvh", "--quiet")
    assert [info.name for info in Workspace(space).datasets()] == ["Läufe", "walk_0"]
    for name in ("../x", "Läufe", "a/b"):
        assert run("import", space, recordings, "--name", name, code=2).stderr.count("\n") == 1
    assert run("import", space, recordings / "bad.bvh", code=2).stderr.count("\n") == 1
    only = run("import", space, recordings, "--name", "one", "--clips", "walk_1")
    assert "1 clips" in only.stdout
    assert "no clip is called" in run("import", space, recordings, "--name", "two", "--clips", "zz", code=2).stderr


def test_recordings_and_labels_are_added_later(recordings, tmp_path):
    space, labels = tmp_path / "space", tmp_path / "more.csv"
    run("import", space, recordings / "walk_0.bvh", "--name", "one", "--quiet")
    assert "already a dataset" in run("import", space, recordings, "--name", "one", code=2).stderr
    assert "2 clips" in run("import", space, recordings, "--name", "one", "--add").stdout
    labels.write_text("clip,start_frame,end_frame,action\nwalk_1,0,5,walk\nwalk_0,2,9,sit\ngone,0,5,sit\n")
    done = run("labels", space / "one", labels)
    assert done.stdout == "one: 2 labels, 0 before\n"
    assert done.stderr.startswith("warning more.csv: 2 labels of 2 clips; one clip it names is not here: gone (line 4)")
    labels.write_text("clip,action\nwalk_1,run\n")
    assert run("labels", space / "one", labels, "--replace").stdout == "one: 1 labels, 2 before\n"
    for source, words in ((space / "two", "no dataset"), (labels, "WORKSPACE/NAME"), (space, "say which dataset")):
        assert words in run("labels", source, labels, code=2).stderr
    labels.write_text("clip,action\nother,run\n")
    assert "other (line 2)" in run("labels", space / "one", labels, code=2).stderr


def test_a_missing_skeleton_is_said_with_the_option_that_helps(tmp_path):
    (tmp_path / "01_01.amc").write_text(":FULLY-SPECIFIED\n:DEGREES\n1\n")
    for arguments in (
        ["import", tmp_path / "space", tmp_path],
        ["inspect", tmp_path],
        ["motifs", tmp_path, "--out", "m"],
    ):
        done = run(*arguments, code=2)
        assert "no skeleton: neither 01.asf" in done.stdout + done.stderr
        assert "--skeleton FILE.asf" in done.stdout + done.stderr


def test_motifs_writes_its_file_and_says_what_it_took(demo, tmp_path):
    out = tmp_path / "motifs.json"
    done = run("motifs", demo, "--out", out, "--kappa", 60, "--seed", 1)
    document = json.loads(out.read_text())
    assert document["format"] == "motionscape/motifs/1"
    assert document["parameters"]["kappa"] == 60 and document["parameters"]["seed"] == 1
    assert {"dataset", "clips", "seconds", "metrics", "motifs", "edges"} <= set(document)
    assert {"coverage", "average_frame_error", "mean_pose_distance", "n_motifs", "mean_motions", "mean_frames"} <= set(
        document["metrics"]
    )
    frames = {clip["name"]: clip["frames"] for clip in document["clips"]}
    motions = [motion for motif in document["motifs"] for motion in motif["motions"]]
    assert motions and all(0 <= m["start"] < m["end"] <= frames[m["clip"]] for m in motions)
    for words in ("kappa 60", "reading", "discovery", "peak memory", "MB", "coverage"):
        assert words in done.stdout
    assert done.stderr == ""  # no progress where there is no terminal


def test_motifs_of_a_workspace_are_kept(demo, tmp_path):
    space, source = tmp_path / "space", f"{tmp_path}/space/mine"
    run("import", space, demo, "--name", "mine", "--quiet")
    first = run("motifs", source, "--out", tmp_path / "a.json", "--quiet", "--kappa", 60)
    assert first.stdout == first.stderr == ""
    run("motifs", source, "--out", tmp_path / "b.json", "--kappa", "60")
    assert (tmp_path / "a.json").read_bytes() == (tmp_path / "b.json").read_bytes()
    assert [job.state for job in Workspace(space).jobs.list()] == ["done"]
    clip = Workspace(space).open("mine").names[0]
    some = run("motifs", source, "--clips", clip, "--out", tmp_path / "c.json", "--kappa", "60")
    assert "1 clips" in some.stdout
    for arguments, words in [
        ([f"{space}/yours"], "mine"),
        ([space], "say which dataset"),
        ([source, "--labels", "l.csv"], "only for files"),
        ([source, "--clips", "zz"], "no clip 'zz'"),
    ]:
        assert words in run("motifs", *arguments, "--out", tmp_path / "d.json", code=2).stderr
    assert not (tmp_path / "d.json").exists()


def test_an_output_that_cannot_be_written_is_said_and_nothing_half_is_left(demo, tmp_path, monkeypatch, capsys):
    def fails(_descriptor):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("core.mocap.files.os.fsync", fails)
    (tmp_path / "m.json").write_text("before")
    assert main.main(["motifs", str(demo), "--kappa", "60", "--out", str(tmp_path / "m.json")]) == 2
    assert "disk is full" in capsys.readouterr().err
    assert (tmp_path / "m.json").read_text() == "before" and len(list(tmp_path.iterdir())) == 1


def _change_command(monkeypatch, name, **changes):
    """Another way to do, or to read the arguments of, one command."""
    changed = {**main.commands(), name: replace(main.commands()[name], **changes)}
    monkeypatch.setattr(main, "commands", lambda: changed)


def test_a_fault_of_ours_is_one_line_too(monkeypatch, capsys, tmp_path):
    def broken(_asked):
        raise TypeError("oops")

    monkeypatch.delenv(main.DEBUG, raising=False)
    _change_command(monkeypatch, "demo", run=broken)
    assert main.main(["demo", str(tmp_path)]) == 1
    assert capsys.readouterr().err.count("\n") == 1


def test_an_interrupt_ends_cleanly(demo, tmp_path):
    command = [sys.executable, "-m", "webapp.cli", "demo", str(tmp_path / "long"), "--minutes", "600"]
    process = subprocess.Popen(command, stderr=subprocess.PIPE, text=True, cwd=REPOSITORY)
    while not list(tmp_path.rglob("*.bvh")):
        assert process.poll() is None
        time.sleep(0.05)
    process.send_signal(signal.SIGINT)
    _, said = process.communicate(timeout=120)
    assert (process.returncode, said) == (130, "motionscape demo: stopped\n")


def test_an_interrupt_while_the_arguments_are_read_ends_cleanly(monkeypatch, capsys):
    def interrupted(_parser):
        raise KeyboardInterrupt

    monkeypatch.delenv(main.DEBUG, raising=False)
    _change_command(monkeypatch, "motifs", arguments=interrupted)
    assert main.main(["motifs", "somewhere"]) == 130
    assert capsys.readouterr().err == "motionscape: stopped\n"


def test_a_reader_that_leaves_early_is_no_fault(recordings):
    for k in range(300):
        (recordings / f"{k}.bvh").write_text("")
    command = f"{sys.executable} -m webapp.cli inspect {recordings} | head -1; echo ${{PIPESTATUS[0]}}"
    done = subprocess.run(["bash", "-c", command], capture_output=True, text=True, cwd=REPOSITORY, timeout=120)
    assert "Traceback" not in done.stderr and done.stdout.splitlines()[-1] in ("0", "2")


@pytest.mark.skipif(os.name != "posix", reason="needs a pseudo-terminal")
def test_progress_shows_on_a_terminal(demo, tmp_path):
    import pty

    ours, theirs = pty.openpty()
    command = [sys.executable, "-m", "webapp.cli", "motifs", str(demo), "--kappa", "60", "--out", str(tmp_path / "m")]
    process = subprocess.Popen(command, stderr=theirs, stdout=subprocess.DEVNULL, cwd=REPOSITORY)
    os.close(theirs)
    shown = b""
    with contextlib.suppress(OSError):  # how Linux says that the other end was closed
        while piece := os.read(ours, 65536):
            shown += piece
    os.close(ours)
    assert process.wait(120) == 0 and b"%" in shown and b"Reading recordings" in shown
