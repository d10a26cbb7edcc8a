"""Parameters a step away from others, to see how much a result depends on them (MMG sections 5.2 and 5.4)."""

from __future__ import annotations

from dataclasses import replace
from typing import Any, TypeVar

from core.motifs.parameters import MotifParameters

Parameters = TypeVar("Parameters", bound=MotifParameters)

_FACTORS = {"kappa": 1.25, "rho": 1.25}  # a step of these multiplies
_GAMMA_STEP = 0.1


def neighbours(parameters: Parameters, kappa: int) -> dict[str, Parameters]:
    """The same with kappa, rho or gamma a step up or down, by what differs ("kappa 250"); of the same class.

    kappa: the number of letters that ``parameters`` stand for, as kappa may be "auto". A step is a quarter of kappa and
    rho and a tenth of gamma; steps out of range are left out.
    """
    values: dict[str, list[Any]] = {
        "kappa": [round(kappa / _FACTORS["kappa"]), round(kappa * _FACTORS["kappa"])],
        "rho": [round(parameters.rho / _FACTORS["rho"], 3), round(parameters.rho * _FACTORS["rho"], 3)],
        "gamma": [round(parameters.gamma - _GAMMA_STEP, 3), round(parameters.gamma + _GAMMA_STEP, 3)],
    }
    limits = {f: MotifParameters.__dataclass_fields__[f].metadata for f in values}
    return {
        f"{name} {value:g}": replace(parameters, **{name: value})
        for name, steps in values.items()
        for value in steps
        if limits[name]["min"] <= value <= limits[name]["max"] and value != (kappa if name == "kappa" else None)
    }


def other_seeds(parameters: Parameters, n: int) -> dict[str, Parameters]:
    """The same from random starts with the next ``n`` seeds, by name ("seed 1")."""
    seeds = range(parameters.seed + 1, parameters.seed + 1 + n)
    return {f"seed {seed}": replace(parameters, seed=seed, init="random") for seed in seeds}
