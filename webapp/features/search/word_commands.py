"""``motionscape search --words``: clips and stretches that show what a text says."""

from __future__ import annotations

import sys
import time
from argparse import Namespace
from collections.abc import Callable, Iterator, Mapping
from typing import Any

from core import analyses
from core.mocap.dataset import Dataset
from core.progress import Report
from core.retrieval.search import SearchIndex
from core.retrieval.words.finding import WordHit
from core.retrieval.words.search import Answer, WordSearch
from core.workspace import WorkspaceError
from webapp.cli.progress_bar import progress_bar
from webapp.cli.result_files import write_json
from webapp.cli.sources import open_source, stored_dataset

FORMAT = "motionscape/hits/1"
_SHOWN = 5  # hits that are printed


def search(arguments: Namespace) -> int:
    """Searches by words and writes hits.json, whose keys are the texts; prints the best hits and what is not known.

    Raises ParameterError, WorkspaceError, RecordingError, ValueError or OSError in plain words.
    """
    for name in ("query", "queries", "lower", "weights"):
        if getattr(arguments, name) is not None:
            raise WorkspaceError(f"--words goes without --{name}: say one or the other.")
    if arguments.out.is_dir():
        raise WorkspaceError(f"{arguments.out} is a folder; --out names the file to write.")
    values = {p.name: getattr(arguments, p.name) for p in analyses.parameters("search")}
    level, texts = arguments.level or "clip", list(dict.fromkeys(arguments.words))
    with progress_bar(arguments.quiet) as report:
        started = time.perf_counter()
        dataset, index = _open(arguments, values, report)
        reading, started = time.perf_counter() - started, time.perf_counter()
        words = WordSearch(dataset, index=index)
        seconds = {"reading": reading, "signals": time.perf_counter() - started}
        answers, times = {}, {}
        for k, text in enumerate(texts):
            started = time.perf_counter()
            answers[text] = words.search(text, level=level, top=arguments.top, only=arguments.clips)
            times[text] = 1000 * (time.perf_counter() - started)
            report("searching", (k + 1) / len(texts))
    seconds["searching"] = sum(times.values()) / 1000
    document = {
        "format": FORMAT,
        "dataset": {"name": dataset.name, "fingerprint": dataset.fingerprint},
        "clips": [{"name": c.name, "frames": c.n_frames, "fps": float(c.fps)} for c in dataset.clips],
        "parameters": {"words": texts, "level": level, "top": arguments.top},
        "seconds": {stage: round(duration, 4) for stage, duration in seconds.items()},
        "queries": {text: _answer(answer, times[text]) for text, answer in answers.items()},
    }
    write_json(arguments.out, document)
    for text, answer in answers.items():
        for note in notes(answer):
            print(f"note: {text}: {note}", file=sys.stderr)
    if not arguments.quiet:
        print("\n".join(_summary(answers, seconds, arguments)))
    return 0


def notes(answer: Answer) -> Iterator[str]:
    """What a person should know of an answer: words that nothing is known of, and bodies that cannot show a word."""
    for word, near in answer.unknown.items():
        yield f"the word {word!r} is not known" + (f"; known are {', '.join(near)}" if near else "")
    for term in answer.unseen:
        yield f"{term!r} cannot be seen: the bodies lack the joints for it"


def _open(arguments: Namespace, values: Mapping[str, Any], report: Report) -> tuple[Dataset, Callable[[], SearchIndex]]:
    if named := stored_dataset(Namespace(**vars(arguments) | {"clips": None})):
        workspace, name = named
        dataset = workspace.open(name)
        if arguments.clips:
            open_source(arguments, report)  # refuses names that are not there
        return dataset, lambda: analyses.run(workspace, analyses.Request(name, "search", values), report)
    dataset = open_source(arguments, report)
    return dataset, lambda: analyses.compute(dataset, "search", values, report)


def _answer(answer: Answer, milliseconds: float) -> dict[str, Any]:
    found = {"milliseconds": round(milliseconds, 3), "hits": [_row(hit) for hit in answer.hits]}
    if answer.unknown:
        found["unknown"] = {word: list(near) for word, near in answer.unknown.items()}
    if answer.unseen:
        found["unseen"] = list(answer.unseen)
    return found


def _row(hit: WordHit) -> dict[str, Any]:
    places = [{"word": p.text, "start": p.start, "end": p.end, "score": p.score} for p in hit.places]
    segment = hit.segment
    return {"clip": segment.clip, "start": segment.start, "end": segment.end, "score": hit.score, "words": places}


def _summary(answers: Mapping[str, Answer], seconds: Mapping[str, float], arguments: Namespace) -> Iterator[str]:
    for stage, duration in seconds.items():
        yield f"  {stage:<14}{duration:8.2f} s"
    for text, answer in answers.items():
        said = " then ".join(" and ".join(term.text for term in moment.all) for moment in answer.sentence.moments)
        yield f"{text}: {said or 'no word of it is known'}"
        for hit in answer.hits[:_SHOWN]:
            yield f"{hit.score:8.3f}  {hit.segment.clip}:{hit.segment.start}-{hit.segment.end}"
    yield f"written to {arguments.out}"
