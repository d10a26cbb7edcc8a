"""What an analysis will take, said on the command line before it starts."""

from __future__ import annotations

import sys
from contextlib import suppress

from core import analyses
from core.estimates import advice_for, estimate, estimate_of
from core.mocap.dataset import Dataset
from core.workspace import Workspace, WorkspaceError

WORTH_SAYING = 30.0  # seconds


def say_expected(request: analyses.Request, where: Workspace | Dataset, quiet: bool) -> None:
    """Says on stderr what an analysis will take, unless it is short or its result is there already.

    where: the workspace of the request's dataset, or a dataset that no workspace knows. Raises ParameterError.
    """
    if quiet:
        return
    request = analyses.normalise(request)
    with suppress(WorkspaceError):
        if isinstance(where, Dataset):
            expected = estimate_of(where, request)
        elif request.method not in analyses.TASKS and where.results.has(analyses.key(where, request)):
            return
        else:
            expected = estimate(where, request)
        if expected and (words := expected.objection(advice_for(request))):
            print(f"note: {words}", file=sys.stderr)
        elif expected and expected.middle[0] > WORTH_SAYING:
            print(f"note: expected to take {expected.words} of memory", file=sys.stderr)
