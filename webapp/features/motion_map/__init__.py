"""Map: all postures on one plane, and searches by postures and paths."""

from webapp.features.motion_map import names, rights
from webapp.shell.feature import Block, Command, Feature, later, link_keys

FEATURE = Feature(
    path="map",
    label="Map",
    symbol="map",
    page=later("webapp.features.motion_map.layout:page"),
    register=later("webapp.features.motion_map.callbacks:register"),
    shows=("chart",),
    first_values=later("webapp.features.motion_map.callbacks:first_values"),
    keys=link_keys(names.View),
    methods={"map": "map"},
    routes=later("webapp.features.motion_map.routes:blueprints"),
    commands={
        "map": Command(
            "Lay the postures of all recordings out on a map.",
            later("webapp.features.motion_map.commands:arguments"),
            later("webapp.features.motion_map.commands:map_"),
        )
    },
    recipes={"map": later("webapp.shell.recipes:command")},
    blocks={
        "map": Block(
            "Motion map",
            "map",
            later("webapp.features.motion_map.blocks:motion_map"),
            "map",
            later("webapp.features.motion_map.blocks:segments"),
            size=(5, 8),
        )
    },
    rights=rights.RIGHTS,
)
