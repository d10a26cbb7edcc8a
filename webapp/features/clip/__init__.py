"""Clip: the curves of one clip, its gait, and edits of it."""

from webapp.features.clip import names, rights
from webapp.shell.feature import Command, Feature, later, link_keys

FEATURE = Feature(
    path="clip",
    label="Clip",
    symbol="pulse",
    page=later("webapp.features.clip.layout:page"),
    register=later("webapp.features.clip.callbacks:register"),
    shows=("chart",),
    keys=link_keys(names.View),
    routes=later("webapp.features.clip.routes:blueprints"),
    commands={
        "render": Command(
            "Write a clip, or frames of it, as a film or a picture.",
            later("webapp.features.clip.arguments:render"),
            later("webapp.features.clip.commands:render"),
        ),
    },
    rights=rights.RIGHTS,
)
