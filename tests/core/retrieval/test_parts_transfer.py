"""The constants of the engine parts hold on several collections: whoever changes one sees where it loses."""

import pytest

from benchmarks import bench_parts, labelled

LOST = 0.03
CLIPS = 60
AS_SHIPPED = {"bandai_namco_1": 0.630, "bandai_namco_2_part": 0.827, "demo": 0.941, "CMU exercises": 0.992}
"""XSTYLE mAP of CLIPS clips, measured as `python -m benchmarks parts` does."""


def some_of(name, request):
    if name != "demo":
        request.getfixturevalue("shared_data")
    made = labelled.demo_cuts(5) if name == "demo" else labelled.COLLECTIONS[name]()
    if made is None:
        pytest.skip(f"{name} is not here")
    return bench_parts.some(made, CLIPS)


@pytest.mark.parametrize("name", AS_SHIPPED)
def test_no_collection_loses(name, request):
    dataset, labels = some_of(name, request)
    assert bench_parts.mean_precision(bench_parts.engine_of(dataset), dataset, labels) > AS_SHIPPED[name] - LOST


def test_other_constants_are_noticed(request):
    """As they were before: postures not divided by the size of the motion, and twice the tolerance."""
    dataset, labels = some_of("bandai_namco_1", request)
    engine = bench_parts.engine_of(dataset, evenness=0.0)
    before = bench_parts.mean_precision(engine, dataset, labels, tolerance=0.4)
    assert before < AS_SHIPPED["bandai_namco_1"] - LOST
