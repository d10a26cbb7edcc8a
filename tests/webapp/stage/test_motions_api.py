"""The route that sends many motions at once: the same bytes as one by one, and each part's own error."""

from __future__ import annotations

import json
from urllib.parse import quote

import numpy as np
import pytest
from flask import Flask

from core.workspace import WorkspaceError
from tests.webapp.generated import walkers
from webapp.stage import motion_routes as motion_api
from webapp.stage.motion_routes import motion_blueprint

NAMES = ("walk", "a b/c", "up//down", "Ünïcødé 歩く", "100%&clip=x")


@pytest.fixture
def datasets():
    return {
        "walkers": walkers(NAMES, fps=120.0, seconds=2.0),
        "~walk~1": walkers(("walk",), name="~walk~1", seconds=1.0),
    }


@pytest.fixture
def client(datasets):
    def open_dataset(name):
        if name == "damaged":
            raise WorkspaceError("The files of “damaged” are damaged; import it again.")
        if name == "broken":
            raise ZeroDivisionError("secret internals")
        return datasets[name]

    app = Flask(__name__)
    app.register_blueprint(motion_blueprint(open_dataset))
    return app.test_client()


def ask(client, *rows, headers=None, **more):
    """``rows``: (clip, start, end[, dataset]); ``more``: other pairs of the query."""
    clips, starts, ends = ([row[k] for row in rows] for k in range(3))
    query = {"clip": clips, "start": starts, "end": ends, "dataset": [row[3] for row in rows if len(row) > 3]}
    return client.get("/api/motions", query_string={**query, **more}, headers=headers)


def split(data: bytes) -> list[bytes | str]:
    """The parts of an answer: bytes of a motion, or why there is none."""
    length = int(np.frombuffer(data, "<u4", 1)[0])
    told = json.loads(data[4 : 4 + length])["parts"]
    at, parts = 4 + length, []
    for part in told:
        assert at % 4 == 0, "positions must lie at whole words"
        parts.append(part.get("error") or data[at : at + part["bytes"]])
        at += part.get("bytes", 0)
    assert at == len(data)
    return parts


def test_each_part_is_what_the_route_of_one_motion_sends(client):
    rows = [("walk", 3, 90), ("a b/c", "", ""), ("up//down", 0, 240), (NAMES[3], 100, 101), (NAMES[4], 7, 8)]
    parts = split(ask(client, *rows, dataset="walkers").data)
    for (clip, start, end), part in zip(rows, parts, strict=True):
        alone = client.get(f"/api/motion/walkers/{quote(clip, safe='')}", query_string={"start": start, "end": end})
        assert part == alone.data


def test_parts_may_come_from_several_data_sets(client):
    parts = split(ask(client, ("walk", 0, 10, "walkers"), ("walk", 0, 60, "~walk~1")).data)
    assert [json.loads(part[4 : part.index(b"}") + 1])["end"] for part in parts] == [10, 60]


def test_an_error_leaves_the_other_parts_alone(client):
    rows = [("walk", 0, 9, "walkers"), ("swim", 0, 9, "walkers"), ("walk", 0, 999, "walkers"), ("walk", 0, 9, "nobody"),
            ("walk", 0, 9, "damaged"), ("walk", 0, 9, "broken"), ("walk", "x", 9, "walkers")]  # fmt: skip
    answer = ask(client, *rows)
    assert answer.status_code == 200
    first, *errors = split(answer.data)
    assert isinstance(first, bytes)
    words = ("no clip called “swim”", "frames 0 to 240", "no dataset called “nobody”", "import it again", "went wrong",
             "start must be a whole number")  # fmt: skip
    assert all(word in error for word, error in zip(words, errors, strict=True))
    assert b"secret" not in answer.data


@pytest.mark.parametrize(
    ("query", "words"),
    [
        ({"dataset": "walkers"}, "Between 1 and 48"),
        ({"dataset": "walkers", "clip": ["walk"] * 49}, "Between 1 and 48 clips can be asked for at once, not 49"),
        ({"dataset": ["walkers"] * 2, "clip": ["walk"] * 3}, "dataset is given 2 times for 3 clips"),
        ({"dataset": "walkers", "clip": ["walk"] * 3, "end": [5, 6]}, "end is given 2 times for 3 clips"),
        ({"dataset": "walkers", "clip": "walk", "fps": "x"}, "fps must be a positive number"),
    ],
)
def test_lists_that_do_not_fit_are_refused(client, query, words):
    answer = client.get("/api/motions", query_string=query)
    assert answer.status_code == 400 and words in answer.get_json()["error"]


def test_unchanged_motions_are_not_sent_again(client, datasets):
    rows = ("walk", 0, 9), ("a b/c", 0, 9)
    first = ask(client, *rows, dataset="walkers")
    known = {"If-None-Match": first.headers["ETag"]}
    assert ask(client, *rows, dataset="walkers", headers=known).status_code == 304
    assert ask(client, *rows[::-1], dataset="walkers", headers=known).status_code == 200
    datasets["walkers"] = walkers(NAMES[::-1], fps=120.0, seconds=2.0)  # the name now stands for other content
    assert ask(client, *rows, dataset="walkers", headers=known).status_code == 200


def test_only_who_names_all_contents_need_not_ask_again(client, datasets):
    versions = [datasets[name].fingerprint for name in ("walkers", "~walk~1")]
    rows = ("walk", 0, 9, "walkers"), ("walk", 0, 9, "~walk~1")
    assert "immutable" in ask(client, *rows, v=versions).headers["Cache-Control"]
    for partly in ([versions[0], ""], versions[::-1], [versions[0]]):
        assert "no-cache" in ask(client, *rows, v=partly).headers["Cache-Control"]
    wrong = ask(client, ("swim", 0, 9, "walkers"), v=versions[0])
    assert "no-cache" in wrong.headers["Cache-Control"], "what failed today may be there tomorrow"


def test_many_long_motions_share_one_limit(client, monkeypatch):
    monkeypatch.setattr(motion_api, "MAX_BATCH_VALUES", 2 * 33 * 3 * 50)
    parts = split(ask(client, ("walk", 0, 240), ("walk", 0, 100), dataset="walkers").data)
    steps = [json.loads(part[4 : part.index(b"}") + 1])["step"] for part in parts]
    assert steps == [5, 2]
