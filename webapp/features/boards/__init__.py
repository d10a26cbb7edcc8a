"""Boards: what a team looks at together, and reports of it as single files."""

from webapp.features.boards import names, rights
from webapp.shell.feature import Block, Command, Feature, later, link_keys

_ARGUMENTS = "webapp.features.boards.arguments"
_COMMANDS = "webapp.features.boards.commands"

FEATURE = Feature(
    path="boards",
    label="Boards",
    symbol="board",
    page=later("webapp.features.boards.layout:page"),
    register=later("webapp.features.boards.callbacks:register"),
    keys=link_keys(names.View),
    routes=later("webapp.features.boards.routes:blueprints"),
    header=later("webapp.features.boards.layout:header"),
    commands={
        "report": Command(
            "Write a dataset or a board as one HTML file or PDF that needs no server.",
            later(f"{_ARGUMENTS}:report"),
            later(f"{_COMMANDS}:report"),
        ),
        "import-bundle": Command(
            "Take over a bundle: a dataset with its results, notes, views and boards.",
            later(f"{_ARGUMENTS}:import_bundle"),
            later(f"{_COMMANDS}:import_bundle"),
        ),
    },
    blocks={
        "text": Block(
            "Text",
            "edit",
            later("webapp.features.boards.text:content"),
            options={"markdown": "the text, in Markdown"},
            size=(4, 3),
        ),
        "stage": Block(
            "Stage loop",
            "play",
            later("webapp.features.boards.stage_block:content"),
            "motifs",
            segments=later("webapp.features.boards.stage_block:segments"),
            options={"selection": "what plays"},
            size=(4, 5),
            lasting=False,
        ),
        "view": Block(
            "Saved view",
            "link",
            later("webapp.features.boards.view_block:content"),
            options={"view": "the saved view"},
            size=(4, 4),
            lasting=False,
        ),
    },
    rights=rights.RIGHTS,
)
