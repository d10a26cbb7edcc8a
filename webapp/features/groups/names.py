"""Ids of the Groups page, what its stores hold, and the keys of its links."""

from typing import Annotated, Any, TypedDict

from webapp.shell.feature import LinkKey
from webapp.shell.identifiers import Id, Store

_OF_DATASET = LinkKey(of_dataset=True, free_text=True)


class View(TypedDict, total=False):
    """The property that makes the groups, two of its values, the property that names who moves, and what is counted."""

    by: Annotated[str, _OF_DATASET]
    first: Annotated[str, _OF_DATASET]
    second: Annotated[str, _OF_DATASET]
    who: Annotated[str, _OF_DATASET]
    counted: Annotated[str, LinkKey(pattern="motifs|grammar|labels")]
    paired: Annotated[str, LinkKey(pattern="auto|yes|no")]


GROUPS_PLACE = Id("groups-place")  # what assets/groups fills
GROUPS_SHOWN = Store("groups-shown", Any)
