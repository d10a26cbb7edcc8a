"""New motion from recordings: walks through the motif graph, sentences of a grammar, pieces stitched in any order."""

from core.synthesis.derivations import Derivation, derive, perform
from core.synthesis.footing import Skate
from core.synthesis.links import Link
from core.synthesis.paths import Between, NoWay, Random, Ways, open_ways, parse_path
from core.synthesis.stitching import Speeds, Stitched, overlaps_between, seam_speed, stitch
from core.synthesis.walks import TRANSITION, Part, Route, Walk, find_route, make_walk

__all__ = [
    "TRANSITION",
    "Between",
    "Derivation",
    "Link",
    "NoWay",
    "Part",
    "Random",
    "Route",
    "Skate",
    "Speeds",
    "Stitched",
    "Walk",
    "Ways",
    "derive",
    "find_route",
    "make_walk",
    "open_ways",
    "overlaps_between",
    "parse_path",
    "perform",
    "seam_speed",
    "stitch",
]
