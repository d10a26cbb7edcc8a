"""``motionscape export``: features of a data set, or its clips as BVH."""

from __future__ import annotations

from argparse import Namespace
from dataclasses import replace
from pathlib import Path

from core.export import FeatureParameters, feature_table, write_features
from core.export.files import SUFFIXES
from core.mocap.bvh import write_bvh
from core.mocap.clip import Clip
from core.mocap.dataset import Dataset
from core.mocap.gltf_writer import write_glb
from core.mocap.rigs import comparable
from core.workspace import WorkspaceError, clean_name
from webapp.cli.progress_bar import progress_bar
from webapp.cli.sources import open_source, say_left_out


def export(arguments: Namespace) -> int:
    """Writes what ``--out`` names: .npz or .parquet (features), .bvh (one clip or a part of it), .glb (clips of
    one skeleton), a folder (all clips).

    Raises WorkspaceError, ValueError or OSError in plain words.
    """
    suffix = arguments.out.suffix.lower()
    if suffix not in (*SUFFIXES, ".bvh", ".glb", "") or (arguments.out.is_dir() and suffix):
        raise WorkspaceError(
            f"{arguments.out}: --out names a file .npz, .parquet, .bvh or .glb, or a folder for BVH files."
        )
    if arguments.frames is not None and suffix not in (".bvh", ".glb"):
        raise WorkspaceError("--frames: only for one clip, with --out clip.bvh.")
    with progress_bar(arguments.quiet) as report:
        dataset = open_source(arguments, report)
        if suffix in SUFFIXES:
            say_left_out(dataset, arguments.quiet)
            table = feature_table(
                comparable(dataset), FeatureParameters(arguments.analysis_fps, arguments.test_share), report
            )
            write_features(arguments.out, table)
            tested = sum(split == "test" for split in table.splits)
            written = (
                f"{len(table.frames)} frames of {len(table.clips)} clips at {table.fps:g} frames a second; "
                f"{len(set(table.subjects))} groups, {tested} clips kept for testing"
            )
        elif suffix == ".bvh":
            write_bvh(arguments.out, clip := _one_clip(dataset, arguments))
            written = f"{clip.name}: {clip.n_frames} frames"
        elif suffix == ".glb":
            clips = _of_one_skeleton(dataset) if arguments.frames is None else [_one_clip(dataset, arguments)]
            write_glb(arguments.out, clips)
            written = f"{len(clips)} clip{'s' * (len(clips) > 1)} as GLB"
        else:
            written = f"{_write_all(arguments.out, dataset, report)} clips as BVH"
    if not arguments.quiet:
        print(f"{written}; written to {arguments.out}")
    return 0


def _one_clip(dataset: Dataset, arguments: Namespace) -> Clip:
    if len(dataset.clips) != 1:
        names = ", ".join(clip.name for clip in dataset.clips[:5]) + (" ..." if len(dataset.clips) > 5 else "")
        raise WorkspaceError(f"--out {arguments.out.name} takes one clip; choose it with --clips, of: {names}.")
    clip = dataset.clips[0]
    start, end = arguments.frames or (0, clip.n_frames)
    return clip.cut(start, end, clip.name)


def _of_one_skeleton(dataset: Dataset) -> list[Clip]:
    """All clips, which become the animations of one figure."""
    if any(clip.skeleton != dataset.clips[0].skeleton for clip in dataset.clips):
        raise WorkspaceError("--out of a .glb takes clips of one skeleton; choose them with --clips.")
    return list(dataset.clips)


def _write_all(folder: Path, dataset: Dataset, report) -> int:
    folder.mkdir(parents=True, exist_ok=True)
    for k, clip in enumerate(dataset.clips):
        name = clean_name(clip.name.replace("/", "_"))
        write_bvh(folder / f"{name}.bvh", replace(clip, name=name))
        report("writing", (k + 1) / len(dataset.clips))
    return len(dataset.clips)
