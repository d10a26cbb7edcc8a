"""What the routes and callbacks of this page do to the workspace."""

from webapp.shell.rights import Rights

RIGHTS = Rights(
    package="webapp.features.clip",
    reads=(
        "callbacks.choose",
        "callbacks.draw",
        "callbacks.ends",
        "callbacks.find_clips",
        "callbacks.mark_path",
        "callbacks.show_controls",
        "callbacks.show_facts",
        "callbacks.show_range",
        "editing.open_dialog",
        "editing.say_effect",
        "routes.clip_table",
        "routes.clip_values",
        "table.open_dialog",
        "table.update",
    ),
    changes=("doctor.repair", "editing.do"),
)
