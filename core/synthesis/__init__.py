"""New motion from recordings: walks through the motif graph, and pieces stitched together in any order."""

from core.synthesis.footing import Skate
from core.synthesis.links import Link
from core.synthesis.paths import Between, NoWay, Random, Ways, open_ways, parse_path
from core.synthesis.stitching import Speeds, Stitched, overlaps_between, seam_speed, stitch
from core.synthesis.walks import TRANSITION, Part, Route, Walk, find_route, make_walk

__all__ = [
    "TRANSITION",
    "Between",
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
    "find_route",
    "make_walk",
    "open_ways",
    "overlaps_between",
    "parse_path",
    "seam_speed",
    "stitch",
]
