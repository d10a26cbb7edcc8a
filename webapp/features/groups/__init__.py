"""Groups: who does what, how often, and how differently."""

from webapp.features.groups import names, rights
from webapp.shell.feature import Command, Feature, later, link_keys

FEATURE = Feature(
    path="groups",
    label="Groups",
    symbol="groups",
    page=later("webapp.features.groups.layout:page"),
    register=later("webapp.features.groups.callbacks:register"),
    keys=link_keys(names.View),
    routes=later("webapp.features.groups.routes:blueprints"),
    commands={
        "compare-groups": Command(
            "Compare groups of clips: what one does more often, longer, faster or in another posture.",
            later("webapp.features.groups.arguments:compare_groups"),
            later("webapp.features.groups.commands:compare_groups"),
        )
    },
    rights=rights.RIGHTS,
)
