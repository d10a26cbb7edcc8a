"""Motifs: the motif graph and all that is made of it: walks, blends, comparisons, compression, reports."""

from webapp.features.motifs import names, rights
from webapp.shell.feature import Block, Command, Feature, SelectionKind, later, link_keys
from webapp.shell.names import MOTIF_METHOD

_ARGUMENTS = "webapp.features.motifs.arguments"
_BLOCKS = "webapp.features.motifs.blocks"
_RECIPES = "webapp.features.motifs.recipes"

FEATURE = Feature(
    path="motifs",
    label="Motifs",
    symbol="graph",
    page=later("webapp.features.motifs.layout:page"),
    register=later("webapp.features.motifs.callbacks:register"),
    shows=("graph", "table"),
    first_values=later("webapp.features.motifs.callbacks:first_values"),
    drawings={names.MOTIF_GRAPH: later("webapp.features.motifs.figures.drawing:first_graph")},
    places=later("webapp.features.motifs.places:places"),
    keys=link_keys(names.View),
    methods={"motifs": "motifs"},
    on_every_page=("motifs",),
    routes=later("webapp.features.motifs.routes:blueprints"),
    stores=later("webapp.features.motifs.layout:stores"),
    commands={
        "motifs": Command(
            "Find the motions that recur and how they follow one another.",
            later(f"{_ARGUMENTS}:motifs"),
            later("webapp.features.motifs.commands:motifs"),
        ),
        "compare": Command(
            "Compare two results of the same recordings.",
            later(f"{_ARGUMENTS}:compare"),
            later("webapp.features.motifs.compare_commands:compare_files"),
        ),
        "stability": Command(
            "Measure how reliably each motif is found again: with noise, other seeds and neighbouring settings.",
            later(f"{_ARGUMENTS}:stability"),
            later("webapp.features.motifs.compare_commands:measure_stability"),
        ),
        "walk": Command(
            "Make new motion along a path through a motif graph.",
            later(f"{_ARGUMENTS}:walk"),
            later("webapp.features.motifs.walk_commands:walk"),
        ),
    },
    recipes={
        "motifs": later("webapp.shell.recipes:command"),
        "stability": later("webapp.shell.recipes:command"),
        "walk": later(f"{_RECIPES}:walk_commands"),
    },
    selections=(
        SelectionKind("motif", numbers=("motion",)),
        SelectionKind("motifs", pattern=r"\d{1,6}(-\d{1,6}){0,299}", example="3-7-9"),
        SelectionKind("edge", numbers=("transition",), pattern=r"\d{1,6}-\d{1,6}", example="3-5"),
    ),
    plays=later("webapp.features.motifs.playing:plays"),
    missing=later("webapp.features.motifs.playing:missing"),
    replay_on=(MOTIF_METHOD.result_key,),
    blocks={
        "graph": Block(
            "Motif graph", "graph", later(f"{_BLOCKS}:graph"), "motifs", later(f"{_BLOCKS}:segments"), size=(7, 8)
        ),
        "matrix": Block(
            "Transition matrix",
            "table",
            later(f"{_BLOCKS}:matrix"),
            "motifs",
            later(f"{_BLOCKS}:segments"),
            size=(5, 8),
        ),
        "motifs": Block(
            "Table of motifs",
            "table",
            later(f"{_BLOCKS}:motif_table"),
            "motifs",
            later(f"{_BLOCKS}:segments"),
            size=(7, 6),
        ),
        "numbers": Block(
            "Big numbers",
            "pulse",
            later(f"{_BLOCKS}:numbers"),
            "motifs",
            size=(12, 2),
            options={"figures": "which, such as: coverage, n_motifs"},
        ),
    },
    motion_kinds={
        "walk": later("webapp.features.motifs.walks:open_walk"),
        "blend": later("webapp.features.motifs.mixtures:open_blend"),
        "rebuilt": later("webapp.features.motifs.mixtures:open_rebuilt"),
    },
    rights=rights.RIGHTS,
)
