"""motionscape user and motionscape audit."""

from __future__ import annotations

import io
import json

import pytest

from core.workspace import Workspace
from tests.webapp.generated import walkers
from webapp.cli import user_commands
from webapp.cli.main import main


@pytest.fixture
def run(tmp_path, capsys, monkeypatch):
    def run(action, *more, stdin=""):
        monkeypatch.setattr("sys.stdin", io.StringIO(stdin))
        code = main(["user", action, str(tmp_path / "space"), *more])
        said = capsys.readouterr()
        return code, said.out, said.err

    return run


def test_accounts_are_added_listed_changed_and_removed(run, tmp_path):
    assert run("add", "ann", "--role", "owner", "--password-stdin", stdin="correct horse\n")[0] == 0
    assert run("add", "bob", "--no-password") == (0, "bob is editor of the workspace.\n", "")
    users = Workspace(tmp_path / "space").users
    assert users.sign_in("ann", "correct horse")[0].role == "owner"
    assert run("list")[1] == "ann: owner\nbob: editor (no password)\n"
    assert run("role", "bob", "--role", "viewer")[0] == 0 and users.person("bob").role == "viewer"
    assert run("password", "bob", "--password-stdin", stdin="battery staple\n")[0] == 0
    assert users.sign_in("bob", "battery staple")
    assert run("remove", "bob")[0] == 0
    assert [account["name"] for account in json.loads(run("list", "--json")[1])] == ["ann"]


def test_a_role_for_one_dataset(run, tmp_path):
    workspace = Workspace(tmp_path / "space")
    workspace.add_dataset("mine", walkers(("a",), seconds=2.0))
    assert run("add", "ann", "--role", "editor", "--dataset", "mine", "--no-password")[0] == 0
    assert run("list")[1] == "ann: viewer, editor of mine (no password)\n"
    assert run("add", "bob", "--dataset", "nothing", "--no-password")[0] == 2
    assert [account.name for account in workspace.users.list()] == ["ann"]


def test_the_password_is_typed_twice_on_a_terminal(run, tmp_path, monkeypatch):
    class Terminal(io.StringIO):
        def isatty(self):
            return True

    typed = iter(["correct horse", "correct horse", "one thing", "another"])
    monkeypatch.setattr(user_commands, "getpass", lambda prompt: next(typed))
    monkeypatch.setattr(io, "StringIO", Terminal)
    assert run("add", "ann")[0] == 0
    assert Workspace(tmp_path / "space").users.sign_in("ann", "correct horse")
    code, _, problem = run("add", "bob")
    assert code == 2 and "differ" in problem


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (("add", "ann"), "--password-stdin"),
        (("add", "ann", "--password-stdin"), "8 to 1,000 letters"),
        (("add", "a b", "--no-password"), "cannot be the name"),
        (("add",), "Name the account"),
        (("remove", "nobody"), "no workspace"),
        (("list",), "no workspace"),
    ],
)
def test_what_cannot_be_done_is_said_in_one_line(run, words, message):
    code, _, problem = run(*words)
    assert code == 2 and message in problem and problem.count("\n") == 1


def test_the_audit_log_is_printed_or_written_as_json(run, tmp_path, capsys):
    run("add", "ann", "--no-password")
    run("role", "ann", "--role", "viewer")
    assert main(["audit", str(tmp_path / "space")]) == 0
    first, second = capsys.readouterr().out.splitlines()
    assert first.endswith("account added: ann (editor)") and "role changed: ann (viewer)" in second
    assert main(["audit", str(tmp_path / "space"), "--json", "--last", "1"]) == 0
    (entry,) = json.loads(capsys.readouterr().out)
    assert (entry["what"], entry["subject"]) == ("role changed", "ann") and entry["who"]
    assert main(["audit", str(tmp_path / "nothing")]) == 2
