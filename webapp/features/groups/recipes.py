"""A comparison as the command or the Python script that makes it again."""

from __future__ import annotations

import shlex
from collections.abc import Mapping
from pathlib import Path
from typing import Any


def command(workspace: Path, dataset: str, document: Mapping[str, Any]) -> str:
    """The commands that make a comparison again."""
    source = shlex.quote(f"{workspace}/{dataset}")
    kinds = {row["kind"] for row in document["comparisons"]}
    first = "grammar" if "action" in kinds else "motifs"
    made = f"motionscape {first} {source} --out {first}.json\n" if kinds & {"motif", "action"} else ""
    counted = f" --from {first}.json" if made else ""
    groups = ",".join(group["name"] for group in document["groups"])
    who = shlex.quote(document["parameters"]["subject"])
    return (
        f"{made}motionscape compare-groups {source} --by {shlex.quote(document['by'])} --groups {shlex.quote(groups)} "
        f"--subject {who} --paired {'yes' if document['paired'] else 'no'}{counted} --out groups.json\n"
    )


def script(workspace: Path, dataset: str, document: Mapping[str, Any]) -> str:
    """The Python script that makes a comparison again."""
    kinds = {row["kind"] for row in document["comparisons"]}
    method = "grammar" if "action" in kinds else "motifs" if "motif" in kinds else ""
    counted = f'analyses.run(workspace, analyses.Request({dataset!r}, "{method}"))' if method else "None"
    groups = tuple(group["name"] for group in document["groups"])
    return f'''"""Compares groups of {dataset} by {document["by"]}."""

from core import analyses
from core.comparing import compared
from core.groups.design import make_design
from core.groups.documents import to_csv
from core.groups.parameters import GroupParameters
from core.workspace import Workspace

workspace = Workspace({str(workspace)!r})
dataset = workspace.open({dataset!r})
properties = workspace.properties.of(workspace.info({dataset!r}).id)
design = make_design(
    properties,
    dataset.names,
    {document["by"]!r},
    subject={document["parameters"]["subject"]!r},
    groups={groups!r},
    paired={"yes" if document["paired"] else "no"!r},
)
document = compared(dataset, design, {counted}, GroupParameters())
print(*(sentence["text"] for sentence in document["words"]), sep="\\n")
print(to_csv(document))
'''
