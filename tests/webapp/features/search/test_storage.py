"""The tables of what the indexes hold (Tables 1 to 3 of PCR), from indexes to the page."""

from __future__ import annotations

import numpy as np
import pytest

from core import analyses
from core.demo import make_demo
from core.mocap.dataset import Dataset
from core.poses.body_parts import NODES
from core.retrieval.storage import storage_of
from core.workspace import Workspace
from webapp.app import create_app
from webapp.features.search import storage
from webapp.features.search.figures.storage import size
from webapp.shell import settings


@pytest.fixture(scope="module")
def workspace(tmp_path_factory: pytest.TempPathFactory) -> Workspace:
    """A few clips of the demo, with the indexes of two of the three engines."""
    made = Workspace(tmp_path_factory.mktemp("storage") / "workspace")
    clip = make_demo(minutes=0.5).clips[0]
    cuts = tuple(clip.cut(k, k + 120, f"cut{k}") for k in range(0, clip.n_frames - 120, 120))[:3]
    made.add_dataset("demo", Dataset("demo", cuts))
    for method in ("bounded-edit", "parts"):
        analyses.run(made, analyses.Request("demo", "search", {"method": method}))
    return made


def test_sizes_are_those_of_the_arrays_that_are_kept(workspace):
    index = settings.result_of(workspace, "search", "demo", {"search-method": "parts"})
    found = storage_of(index)
    _, arrays = index.engine.pack()

    def kept(*names: str) -> int:
        return sum(array.nbytes for key, array in arrays.items() if key.partition(".")[2] in names)

    assert found.library == kept("patterns") and found.frames == arrays["codes"].nbytes
    assert found.lists == kept("symbols", "begins", "ends", "starts")
    index.engine.nodes["whole_body"].library.distances  # noqa: B018 (made when first asked for)
    assert found.maps == sum(node.library.distances.nbytes for node in index.engine.nodes.values())
    assert [row.node for row in found.nodes] == list(NODES) and found.clips == len(index.clips)
    assert np.isclose(found.seconds, index.seconds["index"])


def test_every_engine_has_a_row_and_those_with_patterns_a_table(workspace):
    indexes = storage.indexes_of(workspace, "demo", {"look": "indexes"})
    assert list(indexes) == ["bounded-edit", "parts", "printed"]
    assert indexes["printed"] is None and indexes["bounded-edit"].nodes == () and indexes["parts"].library > 0
    again = storage.indexes_of(workspace, "demo", {"look": "indexes", "hits": "20"})
    assert again["parts"] is indexes["parts"]  # nothing is searched again to time it
    shown = str(storage.result(workspace, "demo", {"look": "indexes", "search-method": "parts"}))
    assert "not built" in shown and "Bounded edit" in shown and size(indexes["parts"].maps) in shown
    assert indexes["parts"].query > 0 and f"{indexes['parts'].query * 1e3:.0f} ms" not in ("0 ms", "")
    for row in indexes["parts"].nodes:
        assert f"{row.mean_frames:.1f} ± {row.deviation:.1f}" in shown and f"{row.patterns:,}" in shown


def test_other_settings_have_other_indexes(workspace):
    indexes = storage.indexes_of(workspace, "demo", {"look": "indexes", "search-r": "2"})
    assert set(indexes.values()) == {None}


def test_the_page_has_the_view(workspace):
    app = create_app(workspace.path)
    assert any("search-storage.children" in key for key in app.callback_map)


def test_sizes_are_written_for_people():
    assert size(1_449_000) == "1.4 MB" and size(640) == "0.6 kB"
