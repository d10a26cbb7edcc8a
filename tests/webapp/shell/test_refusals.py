"""Refusals are sentences; faults of a library are no words for people."""

from __future__ import annotations

import numpy as np
import pytest

from core.workspace import WorkspaceError
from webapp.features.search.queries import read_query
from webapp.shell.refusals import said


def test_a_refusal_is_a_sentence():
    with pytest.raises(ValueError) as refused:
        read_query("what?")
    assert said(refused.value).startswith("A piece of a query looks like") and said(refused.value).endswith(".")
    assert said(WorkspaceError("Gone.")) == "Gone."


def test_a_fault_is_raised_again():
    with pytest.raises(ValueError) as fault:
        np.concatenate([np.zeros((2, 2)), np.zeros(3)])
    with pytest.raises(ValueError, match="dimensions"):
        said(fault.value)
