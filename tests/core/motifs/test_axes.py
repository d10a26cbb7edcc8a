"""Axes of a sweep: what people write, what is refused and why, which points come of it."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from core.errors import ParameterError
from core.motifs.axes import MOST_POINTS, PAPER, USUAL, points_of, read_axis, read_values, sweepable, write_axis
from core.motifs.parameters import MotifParameters


@pytest.mark.parametrize(
    ("text", "axis"),
    [
        ("kappa:50,100,200", ("kappa", (50, 100, 200))),
        ("kappa: 200, 50 auto,50", ("kappa", ("auto", 50, 200))),
        ("rho:5,.2,1", ("rho", (0.2, 1.0, 5.0))),
        ("adjacency:spheres,radius", ("adjacency", ("radius", "spheres"))),
    ],
)
def test_axes_as_people_write_them(text, axis):
    assert read_axis(text) == axis


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("kappa", "name:value"),
        ("", "name:value"),
        ("kappa:", "at least one value"),
        ("kappa:50,x", "'x' cannot be used; expected auto or a whole number from 2 to 20000"),
        ("kappa:1", "from 2"),
        ("rho:0.1", "rho: '0.1'"),
        ("rho:nan", "rho: 'nan'"),
        ("speed:1,2", "there are kappa, rho"),
        ("seed:1,2", "no parameter to sweep"),
        ("adjacency:cubes", "radius or spheres"),
        ("kappa:" + ",".join(map(str, range(2, 99))), "more than the 60"),
    ],
)
def test_what_cannot_be_used_is_said(text, said):
    with pytest.raises(ParameterError, match=said):
        read_axis(text)


@given(st.sampled_from(sweepable()), st.lists(st.integers(2, 60), min_size=1, max_size=8))
def test_an_axis_survives_being_written(parameter, numbers):
    words = parameter.words or tuple(
        parameter.minimum + (min(parameter.maximum, 60) - parameter.minimum) * n / 60 if float in parameter.kinds else n
        for n in numbers
    )
    text = " ".join(f"{word:g}" if isinstance(word, float) else str(word) for word in words)
    values = read_values(parameter.name, text)
    assert read_axis(write_axis(parameter.name, values)) == (parameter.name, values)


def test_every_parameter_has_values_to_begin_with():
    assert set(USUAL) == {parameter.name for parameter in sweepable()}
    for parameter in sweepable():
        values = USUAL[parameter.name]
        assert read_axis(write_axis(parameter.name, values)) == (parameter.name, values)
        assert parameter.default in (*values, "auto")


def test_points_are_all_combinations_the_seed_fastest():
    points = points_of(MotifParameters(gamma=2.0, seed=3), {"kappa": ("auto", 50), "rho": (0.2, 1.0)}, seeds=2)
    assert [(p.kappa, p.rho, p.seed) for p in points] == [
        ("auto", 0.2, 3), ("auto", 0.2, 4), ("auto", 1.0, 3), ("auto", 1.0, 4),
        (50, 0.2, 3), (50, 0.2, 4), (50, 1.0, 3), (50, 1.0, 4),
    ]  # fmt: skip
    assert {p.gamma for p in points} == {2.0}
    assert len(points_of(MotifParameters(), PAPER)) == 30
    assert points_of(MotifParameters(), {}) == (MotifParameters(),)


@pytest.mark.parametrize(
    ("axes", "seeds", "said"),
    [
        ({"kappa": (50,)}, 0, "seeds"),
        ({"kappa": (50,)}, 101, "seeds"),
        ({"seed": (1, 2)}, 1, "no parameter to sweep"),
        ({"kappa": ()}, 1, "not 0"),
        ({"kappa": range(2, 62), "rho": [1.0] * 60}, 1, f"1 to {MOST_POINTS} points"),
        ({"min_letters": (5, 40), "max_letters": (30,)}, 1, "min_letters"),
    ],
)
def test_sweeps_that_cannot_be_are_refused(axes, seeds, said):
    with pytest.raises(ParameterError, match=said):
        points_of(MotifParameters(), axes, seeds)
