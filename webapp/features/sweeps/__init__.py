"""Sweeps: motif graphs over ranges of two settings, as charts, with a suggestion."""

from webapp.features.sweeps import names, rights
from webapp.shell.feature import Block, Command, Feature, later, link_keys

FEATURE = Feature(
    path="sweeps",
    label="Sweeps",
    symbol="sweep",
    page=later("webapp.features.sweeps.layout:page"),
    register=later("webapp.features.sweeps.callbacks:register"),
    shows=("chart",),
    keys=link_keys(names.View),
    commands={
        "sweep": Command(
            "Find motifs for ranges of parameters, which share most of the work.",
            later("webapp.features.sweeps.arguments:sweep"),
            later("webapp.features.sweeps.commands:sweep"),
        )
    },
    blocks={
        "sweep": Block(
            "Sweep chart",
            "sweep",
            later("webapp.features.sweeps.blocks:sweep_chart"),
            keys=("x", "y", "seeds"),
            size=(6, 6),
            lasting=False,
        )
    },
    rights=rights.RIGHTS,
)
