"""Accounts and the audit log."""

from __future__ import annotations

import sqlite3

import pytest

from core.analyses import Request, execute, submit
from core.workspace import Person, Workspace, WorkspaceError, acting_as


@pytest.fixture
def users(workspace):
    return workspace.users


def test_an_account_signs_in_with_its_password_only(users):
    assert not users.exist()
    users.add("ann", "correct horse", "owner")
    assert users.exist() and [(a.name, a.role, a.has_password) for a in users.list()] == [("ann", "owner", True)]
    person, session = users.sign_in("ann", "correct horse")
    assert person == Person("ann", "owner") == users.person("ann", session)
    assert users.sign_in("Ann", "correct horse")[0].name == "ann"
    for name, password in (("ann", "wrong horse"), ("ann", ""), ("bob", "correct horse"), ("ann", "x" * 10_000)):
        assert users.sign_in(name, password) is None


def test_the_password_is_nowhere_in_the_database(workspace, users):
    users.add("ann", "correct horse")
    users.add("bob", "correct horse")
    with sqlite3.connect(workspace.path / "workspace.sqlite") as table:
        kept = [row[0] for row in table.execute("SELECT password FROM users")]
        assert "correct horse" not in "\n".join(table.iterdump())
    assert kept[0] != kept[1] and all(text.startswith("scrypt$") for text in kept)


def test_another_password_ends_the_sessions(users):
    users.add("ann", "correct horse")
    _, session = users.sign_in("ann", "correct horse")
    users.set_password("ann", "battery staple")
    assert users.person("ann", session) is None and users.sign_in("ann", "correct horse") is None
    person, session = users.sign_in("ann", "battery staple")
    assert users.person("ann", session) == person
    users.remove("ann")
    assert users.person("ann", session) is None and users.list() == []


def test_an_account_without_a_password_cannot_sign_in_by_one(users):
    users.add("ann", None)
    assert users.sign_in("ann", "") is None and users.sign_in("ann", "anything at all") is None
    assert users.person("ann") == Person("ann", "editor")


def test_a_damaged_hash_admits_nobody(workspace, users):
    users.add("ann", "correct horse")
    for damage in ("scrypt$zz$00", "x", "scrypt$00"):
        with sqlite3.connect(workspace.path / "workspace.sqlite") as table:
            table.execute("UPDATE users SET password = ?", (damage,))
        assert users.sign_in("ann", "correct horse") is None


def test_a_role_for_one_dataset_stays_when_it_is_renamed(workspace, users):
    from core.demo import make_demo

    workspace.add_dataset("mine", make_demo(minutes=0.2, seed=1))
    users.add("ann", None, "viewer")
    users.set_role("ann", "editor", "mine")
    workspace.rename("mine", "renamed")
    assert users.list()[0].roles == {"renamed": "editor"}
    person = users.person("ann")
    assert person.role == "viewer" and person.may("editor", workspace.info("renamed").id) and not person.may("editor")


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("", "longenough"), "cannot be the name"),
        (("a b", "longenough"), "cannot be the name"),
        (("a,b", "longenough"), "cannot be the name"),
        (("<b>", "longenough"), "cannot be the name"),
        (("ann", "short"), "8 to 1,000 letters"),
        (("ann", "longenough", "king"), "A role is viewer, editor, owner"),
    ],
)
def test_what_is_no_account_is_refused(users, arguments, message):
    with pytest.raises(WorkspaceError, match=message):
        users.add(*arguments)
    assert not users.exist()


def test_unknown_and_taken_names_are_refused(users):
    users.add("ann", None)
    with pytest.raises(WorkspaceError, match="already"):
        users.add("ANN", None)
    for refused in (
        lambda: users.remove("bob"),
        lambda: users.set_role("bob", "owner"),
        lambda: users.set_password("bob", "longenough"),
    ):
        with pytest.raises(WorkspaceError, match="no account 'bob'"):
            refused()
    with pytest.raises(WorkspaceError, match="no dataset"):
        users.set_role("ann", "owner", "nothing")


def test_the_secret_of_the_sessions_is_made_once(workspace, users):
    again = Workspace(workspace.path)
    assert users.secret() == again.users.secret() and len(users.secret()) > 30
    again.close()


def test_the_audit_log_says_who_did_what_when(workspace):
    with acting_as(Person("ann", "owner")):
        workspace.users.add("bob", None, "editor")
    with acting_as(Person("bob", "editor")):
        board = workspace.boards.create("Overview")
        workspace.comments.add(f"board:{board.id}", "hello")
        workspace.boards.rename(board.id, "Report")
        workspace.boards.delete(board.id)
    entries = workspace.audit.entries()
    assert [(entry.who, entry.what, entry.subject) for entry in entries] == [
        ("ann", "account added", "bob"),
        ("bob", "board made", "Overview"),
        ("bob", "comment added", f"board:{board.id}"),
        ("bob", "board: renamed", "Report"),
        ("bob", "board deleted", "Report"),
    ]
    assert entries[0].when <= entries[-1].when and workspace.audit.entries(2) == entries[-2:]


def test_what_a_job_does_is_noted_under_the_name_of_who_started_it(workspace):
    with acting_as(Person("ann", "editor")):
        job = submit(workspace, Request("demo", "demo", {"minutes": 0.5}))
    execute(workspace, workspace.jobs.claim(job.id))
    with acting_as(Person("bob", "editor")):
        workspace.rename("demo", "mine")
    found = [(entry.who, entry.what, entry.subject) for entry in workspace.audit.entries()]
    assert found == [
        ("ann", "job started", "Demo: demo"),
        ("ann", "dataset added", "demo"),
        ("ann", "job started", "Motif graph: demo"),  # which the demo asks for, as the next three
        ("ann", "job started", "Motion map: demo"),
        ("ann", "job started", "Search index: demo"),
        ("ann", "job started", "Grammar: demo"),
        ("bob", "dataset renamed", "demo"),
    ]


def test_a_refused_change_leaves_no_entry(workspace):
    with acting_as(Person("ann", "viewer")), pytest.raises(WorkspaceError):
        workspace.boards.create("Overview")
    assert workspace.audit.entries() == []
