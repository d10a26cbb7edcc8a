"""Whether what the server puts into a store is of the shape that the store declares."""

from __future__ import annotations

import json
from typing import Any

from plotly.utils import PlotlyJSONEncoder

from webapp.shell.identifiers import Store
from webapp.shell.shapes import problem


def misfit(data: Any, store: Store) -> str | None:
    """Why ``data`` does not fit when it has come back from a browser; None where it does."""
    return problem(json.loads(json.dumps(data, cls=PlotlyJSONEncoder)), store.content, store)
