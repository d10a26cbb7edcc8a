"""Ids of the parts that every page with a method has."""

from typing import Any

from webapp.shell.identifiers import Group, Id, Pattern, Store
from webapp.shell.names import Name, View


class MethodNames(Group):
    """Ids of the settings, the button and the status of the page ``page`` in the link."""

    def __init__(self, page: str):
        self.run = Id(f"{page}-run")
        self.fold = Id(f"{page}-fold")
        self.summary = Id(f"{page}-summary")
        self.form = Id(f"{page}-form")
        self.control = Pattern(f"{page}-setting", "name")
        self.status = Id(f"{page}-status")
        self.settings = Store(f"{page}-settings", View)  # those keys of the view that are settings of the page
        self.result_key = Store(f"{page}-result-key", Name)  # empty where the result has not been computed
        self.status_of = Store(f"{page}-status-of", list[Any])  # what the status was last drawn for
        self.again = Store(f"{page}-again", dict[str, bool | float])
