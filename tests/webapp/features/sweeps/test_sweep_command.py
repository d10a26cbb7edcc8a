"""The command sweep: columns, values, axes, charts, workspaces, and what it refuses."""

from __future__ import annotations

import csv
import xml.etree.ElementTree as ET
from dataclasses import replace

import pytest

from core import analyses
from core.analyses import Request
from core.mocap.clip import Label
from core.mocap.labels import write_labels
from core.motifs import sweep as sweeping
from core.motifs.build import find_motifs
from core.motifs.parameters import MotifParameters
from core.workspace import Workspace
from tests.core.motifs.recordings import recurring
from tests.webapp.cli.test_cli import run
from webapp.features.sweeps.figures.drawing import charts, nice_ticks

COLUMNS = "kappa,rho,seed,n_motifs,mean_motions,mean_frames,coverage,average_frame_error,mean_pose_distance,seconds"
LABELS = (Label("clip0", 0, 60, "wave"), Label("clip1", 0, 60, "kick"))
DATASET = replace(recurring(1, n_clips=2, length=4), labels=LABELS)


@pytest.fixture
def source(tmp_path):
    workspace = Workspace(tmp_path / "space")
    workspace.add_dataset("moves", DATASET)
    return workspace.path / "moves"


def rows(path) -> list[dict[str, str]]:
    with path.open(newline="") as file:
        return list(csv.DictReader(file))


def test_a_row_a_point_with_the_columns_that_scripts_expect(source, tmp_path):
    out = tmp_path / "out" / "sweep.csv"
    done = run("sweep", source, "--kappa", "30,20", "--rho", ".2,1", "--seeds", 2, "--seed", 5, "--out", out)
    assert out.read_text().splitlines()[0] == COLUMNS + ",purity,f1_majority"
    table = rows(out)
    assert [(r["kappa"], r["rho"], r["seed"]) for r in table] == [
        (k, rho, seed) for k in ("20", "30") for rho in ("0.2", "1") for seed in ("5", "6")
    ]
    graph = find_motifs(DATASET, MotifParameters(kappa=30, rho=0.2, seed=6))
    (row,) = [r for r in table if (r["kappa"], r["rho"], r["seed"]) == ("30", "0.2", "6")]
    for name, value in graph.metrics.items():
        assert float(row[name]) == pytest.approx(value, rel=1e-5)
    assert 0 < float(row["purity"]) <= 1 and float(row["seconds"]) > 0
    assert "8 points in" in done.stdout and str(out) in done.stdout


def test_results_are_kept_in_the_workspace_and_not_made_twice(source, tmp_path, monkeypatch):
    run("sweep", source, "--kappa", "20,30", "--out", tmp_path / "a.csv", "--quiet")
    workspace = Workspace(source.parent)
    for kappa in (20, 30):
        assert analyses.stored(workspace, Request("moves", "motifs", {"kappa": kappa})) is not None
    monkeypatch.setattr(sweeping, "STAGES", None)  # nothing is left to do
    assert run("sweep", source, "--kappa", "20,30", "--out", tmp_path / "b.csv", "--quiet").stdout == ""
    assert (tmp_path / "a.csv").read_text() == (tmp_path / "b.csv").read_text()


def test_any_parameter_is_an_axis_in_a_column_of_its_own(source, tmp_path):
    out = tmp_path / "sweep.csv"
    run("sweep", source, "--adjacency", "radius,spheres", "--gamma", "1.5,1.2", "--clips", "clip0", "--out", out)
    assert out.read_text().splitlines()[0] == COLUMNS + ",purity,f1_majority,gamma,adjacency"
    assert [(r["gamma"], r["adjacency"]) for r in rows(out)] == [
        (g, a) for g in ("1.2", "1.5") for a in ("radius", "spheres")
    ]
    assert all(int(r["kappa"]) >= 2 for r in rows(out)), "auto is told as the number used"


def test_without_ranges_it_takes_the_papers(source, tmp_path):
    out = tmp_path / "sweep.csv"
    run("sweep", source, "--out", out, "--analysis-fps", "10", "--quiet")
    assert len(rows(out)) == 30 and {r["rho"] for r in rows(out)} == {"0.2", "0.5", "1", "2", "5"}


