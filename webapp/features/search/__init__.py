"""Search: motions like a query, and what people and labels say of what is found."""

from webapp.shell.feature import Command, Feature, LinkKeys, later

FEATURE = Feature(
    path="search",
    label="Search",
    symbol="search",
    page=later("webapp.features.search.page:page"),
    register=later("webapp.features.search.page:register"),
    keys=LinkKeys(
        names=(
            *("query", "parts", "level", "route", "label", "named", "lasting", "top"),  # see searching.py
            *("hit", "look", "study", "asks", "measure"),
        ),
        of_dataset=("query", "hit", "label", "named", "asks"),
        free_text=("query", "hit", "label", "named", "asks"),
    ),
    methods={"search": "search", "ranking": "ranking"},
    routes=later("webapp.features.search.routes:blueprints"),
    commands={
        "search": Command(
            "Find motions like one of a clip, by the whole body or the parts that matter.",
            later("webapp.features.search.arguments:search"),
            later("webapp.features.search.commands:search"),
        )
    },
    motion_kinds={"upload": later("webapp.features.search.uploaded:open_upload")},
)
