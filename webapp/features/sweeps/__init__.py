"""Sweeps: motif graphs over ranges of two settings, as charts, with a suggestion."""

from webapp.shell.feature import Command, Feature, LinkKeys, later

FEATURE = Feature(
    path="sweeps",
    label="Sweeps",
    symbol="sweep",
    page=later("webapp.features.sweeps.layout:page"),
    register=later("webapp.features.sweeps.callbacks:register"),
    shows=("chart",),
    keys=LinkKeys(names=("x", "y", "seeds")),
    commands={
        "sweep": Command(
            "Find motifs over ranges of parameters, at about the price of a few.",
            later("webapp.features.sweeps.arguments:sweep"),
            later("webapp.features.sweeps.commands:sweep"),
        )
    },
)
