"""Reports that the app writes: in a thread each, with progress, kept until what they show has changed."""

from __future__ import annotations

import hashlib
import json
import tempfile
import threading
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Literal

import numpy as np

from core.errors import MotionscapeError
from core.progress import Cancelled
from core.progress import Report as Progress
from core.workspace import AccessRefused, Board, ResultDamaged, Workspace
from webapp.features.boards.documents import fingerprints
from webapp.features.boards.parts import Part
from webapp.features.boards.report import make_report
from webapp.features.boards.report_parts import asked_parts, title_of
from webapp.shell import settings
from webapp.shell.errors import log_bug

Form = Literal["html", "pdf"]
FORMAT = "motionscape/report/1"
AT_ONCE = 2  # threads that write; others wait
_turns = threading.BoundedSemaphore(AT_ONCE)


@dataclass
class Writing:
    """A report in the making. words: what it is doing; fraction: 0 to 1; error: why it failed, as a sentence."""

    words: str = "waiting"
    fraction: float = 0.0
    error: str = ""
    stopped: bool = False
    job: int | None = None
    thread: threading.Thread | None = field(default=None, repr=False)

    def report(self, stage: str, fraction: float) -> None:
        """Notes progress. Raises Cancelled where someone has stopped it."""
        if self.stopped:
            raise Cancelled
        self.words, self.fraction = stage, fraction


class Reports:
    """The reports of a workspace that are written or have been."""

    def __init__(self, workspace: Workspace):
        self.workspace = workspace
        self._writing: dict[str, Writing] = {}
        self._lock = threading.Lock()

    def ask(self, dataset: str, board: Board | None, form: Form, again: bool = False) -> dict[str, object]:
        """State of a report, which begins to be written where it is not there: ``key``, ``ready``, ``words``,
        ``fraction``, ``error``, and once it is ready ``size``, ``left_out``, ``motion``. again: after it failed."""
        key = self._key(dataset, board, form)
        made = self._made(key)
        if made is not None:
            return {"key": key, "ready": True, **made[0]}
        with self._lock:
            writing = self._writing.get(key)
            if writing is None or (again and writing.error):
                parts, title = asked_parts(board, dataset), title_of(board, dataset)
                asked = {"form": form, "board": board.id if board else ""}
                writing = self._writing[key] = Writing(job=self._entered(key, dataset, title, asked))
                arguments = (writing, key, dataset, parts, title, form)
                writing.thread = threading.Thread(target=self._write, args=arguments, daemon=True)
                writing.thread.start()
        state = {"words": writing.words, "fraction": writing.fraction, "error": writing.error}
        return {"key": key, "ready": False, **state}

    def stop(self, key: str) -> None:
        """Stops one that is being written."""
        with self._lock:
            writing = self._writing.pop(key, None)
        if writing is not None:
            writing.stopped = True

    def file(self, key: str) -> tuple[str, bytes] | None:
        """Name and content of a report that is ready; None for another key. Raises NameRefused for what is no key."""
        made = self._made(key)
        return (str(made[0]["name"]), made[1]) if made else None

    def _entered(self, key: str, dataset: str, title: str, asked: dict[str, str]) -> int | None:
        """The job of a report, so that the job bar shows and stops it; None for those who may start no jobs."""
        request = {"dataset": dataset, "method": "report", "parameters": asked}
        try:
            job = self.workspace.jobs.submit(key, request, f"Report: {title}", held="The app writes it.")
        except AccessRefused:
            return None
        claimed = self.workspace.jobs.claim(job.id)
        return claimed.id if claimed else None

    @contextmanager
    def _told(self, writing: Writing) -> Iterator[Progress]:
        """What notes progress, also in the table; there the job ends with the block, as the block does."""
        if writing.job is None:
            yield writing.report
            return
        jobs, job = self.workspace.jobs, writing.job
        try:
            with jobs.working(job) as tell:

                def both(stage: str, fraction: float) -> None:
                    writing.report(stage, fraction)
                    tell(stage, fraction)

                yield both
        except Cancelled:
            jobs.stopped(job)
            raise
        except Exception as error:
            jobs.fail(job, str(error) if isinstance(error, MotionscapeError) else "Something went wrong on the server.")
            raise
        jobs.finish(job)

    def _write(self, writing: Writing, key: str, dataset: str, parts: Sequence[Part], title: str, form: Form) -> None:
        try:
            with self._told(writing) as report, _turns:
                made = make_report(self.workspace, dataset, parts, title, report)
                content = _printed(made.html) if form == "pdf" else made.html.encode()
                facts = {"size": len(content), "left_out": list(made.left_out), "motion": made.motion}
                document = {"format": FORMAT, "name": f"{title.replace('/', '-')}.{form}", **facts}
                self.workspace.results.put(key, document, {"bytes": np.frombuffer(content, np.uint8)})
            with self._lock:
                self._writing.pop(key, None)
        except Cancelled:
            writing.error = "Writing the report was stopped."
        except MotionscapeError as error:
            writing.error = str(error)
        except Exception as error:
            writing.error = f"Something went wrong on the server (error {log_bug('report', error)})."

    def _made(self, key: str) -> tuple[dict[str, object], bytes] | None:
        try:
            found = self.workspace.results.get(key)
        except ResultDamaged:
            return None
        if found is None or found.document.get("format") != FORMAT:
            return None
        facts = {name: found.document[name] for name in ("name", "size", "left_out", "motion")}
        return facts, found.arrays["bytes"].tobytes()

    def _key(self, dataset: str, board: Board | None, form: Form) -> str:
        """Changes with all that a report shows."""
        opened, info = self.workspace.open(dataset), self.workspace.info(dataset)
        shown = [
            (part.kind, dict(part.view), dict(part.options), part.title, part.note, part.columns)
            for part in asked_parts(board, dataset)
        ]
        results = [settings.key_of(self.workspace, name, dataset, {}) for name in settings.methods()]
        data = [fingerprints(self.workspace), opened.labels, self.workspace.notes.state(info.id), results]
        text = json.dumps(["report", form, dataset, title_of(board, dataset), shown, data], default=str)
        return hashlib.blake2b(text.encode(), digest_size=16).hexdigest()


def _printed(html: str) -> bytes:
    from webapp.features.boards.printing import write_pdf

    with tempfile.TemporaryDirectory(prefix="motionscape-") as folder:
        path = Path(folder, "report.pdf")
        write_pdf(html, path)
        return path.read_bytes()
