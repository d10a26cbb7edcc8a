"""Made-up motion of a motif (webapp/shell/virtual.py): mixtures of its motions, and its motions as compressed.

``~blend~KEY~MOTIF~WEIGHTS`` holds the clip ``blend``; WEIGHTS are ``motion:weight`` pairs, ``3:0.5,7:0.25``, motions
counted from 0. ``~rebuilt~KEY~MOTIF~METHOD~MOTIONS~COMPONENTS`` holds ``K original`` and ``K rebuilt`` for each motion.
KEY names the motif graph.
"""

from __future__ import annotations

import re
from collections.abc import Hashable, Mapping
from dataclasses import replace
from typing import Any

from core import analyses
from core.caching import RecentCache
from core.errors import ParameterError
from core.mocap.dataset import Dataset
from core.motifs.blend_space import BlendSpace, blend_space, blendable
from core.motifs.compression import Curves, Step, curves, rebuilt_clips
from core.motifs.graph import Motif, MotifGraph
from core.motifs.motion_matrices import Motions, motions_of
from core.workspace import Workspace, WorkspaceError
from webapp.shell.results import find_motif
from webapp.shell.virtual import virtual_name

BLEND, REBUILT = "blend", "rebuilt"
CLIP = "blend"
_MOST_WEIGHTS = 64
_DAMAGED = "This motion cannot be made: its link is damaged."


def blend_name(key: str, motif: int, weights: Mapping[int, float]) -> str:
    """The name of a mixture; motions without weight do not count."""
    return virtual_name(BLEND, key, motif, write_weights({k: w for k, w in weights.items() if w > 0}))


def rebuilt_name(key: str, motif: int, method: str, step: Step) -> str:
    """The name of a motif's motions before and after compression."""
    return virtual_name(REBUILT, key, motif, method, step.motions, step.components)


def write_weights(weights: Mapping[int, float]) -> str:
    """Weights as they stand in links, ascending by motion, two decimals."""
    return ",".join(f"{motion}:{weight:.2f}".rstrip("0").rstrip(".") for motion, weight in sorted(weights.items()))


def read_weights(text: str) -> dict[int, float]:
    """Weights from a link; raises WorkspaceError where they cannot be read."""
    parts = text.split(",")
    pairs = [re.fullmatch(r"(\d{1,5}):(\d{1,3}(?:\.\d{1,4})?)", part) for part in parts]
    if len(parts) > _MOST_WEIGHTS or not all(pairs):
        raise WorkspaceError("The weights of this mixture cannot be read; they look like 3:0.5,7:0.25.")
    return {int(pair[1]): float(pair[2]) for pair in pairs if pair}


def motif_of(workspace: Workspace, key: str, number: str | int) -> tuple[Dataset, Motif]:
    """The data set and the motif that a key and a number name. Raises WorkspaceError where there is none."""
    graph: MotifGraph | None = analyses.kept(workspace, "motifs", key)
    motif = find_motif(graph, number) if graph is not None else None
    if graph is None or motif is None:
        raise WorkspaceError("The motif of this motion is not there any more; find the motifs again.")
    return workspace.open_fingerprint(str(graph.dataset["fingerprint"])), motif


def space_of(workspace: Workspace, key: str, number: str | int, motion: int | None = None) -> BlendSpace:
    """The motions of a motif that can be mixed (with ``motion``), kept ready. Raises WorkspaceError."""
    dataset, motif = motif_of(workspace, key, number)
    group = next((g for g in blendable(dataset, motif) if motion is None or motion in g), None)
    if group is None:
        raise WorkspaceError(f"Motif {motif.id} has no motion {motion + 1}." if motion is not None else _DAMAGED)
    return _recent.get_or_compute((workspace.path, key, motif.id, group), lambda: blend_space(dataset, motif, group[0]))


def matrices_of(workspace: Workspace, key: str, number: str | int) -> Motions:
    """The motions of a motif's largest body as numbers, kept ready. Raises WorkspaceError."""
    space = space_of(workspace, key, number)
    return _recent.get_or_compute((workspace.path, key, space.motif.id, "matrices"), lambda: motions_of(space))


def curves_of(workspace: Workspace, key: str, number: str | int) -> Curves | None:
    """Size against error of a motif's largest body, kept ready; None where no two motions are of one body.

    Raises WorkspaceError."""
    dataset, motif = motif_of(workspace, key, number)
    if len(blendable(dataset, motif)[0]) < 2:
        return None
    return _recent.get_or_compute(
        (workspace.path, key, motif.id, "curves"), lambda: curves(matrices_of(workspace, key, number))
    )


def open_blend(workspace: Workspace, rest: str) -> Dataset:
    """The data set ``~blend~`` + rest. Raises WorkspaceError where it cannot be made."""
    key, number, text = _split(rest, 3)
    weights = read_weights(text)
    try:
        clip = space_of(workspace, key, number, min(weights)).blend(weights)
    except ParameterError as error:
        raise WorkspaceError(f"This mixture cannot be made: {error}.") from error
    return Dataset("blend", (replace(clip, name=CLIP),))


def open_rebuilt(workspace: Workspace, rest: str) -> Dataset:
    """The data set ``~rebuilt~`` + rest. Raises WorkspaceError where it cannot be made."""
    key, number, method, motions, components = _split(rest, 5)
    if not (motions + components).isdigit() or len(motions + components) > 6:
        raise WorkspaceError(_DAMAGED)
    try:
        pairs = list(rebuilt_clips(matrices_of(workspace, key, number), method, Step(int(motions), int(components))))
    except ParameterError as error:
        raise WorkspaceError(f"These motions cannot be rebuilt: {error}.") from error
    named = [
        replace(clip, name=f"{motion + 1} {what}")
        for motion, *clips in pairs
        for what, clip in zip(("original", "rebuilt"), clips, strict=True)
    ]
    return Dataset("rebuilt", tuple(named))


def _split(rest: str, n: int) -> list[str]:
    parts = rest.split("~")
    if len(parts) != n:
        raise WorkspaceError(_DAMAGED)
    return parts


_recent: RecentCache[Hashable, Any] = RecentCache(24)
