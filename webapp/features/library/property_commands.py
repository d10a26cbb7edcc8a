"""The command that sets and writes properties of clips of a data set of a workspace."""

from __future__ import annotations

import sys
from argparse import Namespace

from core.mocap.properties import Properties
from core.mocap.property_files import by_pattern, read_properties
from core.workspace import WorkspaceError, atomic_file
from webapp.cli.sources import named_dataset


def properties(arguments: Namespace) -> int:
    """Sets properties of clips, says them, or writes them. Raises WorkspaceError, ParameterError, FormatError."""
    named = named_dataset(arguments.source)
    if named is None:
        raise WorkspaceError(f"{arguments.source}: properties belong to a dataset of a workspace, as WORKSPACE/NAME.")
    workspace, name = named
    clips, id = workspace.open(name).names, workspace.info(name).id
    present = workspace.properties.of(id)
    made = present
    if arguments.table:
        come, remarks = read_properties(arguments.table.expanduser(), clips)
        made = made.with_values(come.values)
        print("\n".join(remarks), file=sys.stderr, end="\n" if remarks else "")
    if arguments.names:
        found, left = by_pattern(arguments.names, clips)
        if not found:
            raise WorkspaceError(f"No name of a clip has the form {arguments.names}; the first is “{clips[0]}”.")
        made = made.with_values(found)
        if left:
            print(f"{len(left)} names do not have this form, such as {', '.join(left[:3])}", file=sys.stderr)
    if made != present and not arguments.preview:
        workspace.properties.put(id, made, "from the command line")
    shown = made.of_clips(clips)
    if arguments.out:
        with atomic_file(arguments.out) as file:
            file.write(shown.to_csv(clips).encode())
    if not arguments.quiet:
        print("\n".join(_lines(name, len(clips), shown)))
    return 0


def _lines(dataset: str, clips: int, shown: Properties) -> list[str]:
    if not shown.columns:
        return [f"{dataset}: its {clips} clips have no properties yet; see --table and --names"]
    lines = []
    for column, kind in shown.columns.items():
        groups = shown.groups(column)
        some = ", ".join(f"{value} ({len(own)})" for value, own in list(groups.items())[:8])
        more = f" and {len(groups) - 8} more" if len(groups) > 8 else ""
        missing = clips - sum(map(len, groups.values()))
        lines.append(
            f"{column} ({kind}): {some}{more}" + (f"; missing for {missing} of {clips} clips" if missing else "")
        )
    return lines
