"""``motionscape search``: motions like one of a clip, of a stretch, or of two stretches at once, or as words say."""

from __future__ import annotations

import json
import re
import sys
import time
from argparse import Namespace
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from core import analyses
from core.mocap.dataset import Dataset, open_dataset
from core.progress import Report
from core.retrieval.queries import Query, hybrid_query, parse_stretch, whole_query
from core.retrieval.search import SearchIndex
from core.workspace import WorkspaceError
from webapp.cli.expected import say_expected
from webapp.cli.progress_bar import progress_bar
from webapp.cli.result_files import write_json
from webapp.cli.sources import open_source, stored_dataset
from webapp.features.search import word_commands
from webapp.features.search.word_commands import FORMAT

_STRETCH = re.compile(r"(.+):(\d{1,9})-(\d{1,9})", re.DOTALL)
_SHOWN = 5  # hits that are printed


@dataclass(frozen=True)
class _Query:
    """A query, whether it is of whole clips, and the clips of the data set that it is made of."""

    query: Query
    of_whole_clips: bool
    clips: tuple[str, ...]


def search(arguments: Namespace) -> int:
    """Searches and writes hits.json; prints the best hits of a single query, and how long the searches took.

    Raises ParameterError, WorkspaceError, RecordingError, ValueError or OSError in plain words.
    """
    if arguments.words is not None:
        return word_commands.search(arguments)
    values = {p.name: getattr(arguments, p.name) for p in analyses.parameters("search")}
    analyses.normalise(analyses.Request("", "search", values))  # refuses before anything is read
    texts = _texts(arguments)
    if arguments.out.is_dir():
        raise WorkspaceError(f"{arguments.out} is a folder; --out names the file to write.")
    with progress_bar(arguments.quiet) as report:
        dataset, index, reading = _open(arguments, values, texts, report)
        queries = {text: _query(text, lower, dataset, arguments) for text, lower in texts}
        answers, started = {}, time.perf_counter()
        for k, (text, one) in enumerate(queries.items()):
            answers[text] = _answer(index, one, arguments)
            if (others := index.not_compared(one.query)) and not arguments.quiet:
                words = f"{others} clips are not compared with it, for their bodies cannot be"
                print(f"note: {one.query.name}: {words}", file=sys.stderr)
            report("searching", (k + 1) / len(queries))
    seconds = {"reading": reading} | dict(index.seconds) | {"searching": time.perf_counter() - started}
    write_json(arguments.out, _document(index, answers, values, arguments, seconds))
    if not arguments.quiet:
        print("\n".join(_summary(answers, seconds, arguments)))
    return 0


def _texts(arguments: Namespace) -> list[tuple[str, str | None]]:
    """The queries as they were given, each with what its lower body comes from."""
    if (arguments.query is None) == (arguments.queries is None):
        raise WorkspaceError(
            "Say what to search for: --query CLIP[:START-END], --queries FILE with many, or --words TEXT."
        )
    if arguments.query is not None:
        return [(arguments.query, arguments.lower)]
    if arguments.lower is not None:
        raise WorkspaceError("--lower goes with --query, not with --queries.")
    try:
        listed = json.loads(arguments.queries.read_text(encoding="utf-8"))
    except (UnicodeDecodeError, json.JSONDecodeError) as error:
        raise WorkspaceError(f"{arguments.queries} is no JSON: {error}") from None
    if not isinstance(listed, list) or not listed or not all(isinstance(text, str) for text in listed):
        raise WorkspaceError(f'{arguments.queries}: expected a list of queries, such as ["walk_01", "walk_02:10-90"].')
    return [(text, None) for text in dict.fromkeys(listed)]


def _open(arguments: Namespace, values: Mapping[str, Any], texts, report: Report) -> tuple[Dataset, SearchIndex, float]:
    started = time.perf_counter()
    if named := stored_dataset(Namespace(**vars(arguments) | {"clips": None})):
        workspace, name = named
        dataset = workspace.open(name)
        if arguments.clips:
            open_source(arguments, report)  # refuses names that are not there
        reading = time.perf_counter() - started
        say_expected(request := analyses.Request(name, "search", values), workspace, arguments.quiet)
        return dataset, analyses.run(workspace, request, report), reading
    if arguments.clips:  # what is searched, and the clips that are searched for
        clips = [_clip_of(text) for pair in texts for text in pair if text is not None and _file(text) is None]
        arguments = Namespace(**vars(arguments) | {"clips": list(dict.fromkeys([*arguments.clips, *clips]))})
    dataset = open_source(arguments, report)
    reading = time.perf_counter() - started
    return dataset, analyses.compute(dataset, "search", values, report), reading


