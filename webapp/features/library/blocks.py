"""What boards and reports show of a dataset itself: its facts, its clips as filmstrips, its labels over time."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping
from typing import Any

from core.mocap.clip import Segment
from core.mocap.dataset import Dataset
from core.mocap.skeleton import Skeleton
from core.motifs.graph import MotifGraph
from core.workspace import Workspace
from webapp.shell.results import motif_graph, motif_notes
from webapp.ui.filmstrip import segment_filmstrip
from webapp.ui.tables import clock
from webapp.ui.timeline import timeline

MOST_CLIPS = 400
MOST_STRIPS = 40
MOST_LABELS = 4  # named of a clip


def overview(
    workspace: Workspace, dataset: Dataset, view: Mapping[str, str], options: Mapping[str, str]
) -> dict[str, Any]:
    """``facts``: [name, value]; ``clips``: name, seconds, frames, fps, labels (the commonest), strip, verdict."""
    rates = sorted({clip.fps for clip in dataset.clips})
    actions = Counter(label.action for label in dataset.labels)
    facts = [
        ["Clips", f"{len(dataset.clips):,}"],
        ["Duration", clock(dataset.seconds)],
        ["Frames", f"{dataset.n_frames:,}"],
        ["Frames a second", ", ".join(f"{rate:g}" for rate in rates[:4]) + (" ..." if len(rates) > 4 else "")],
        ["Skeletons", _skeletons({clip.skeleton for clip in dataset.clips})],
        ["Labels", f"{len(dataset.labels):,} of {len(actions)} actions" if actions else "none"],
        ["Content", dataset.fingerprint[:12]],
    ]
    verdicts = {file.clip: file.verdict for file in dataset.report.files if file.clip}
    by_clip: dict[str, Counter[str]] = {}
    for label in dataset.labels:
        by_clip.setdefault(label.clip, Counter())[label.action] += label.end - label.start
    return {
        "facts": facts,
        "clips": [
            {
                "name": clip.name,
                "seconds": round(clip.seconds, 2),
                "frames": clip.n_frames,
                "fps": clip.fps,
                "labels": ", ".join(name for name, _ in by_clip.get(clip.name, Counter()).most_common(MOST_LABELS)),
                "verdict": verdicts.get(clip.name, "ok"),
                "strip": segment_filmstrip(dataset, Segment(clip.name, 0, clip.n_frames), 8) if k < MOST_STRIPS else "",
            }
            for k, clip in enumerate(dataset.clips[:MOST_CLIPS])
        ],
        "more": max(0, len(dataset.clips) - MOST_CLIPS),
    }


def _skeletons(bodies: set[Skeleton]) -> str:
    joints = sorted({body.n_joints for body in bodies})
    return f"{len(bodies)} of {joints[0]}" + (f" to {joints[-1]}" if len(joints) > 1 else "") + " joints"


def overview_segments(content: Mapping[str, Any]) -> Iterator[tuple[str, int, int]]:
    """Every clip."""
    return ((clip["name"], 0, clip["frames"]) for clip in content["clips"])


def tracks(
    workspace: Workspace, dataset: Dataset, view: Mapping[str, str], options: Mapping[str, str]
) -> dict[str, Any]:
    """Every clip as a row of its labels and, where they have been found, its motifs: see ui/timeline.py."""
    graph = motif_graph(workspace, dataset.name, view)
    notes = motif_notes(workspace, dataset.name, view) if graph else {}
    content = timeline(dataset, graph or MotifGraph((), (), {}, {}), notes)
    return content | {"rows": content["rows"][:MOST_CLIPS]}
