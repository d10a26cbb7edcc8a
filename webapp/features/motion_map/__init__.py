"""Map: all postures on one plane, and searches by postures and paths."""

from webapp.shell.feature import Command, Feature, LinkKeys, later

FEATURE = Feature(
    path="map",
    label="Map",
    symbol="map",
    page=later("webapp.features.motion_map.layout:page"),
    register=later("webapp.features.motion_map.callbacks:register"),
    keys=LinkKeys(
        names=("keys", "drawn", "within", "pace", "way", "colour", "click", "below", "region"),
        of_dataset=("keys", "drawn", "region"),
        patterns={
            "keys": r"\d{1,4}-\d{1,4}(,\d{1,4}-\d{1,4})*",
            "drawn": r"[\d.]{1,8}-[\d.]{1,8}(,[\d.]{1,8}-[\d.]{1,8})+",
            "region": r"\d{1,6}",
        },
    ),
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
)
