"""Grammar: the actions of the recordings, the rules of what follows what, and new motion that obeys them."""

from webapp.features.grammar import names, rights
from webapp.shell.feature import Block, Command, Feature, SelectionKind, later, link_keys

FEATURE = Feature(
    path="grammar",
    label="Grammar",
    symbol="branches",
    page=later("webapp.features.grammar.layout:page"),
    register=later("webapp.features.grammar.callbacks:register"),
    places=later("webapp.features.grammar.places:places"),
    keys=link_keys(names.View),
    methods={"grammar": "grammar"},
    routes=later("webapp.features.grammar.routes:blueprints"),
    commands={
        "grammar": Command(
            "Learn elementary actions and the rules of what follows what.",
            later("webapp.features.grammar.arguments:grammar"),
            later("webapp.features.grammar.commands:grammar"),
        ),
        "derive": Command(
            "Make new motion that obeys a grammar.",
            later("webapp.features.grammar.arguments:derive"),
            later("webapp.features.grammar.commands:derive_"),
        ),
    },
    recipes={
        "grammar": later("webapp.shell.recipes:command"),
        "derive": later("webapp.features.grammar.recipes:derive_commands"),
    },
    selections=(SelectionKind("action", numbers=("segment",)),),
    clip_colours=("actions",),
    plays=later("webapp.features.grammar.playing:plays"),
    missing=later("webapp.features.grammar.playing:missing"),
    motion_kinds={
        "derive": later("webapp.features.grammar.compositions:open_derivation"),
        "bakeoff": later("webapp.features.grammar.bakeoffs:open_bakeoff"),
    },
    blocks={
        "actions": Block(
            "Action string",
            "branches",
            later("webapp.features.grammar.blocks:action_string"),
            "grammar",
            later("webapp.features.grammar.blocks:segments"),
            size=(12, 5),
        )
    },
    rights=rights.RIGHTS,
)
