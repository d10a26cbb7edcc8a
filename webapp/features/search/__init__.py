"""Search: motions like a query, judged by people and by labels."""

from webapp.features.search import names, rights
from webapp.shell.feature import Block, Command, Feature, later, link_keys

FEATURE = Feature(
    path="search",
    label="Search",
    symbol="search",
    page=later("webapp.features.search.page:page"),
    register=later("webapp.features.search.page:register"),
    keys=link_keys(names.View),
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
    blocks={
        "hits": Block(
            "Search hits",
            "search",
            later("webapp.features.search.blocks:hits"),
            "search",
            later("webapp.features.search.blocks:segments"),
            keys=("query", "parts", "level", "route", "label", "named", "lasting", "top"),
            size=(5, 6),
            lasting=False,
        )
    },
    rights=rights.RIGHTS,
)
