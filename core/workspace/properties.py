"""Properties of clips of data sets (core.mocap.properties), with every version of them: who changed what when."""

from __future__ import annotations

from core.errors import FormatError
from core.mocap.properties import Properties, from_json
from core.workspace.database import Database
from core.workspace.documents import Document, Documents, Kept
from core.workspace.errors import DocumentGone
from core.workspace.people import require

_KIND = "properties"


class PropertyStore(Documents[Properties]):
    """The properties of a workspace; a data set is known by its id. Who may see a data set may see them."""

    kept_versions = 20
    largest_document = 20_000_000

    def __init__(self, database: Database):
        super().__init__(database, _KIND, "properties of clips")

    def of(self, dataset: str) -> Properties:
        """The properties of a data set, also of clips that are not there any more. Raises DocumentDamaged."""
        try:
            return self.get(dataset)
        except DocumentGone:
            return Properties()

    def put(self, dataset: str, properties: Properties, what: str = "changed", author: str = "") -> int:
        """Keeps properties; gives the version before, for :meth:`restore`. Raises WorkspaceError (too large)."""
        try:
            before = self.version(dataset)
        except DocumentGone:
            self._create(Properties().to_json(), author, id=dataset)
            before = 1
        self._change(dataset, lambda present: properties.to_json(), author, what)
        return before

    def state(self, dataset: str) -> int:
        """A number that changes whenever the properties of a data set do, by one cheap query."""
        try:
            return self.version(dataset)
        except DocumentGone:
            return 0

    def forget_deleted(self) -> None:
        """Removes the properties of data sets that are gone for good."""
        with self._database.transaction("forget old properties") as table:
            for name in ("documents", "document_versions"):
                table.execute(f"DELETE FROM {name} WHERE kind = ? AND id NOT IN (SELECT id FROM datasets)", (_KIND,))

    def _content(self, kept: Kept) -> Properties:
        try:
            return from_json(kept.document)
        except FormatError as error:
            raise ValueError(str(error)) from error

    def _may_see(self, id: str) -> bool:
        return True

    def _require(self, id: str | None, document: Document | None, to: str) -> None:
        require("editor", id, to="change properties of clips")
