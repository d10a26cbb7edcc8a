"""Requests: a method or a task, a data set, and parameters."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from core.workspace import tasks


@dataclass(frozen=True)
class Request:
    """Do ``method`` to the data set called ``dataset``; parameters that are not given take their defaults."""

    dataset: str
    method: str
    parameters: Mapping[str, Any] = field(default_factory=dict)


def query_request(file: str, upload: str) -> Request:
    """The request that reads an upload, called ``file`` for people, as a query; stored under its key."""
    return Request(file, "query", {"upload": upload})


def import_request(name: str, upload: str, **options: Any) -> Request:
    """The request that imports an upload as the data set ``name``; options as in tasks.ImportParameters."""
    return Request(name, "import", {"upload": upload, **options})


def add_request(name: str, upload: str, **options: Any) -> Request:
    """The request that adds an upload to the data set ``name``; options as in tasks.AddParameters."""
    return Request(name, "add", {"upload": upload, **options})


def remove_request(name: str, clips: Iterable[str]) -> Request:
    """The request that removes clips from the data set ``name``."""
    return Request(name, "remove", {"clips": tasks.names_of_clips(clips)})


def edit_request(name: str, clip: str, action: str, **options: Any) -> Request:
    """The request that edits a clip of the data set ``name``; options as in tasks.EditParameters."""
    return Request(name, "edit", {"clip": clip, "action": action, **options})


def reread_request(name: str, **options: Any) -> Request:
    """The request that changes how clips of the data set ``name`` are read; options as in tasks.RereadParameters."""
    return Request(name, "reread", options)


def repair_request(name: str, repairs: Sequence[Mapping[str, Any]], version: str = "") -> Request:
    """The request that repairs clips of the data set ``name``; see tasks.RepairParameters."""
    return Request(name, "repair", {"repairs": json.dumps(list(repairs), ensure_ascii=False), "version": version})


def usual_repairs_request(name: str, clips: Iterable[str], kinds: Iterable[str] = ()) -> Request:
    """The request that gives findings of these ``kinds`` (all where none) in ``clips`` their usual repair."""
    kinds = tasks.names_of_clips(kinds) if kinds else ""
    return Request(name, "repair", {"clips": tasks.names_of_clips(clips), "kinds": kinds})
