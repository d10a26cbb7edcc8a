"""The command ``evaluate``: how well motifs or actions agree with labels."""

from __future__ import annotations

import time
from argparse import Namespace
from collections.abc import Iterator, Mapping
from typing import Any

from core.errors import FormatError
from core.evaluation.action_segmentation import score_segmentation
from core.evaluation.coverage import score_motifs
from core.grammar import learned, terminals
from core.mocap.clip import Segment
from core.motifs import graph
from core.workspace import WorkspaceError
from webapp.cli.progress_bar import progress_bar
from webapp.cli.result_files import check_clips, read_result, write_json
from webapp.cli.sources import open_source

FORMAT = "motionscape/scores/1"
TRACK = "actions"  # the one track of labels that recordings have

Classes = tuple[tuple[Segment, ...], ...]


def evaluate(arguments: Namespace) -> int:
    """Writes the scores of a result against labels; prints a table.

    Raises WorkspaceError for a file that is no such result or is of other recordings, an unknown track or a folder as
    ``--out``; AnalysisError without labels.
    """
    if arguments.out.is_dir():
        raise WorkspaceError(f"{arguments.out} is a folder; --out names the file to write.")
    if arguments.track != TRACK:
        raise WorkspaceError(f"--track: there is no track “{arguments.track}”, only “{TRACK}”.")
    head, classes = read_result(arguments.result, "motifs or grammar", _classes)
    with progress_bar(arguments.quiet) as report:
        dataset = open_source(arguments, report)
    known = [(clip["name"], clip["frames"], clip["fps"]) for clip in head["clips"]]
    labels = [label for label in dataset.labels if label.clip in {name for name, _, _ in known}]
    check_clips(arguments.result, known, {label.clip for label in labels}, dataset, arguments.source)
    started = time.perf_counter()
    scores, shares = score_segmentation(classes, labels), score_motifs(classes, labels)
    used = {"format": head["format"], "parameters": head["parameters"]}
    document = {
        "format": FORMAT,
        "dataset": {"name": dataset.name, "fingerprint": dataset.fingerprint},
        "clips": [{"name": clip.name, "frames": clip.n_frames, "fps": clip.fps} for clip in dataset.clips],
        "parameters": {"from": arguments.result.name, "track": arguments.track, "result": used},
        "seconds": {"scores": round(time.perf_counter() - started, 4)},
        "metrics": scores.one_to_one.to_json() | {"coverage": shares.coverage, "purity": shares.purity},
        **{name: value for name, value in scores.to_json().items() if name != "clips"},
        "clips_scored": scores.clips,
        "f1_majority": shares.f1_majority,
        "f1_one_to_one": shares.f1_one_to_one,
    }
    write_json(arguments.out, document)
    if not arguments.quiet:
        print("\n".join(_summary(document)))
        print(f"written to {arguments.out}")
    return 0


def _classes(document: Mapping[str, Any]) -> tuple[Mapping[str, Any], Classes]:
    """Head and classes of the document of a result. Raises FormatError for any other."""
    kind = document.get("format") if isinstance(document, Mapping) else None
    if kind == graph.FORMAT:
        return document, tuple(motif.segments for motif in graph.from_json(document).motifs)
    if kind == learned.FORMAT:
        return document, learned.from_json(document).terminals.segments
    if kind == terminals.FORMAT:
        return document, terminals.from_json(document).segments
    raise FormatError(f"its format is {kind!r}")


def _summary(document: Mapping[str, Any]) -> Iterator[str]:
    names = {
        "one_to_one": "one class an action",
        "many_to_one": "any number of classes an action",
        "clip_one_to_one": "one class an action, clip by clip",
        "clip_many_to_one": "any number, clip by clip",
    }
    yield f"{'':<34}" + "".join(f"{name:>8}" for name in document["one_to_one"])
    for key, words in names.items():
        yield f"{words:<34}" + "".join(f"{value:8.1f}" for value in document[key].values())
    shares = document["metrics"]
    yield f"coverage {shares['coverage']:.3f}, purity {shares['purity']:.3f}"
    yield (
        f"{document['clips_scored']} clips, {document['frames']} labelled frames, {document['actions']} actions, "
        f"{document['classes']} classes"
    )
    if document["missing"]:
        yield f"note: {document['missing']} labelled clips have no segment and count in coverage alone"
