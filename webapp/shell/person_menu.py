"""Who one is, in the header, and what the page hides from those who may not change anything.

The page only hides; the server decides (``webapp/shell/access.py``). Controls have one of the classes ``for-editors``
and ``for-owners``, or ``for-editors-to-change`` where others may read what they hold (``assets/shell/roles.css``).
"""

from __future__ import annotations

from typing import Any

from dash import html
from dash.development.base_component import Component

from core.workspace import Person, Workspace
from webapp.shell import names, sign_in
from webapp.shell.attributes import attributes
from webapp.shell.visitors import accounts_exist, current


def first_values(workspace: Workspace) -> dict[str, dict[str, Any]]:
    """What the frame says of who sends the current request: id of a component -> its properties."""
    person = current()
    return {
        names.SHELL: {"data-role": role_on_page(person)},
        names.PERSON: {"children": menu(person, accounts_exist(workspace))},
    }


def role_on_page(person: Person) -> str:
    """The role by which the page hides what someone may not do anywhere."""
    return "owner" if person.may("owner") else "editor" if person.may_change_something() else "viewer"


def menu(person: Person, accounts: bool) -> list[Component]:
    """The name and a button to sign out; for guests one to sign in, where there are accounts; else nothing."""
    if person.is_guest:
        link = html.A("Sign in", href=sign_in.ADDRESS, className="text-link")
        return [html.Span("Guest", className="person-name"), *([link] if accounts else [])]
    if not person.name:
        return []
    button = html.Button("Sign out", type="submit", className="sign-out")
    name = html.Span(person.name, className="person-name ellipsis", title=f"{person.name}, {person.role}")
    return [name, html.Form(button, action=sign_in.SIGN_OUT, method="POST", **attributes(aria_label="Sign out"))]