def _clip_of(text: str) -> str:
    match = _STRETCH.fullmatch(text)
    return match[1] if match else text


def _file(text: str) -> tuple[Path, str] | None:
    """The recording that ``text`` names, and the stretch behind it (``:10-90`` or nothing), where it is a file."""
    match = _STRETCH.fullmatch(text)
    for path, rest in ((text, ""), (match[1], f":{match[2]}-{match[3]}") if match else (text, "")):
        if Path(path).expanduser().is_file():
            return Path(path).expanduser(), rest
    return None


def _query(text: str, lower: str | None, dataset: Dataset, arguments: Namespace) -> _Query:
    stretches, clips = [], []
    for one in filter(None, (text, lower)):
        file = None if _clip_of(one) in dataset.names or one in dataset.names else _file(one)
        if file is None:
            stretches.append(parse_stretch(one, dataset))
            clips.append(stretches[-1][0].name)
        else:  # a recording that is not in the data set
            path, rest = file
            reading = {
                name: getattr(arguments, name) for name in ("skeleton", "unit", "up", "fps", "body", "points", "smooth")
            }
            other = open_dataset(path, **reading)
            stretches.append(parse_stretch(f"{other.names[0]}{rest}", other))
    of_whole_clips = all(start is None for _, start, _ in stretches)
    if lower is None:
        return _Query(whole_query(*stretches[0], name=text), of_whole_clips, tuple(clips))
    halves = {"upper_body": stretches[0], "lower_body": stretches[1]}
    return _Query(hybrid_query(halves, name=f"{text} + {lower}"), of_whole_clips, tuple(clips))


def _answer(index: SearchIndex, one: _Query, arguments: Namespace) -> dict[str, Any]:
    level = arguments.level or ("clip" if one.of_whole_clips else "interval")
    started = time.perf_counter()
    hits = index.search(
        one.query,
        weights=arguments.weights,
        level=level,
        top=arguments.top,
        root_path=arguments.root_path,
        only=arguments.clips,
        exclude=one.clips if level == "clip" else (),
    )
    duration = 1000 * (time.perf_counter() - started)
    rows = [{"clip": h.segment.clip, "start": h.segment.start, "end": h.segment.end, "score": h.score} for h in hits]
    for row, hit in zip(rows, hits, strict=True):
        if hit.query_segment is not None:
            row["query"] = {"start": hit.query_segment.start, "end": hit.query_segment.end}
    return {"milliseconds": round(duration, 3), "hits": rows}


def _document(index: SearchIndex, answers, values, arguments: Namespace, seconds) -> dict[str, Any]:
    searched = {
        "weights": arguments.weights,
        "level": arguments.level,
        "top": arguments.top,
        "root_path": arguments.root_path,
    }
    return {
        "format": FORMAT,
        "dataset": dict(index.dataset),
        "clips": [{"name": c.name, "frames": c.frames, "fps": c.fps} for c in index.clips],
        "parameters": dict(values) | searched,
        "seconds": {stage: round(duration, 4) for stage, duration in seconds.items()},
        "queries": answers,
    }


def _summary(answers: Mapping[str, Any], seconds: Mapping[str, float], arguments: Namespace) -> Iterator[str]:
    for stage, duration in seconds.items():
        yield f"  {stage:<14}{duration:8.2f} s"
    if len(answers) == 1:
        hits = next(iter(answers.values()))["hits"]
        for hit in hits[:_SHOWN]:
            yield f"{hit['score']:8.3f}  {hit['clip']}:{hit['start']}-{hit['end']}"
        if len(hits) > _SHOWN:
            yield f"          and {len(hits) - _SHOWN} more"
    else:
        times = sorted(answer["milliseconds"] for answer in answers.values())
        yield f"{len(times)} queries, {times[len(times) // 2]:.0f} ms each (median)"
    yield f"written to {arguments.out}"
