"""Clip: the curves of one clip, its gait, and edits of it."""

from webapp.shell.feature import Feature, LinkKeys, later

FEATURE = Feature(
    path="clip",
    label="Clip",
    symbol="pulse",
    page=later("webapp.features.clip.layout:page"),
    register=later("webapp.features.clip.callbacks:register"),
    keys=LinkKeys(names=("chart", "angles", "joints", "rig", "channels", "span"), of_dataset=("joints",)),
    routes=later("webapp.features.clip.routes:blueprints"),
)
