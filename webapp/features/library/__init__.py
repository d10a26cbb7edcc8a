"""Library: datasets, clips, the import report, labels, and import and export of files."""

from webapp.features.library import names, rights
from webapp.shell.feature import Block, Command, Feature, later, link_keys

_ARGUMENTS = "webapp.features.library.arguments"
_BLOCKS = "webapp.features.library.blocks"
_COMMANDS = "webapp.features.library.commands"

FEATURE = Feature(
    path="library",
    label="Library",
    symbol="library",
    page=later("webapp.features.library.layout:page"),
    register=later("webapp.features.library.callbacks:register"),
    shows=("table",),
    first_values=later("webapp.features.library.callbacks:first_values"),
    places=later("webapp.features.library.places:places"),
    keys=link_keys(names.View),
    routes=later("webapp.features.library.routes:blueprints"),
    stores=later("webapp.features.library.feature_files:stores"),
    commands={
        "import": Command(
            "Read recordings into a workspace.", later(f"{_ARGUMENTS}:import_"), later(f"{_COMMANDS}:import_")
        ),
        "labels": Command(
            "Add labels (CSV) to a dataset of a workspace.",
            later(f"{_ARGUMENTS}:labels"),
            later("webapp.features.library.label_commands:labels"),
        ),
        "properties": Command(
            "Set, show or write properties of clips: subject, condition, session, ...",
            later(f"{_ARGUMENTS}:properties"),
            later("webapp.features.library.property_commands:properties"),
        ),
        "inspect": Command(
            "Report for every file whether it can be read, and what is odd about it.",
            later(f"{_ARGUMENTS}:inspect"),
            later(f"{_COMMANDS}:inspect"),
        ),
        "reread": Command(
            "Change unit, way up, frame rate or bodies of a dataset without importing it again.",
            later(f"{_ARGUMENTS}:reread"),
            later("webapp.features.library.reading_commands:reread"),
        ),
        "body": Command(
            "Write which joint of each rig is which part of the body, to be corrected and given back with --body.",
            later(f"{_ARGUMENTS}:body"),
            later("webapp.features.library.reading_commands:body"),
        ),
        "demo": Command(
            "Write the demo dataset: labelled motion as BVH files.",
            later(f"{_ARGUMENTS}:demo"),
            later(f"{_COMMANDS}:demo"),
        ),
        "evaluate": Command(
            "Score motifs or actions against labels: MoF, Edit, F1@10/25/50, coverage, purity.",
            later(f"{_ARGUMENTS}:evaluate"),
            later("webapp.features.library.evaluation_commands:evaluate"),
        ),
        "export": Command(
            "Write features (npz, Parquet) or clips (BVH) for other tools.",
            later(f"{_ARGUMENTS}:export"),
            later("webapp.features.library.export_commands:export"),
        ),
    },
    blocks={
        "overview": Block(
            "Clips and facts",
            "library",
            later(f"{_BLOCKS}:overview"),
            segments=later(f"{_BLOCKS}:overview_segments"),
            size=(7, 6),
        ),
        "tracks": Block("Labels and motifs over time", "library", later(f"{_BLOCKS}:tracks"), "motifs", size=(12, 5)),
    },
    rights=rights.RIGHTS,
)
