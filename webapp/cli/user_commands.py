"""The commands ``user`` and ``audit``: accounts of a workspace, and who changed what when."""

from __future__ import annotations

import argparse
import json
import sys
from dataclasses import asdict
from datetime import datetime
from getpass import getpass
from pathlib import Path
from typing import TYPE_CHECKING

from webapp.cli.arguments import whole

if TYPE_CHECKING:
    from core.workspace import Workspace

ACTIONS = ("add", "list", "remove", "role", "password")


def user_arguments(parser: argparse.ArgumentParser) -> None:
    """Arguments of ``motionscape user``."""
    parser.add_argument("action", choices=ACTIONS, metavar="|".join(ACTIONS), help="what to do")
    parser.add_argument("workspace", type=Path, metavar="WORKSPACE", help="folder of the workspace")
    parser.add_argument("name", nargs="?", metavar="NAME", help="name of the account (not for list)")
    roles = ("viewer", "editor", "owner")
    parser.add_argument(
        "--role", choices=roles, help="viewer sees, editor changes, owner also manages (default editor)"
    )
    parser.add_argument(
        "--dataset", metavar="NAME", help="the role is for this dataset only; elsewhere a new account views"
    )
    parser.add_argument("--password-stdin", action="store_true", help="read the password from standard input")
    parser.add_argument("--no-password", action="store_true", help="only a reverse proxy signs this account in")
    parser.add_argument("--json", action="store_true", help="list as JSON")


def audit_arguments(parser: argparse.ArgumentParser) -> None:
    """Arguments of ``motionscape audit``."""
    parser.add_argument("workspace", type=Path, metavar="WORKSPACE", help="folder of the workspace")
    parser.add_argument("--json", action="store_true", help="write JSON")
    parser.add_argument("--last", type=whole, metavar="N", help="only the newest N entries")


def user(arguments: argparse.Namespace) -> int:
    """Adds, lists, removes or changes accounts. Raises WorkspaceError, ParameterError."""
    from core.errors import ParameterError
    from core.workspace import Workspace

    # an account is the first thing that a new workspace may get
    workspace = Workspace(arguments.workspace, create=arguments.action == "add")
    if arguments.action == "list":
        return _list(workspace, arguments.json)
    if not arguments.name:
        raise ParameterError(f"Name the account: motionscape user {arguments.action} WORKSPACE NAME.")
    if arguments.action == "add":
        return _add(workspace, arguments)
    if arguments.action == "remove":
        workspace.users.remove(arguments.name)
        print(f"{arguments.name} has no account any more.")
    elif arguments.action == "role":
        if not arguments.role:
            raise ParameterError("Say which role: --role viewer, editor or owner.")
        workspace.users.set_role(arguments.name, arguments.role, arguments.dataset)
        print(f"{arguments.name} is {arguments.role} of {arguments.dataset or 'the workspace'} now.")
    else:
        workspace.users.set_password(arguments.name, _password(arguments))
        print(f"{arguments.name} has a new password; sessions with the old one have ended.")
    return 0


def _add(workspace: Workspace, arguments: argparse.Namespace) -> int:
    role, dataset = arguments.role or "editor", arguments.dataset
    if dataset:
        workspace.info(dataset)  # raises where there is none, before an account is made
    password = None if arguments.no_password else _password(arguments)
    workspace.users.add(arguments.name, password, "viewer" if dataset else role)
    if dataset:
        workspace.users.set_role(arguments.name, role, dataset)
    print(f"{arguments.name} is {role} of {dataset or 'the workspace'}.")
    return 0


def _list(workspace: Workspace, as_json: bool) -> int:
    accounts = workspace.users.list()
    if as_json:
        print(json.dumps([asdict(account) for account in accounts], indent=2))
        return 0
    for account in accounts:
        roles = "".join(f", {role} of {dataset}" for dataset, role in account.roles.items())
        print(f"{account.name}: {account.role}{roles}{'' if account.has_password else ' (no password)'}")
    if not accounts:
        print("There are no accounts: everyone on this machine may do everything.")
    return 0


def _password(arguments: argparse.Namespace) -> str:
    """The new password, from standard input or typed twice. Raises ParameterError."""
    from core.errors import ParameterError

    if arguments.password_stdin:
        return sys.stdin.readline().rstrip("\r\n")
    if not sys.stdin.isatty():
        raise ParameterError("A password is typed on a terminal; elsewhere give it with --password-stdin.")
    password = getpass(f"Password for {arguments.name}: ")
    if getpass("The same again: ") != password:
        raise ParameterError("The two passwords differ; nothing was changed.")
    return password


def audit(arguments: argparse.Namespace) -> int:
    """Prints the audit log of a workspace, oldest first. Raises WorkspaceError."""
    from core.workspace import Workspace

    entries = Workspace(arguments.workspace, create=False).audit.entries(arguments.last)
    if arguments.json:
        print(json.dumps([asdict(entry) for entry in entries], indent=2))
        return 0
    for entry in entries:
        when = datetime.fromtimestamp(entry.when).astimezone().isoformat(" ", "seconds")
        details = f" ({entry.details})" if entry.details else ""
        print(f"{when}  {entry.who}: {entry.what}: {entry.subject}{details}")
    return 0
