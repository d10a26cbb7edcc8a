"""The command ``compare-groups``: groups of clips compared, as groups.json or a table."""

from __future__ import annotations

import sys
from argparse import Namespace
from pathlib import Path
from typing import Any

from core import analyses
from core.comparing import compared
from core.grammar import learned as grammar_files
from core.grammar.learned import LearnedGrammar
from core.groups.design import Design, make_design
from core.groups.documents import to_csv
from core.groups.parameters import GroupParameters
from core.mocap.dataset import Dataset
from core.mocap.properties import Properties
from core.mocap.property_files import read_properties
from core.motifs import graph as motif_files
from core.motifs.graph import MotifGraph
from core.workspace import WorkspaceError, atomic_file
from webapp.cli.progress_bar import progress_bar
from webapp.cli.result_files import check_clips, read_result, write_json
from webapp.cli.sources import named_dataset, open_source


def compare_groups(arguments: Namespace) -> int:
    """Compares groups and writes the file. Raises MotionscapeError or OSError in plain words."""
    if arguments.out.is_dir() or arguments.out.suffix.lower() not in (".json", ".csv"):
        raise WorkspaceError(f"{arguments.out}: --out names a file .json or .csv to write.")
    parameters = GroupParameters(arguments.permutations, arguments.resamples, arguments.alpha, arguments.seed)
    with progress_bar(arguments.quiet) as report:
        dataset = open_source(arguments, report)
        counted = _counted(arguments.result, dataset, arguments.source) if arguments.result else None
        if counted is None and not dataset.labels:
            raise WorkspaceError("These recordings have no labels to count: give motifs or a grammar with --from.")
        design = _design(arguments, dataset)
        motion_map = analyses.compute(dataset, "map", {}, report) if arguments.map else None
        document = compared(dataset, design, counted, parameters, report, motion_map)
    if arguments.out.suffix.lower() == ".csv":
        with atomic_file(arguments.out) as file:
            file.write(to_csv(document).encode())
    else:
        write_json(arguments.out, document)
    if not arguments.quiet:
        print("\n".join(summary(document)))
        print(f"written to {arguments.out}")
    return 0


def _design(arguments: Namespace, dataset: Dataset) -> Design:
    properties = _properties(arguments, dataset)
    design = make_design(
        properties,
        dataset.names,
        arguments.by,
        subject=arguments.subject,
        groups=arguments.groups or (),
        paired=arguments.paired,
    )
    for remark in design.remarks if not arguments.quiet else ():
        print(f"note: {remark}", file=sys.stderr)
    return design


def _properties(arguments: Namespace, dataset: Dataset) -> Properties:
    if arguments.properties:
        properties, remarks = read_properties(arguments.properties.expanduser(), dataset.names)
        for remark in remarks if not arguments.quiet else ():
            print(f"note: {remark}", file=sys.stderr)
        return properties
    named = named_dataset(arguments.source)
    properties = named[0].properties.of(named[0].info(named[1]).id) if named else Properties()
    if not properties.columns:
        raise WorkspaceError(
            f"Nothing is known of the clips of {arguments.source}: give a table with --properties clips.csv (clip, "
            f"{arguments.by}, ...), or keep them with the dataset by “motionscape properties”."
        )
    return properties


def _counted(path: Path, dataset: Dataset, source: str) -> MotifGraph | LearnedGrammar:
    """The motifs or the grammar in a file, made of these recordings. Raises WorkspaceError, OSError."""
    result = read_result(path, "motifs” or “motionscape grammar", _either)
    clips = result.clips if isinstance(result, MotifGraph) else result.terminals.clips
    segments = (
        (s for motif in result.motifs for s in motif.segments)
        if isinstance(result, MotifGraph)
        else (s for own in result.terminals.segments for s in own)
    )
    check_clips(path, clips, {segment.clip for segment in segments}, dataset, source)
    if isinstance(result, MotifGraph) and not result.motifs:
        raise WorkspaceError(f"{path} has no motifs, so there is nothing to count; find motifs with other settings.")
    return result


def _either(document: Any) -> MotifGraph | LearnedGrammar:
    is_grammar = isinstance(document, dict) and document.get("format") == grammar_files.FORMAT
    return grammar_files.from_json(document) if is_grammar else motif_files.from_json(document)


def summary(document: dict[str, Any]) -> list[str]:
    """What a comparison found, in lines."""
    unit, correction = document["unit"], "Benjamini-Hochberg"
    groups = ", ".join(f"{g['name']} ({g['units']} {unit}s, {g['minutes']:.1f} min)" for g in document["groups"])
    return [
        f"{document['by']}: {groups}",
        *(one["text"] for one in document["words"]),
        f"Test: {document['test']}; corrected by {correction}.",
    ]