def test_files_are_read_with_the_common_options(source, tmp_path):
    from core.mocap.bvh import write_bvh

    (tmp_path / "files").mkdir()

    for clip in DATASET.clips:
        write_bvh(tmp_path / "files" / f"{clip.name}.bvh", clip)
    write_labels(tmp_path / "said.csv", LABELS)
    out = tmp_path / "sweep.csv"
    run("sweep", tmp_path / "files", "--kappa", "20,30", "--labels", tmp_path / "said.csv", "--out", out)
    assert len(rows(out)) == 2 and "purity" in rows(out)[0]
    run("sweep", tmp_path / "files", "--kappa", "20,30", "--out", out, "--quiet")
    assert "purity" not in rows(out)[0]


def test_charts_are_drawn_for_every_axis(source, tmp_path):
    folder = tmp_path / "charts"
    done = run("sweep", source, "--kappa", "20,30,40", "--rho", ".2,1", "--seeds", 2, "--out", tmp_path / "s.csv",
               "--plot", folder)  # fmt: skip
    names = {f"{axis}-{pair}.svg" for axis in ("kappa", "rho") for pair in ("error-coverage", "motifs", "labels")}
    assert {path.name for path in folder.iterdir()} == names
    assert all(str(folder / name) in done.stdout for name in names)
    drawing = ET.parse(folder / "kappa-error-coverage.svg").getroot()
    texts = ["".join(element.itertext()) for element in drawing.iter("{http://www.w3.org/2000/svg}text")]
    assert {"20", "30", "40", "Average frame error", "Coverage (%)", "rho 1, median and range of 2 seeds"} <= set(texts)
    assert len(list(drawing.iter("{http://www.w3.org/2000/svg}polygon"))) == 2, "a band for each figure"


def test_charts_bear_what_is_missing():
    from core.motifs.sweep_table import SweepTable

    entry = {
        "coverage": 0.5,
        "average_frame_error": 1.0,
        "mean_pose_distance": 4.0,
        "n_motifs": 2.0,
        "mean_motions": 2.0,
    }
    for name, values in (("kappa", ("auto", 20, 30)), ("kappa", (20, 30, 40)), ("hold", (0.0, 1.0, 2.0))):
        for figures in ([None] * 3, [entry, None, None], [entry] * 3):
            for _, drawing in charts(SweepTable({name: values}, 1, figures)):
                assert "nan" not in drawing
                ET.fromstring(drawing)


@pytest.mark.parametrize(
    ("low", "high", "ticks"),
    [(0, 1, [0, 0.2, 0.4, 0.6, 0.8, 1]), (0.62, 0.97, [0.6, 0.7, 0.8, 0.9, 1]), (3, 3, [3, 4]), (0, 0, [0, 0.2])],
)
def test_ticks_are_round_and_hold_all(low, high, ticks):
    assert nice_ticks(low, high) == pytest.approx(ticks)


@pytest.mark.parametrize(
    ("options", "said"),
    [
        (["--kappa", "1,2"], "kappa: '1' cannot be used; expected auto or a whole number from 2"),
        (["--rho", ""], "at least one value"),
        (["--rho", "1", "--kappa", "200"], "several values"),
        (["--kappa", "20,30", "--seeds", "0"], "seeds"),
        (["--min-letters", "5,60"], "must not exceed"),
        (["--kappa", "20,30", "--labels", "l.csv"], "imported already"),
        (["--kappa", "20,30", "--clips", "nobody"], "nobody"),
    ],
)
def test_what_it_refuses(source, tmp_path, options, said):
    done = run("sweep", source, *options, "--out", tmp_path / "sweep.csv", code=2)
    assert said in done.stderr and "Traceback" not in done.stderr and done.stderr.count("\n") == 1
    assert not (tmp_path / "sweep.csv").exists()


def test_places_it_cannot_write_to_are_refused_before_the_work(source, tmp_path):
    assert "is a folder" in run("sweep", source, "--kappa", "20,30", "--out", tmp_path, code=2).stderr
    (tmp_path / "file").touch()
    options = ["--out", tmp_path / "s.csv", "--plot", tmp_path / "file"]
    assert "is a file" in run("sweep", source, "--kappa", "20,30", *options, code=2).stderr
