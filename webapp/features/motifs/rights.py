"""What the routes and callbacks of this page do to the workspace."""

from webapp.shell.rights import Rights

RIGHTS = Rights(
    package="webapp.features.motifs",
    reads=(
        "blend_side.gather",
        "callbacks.draw_part",
        "callbacks.restyle",
        "callbacks.show_result",
        "callbacks.show_selection",
        "callbacks.show_table",
        "compare_view.choose",
        "compare_view.list_rows",
        "compare_view.offer",
        "compare_view.play",
        "compare_view.show_result",
        "compare_view.show_status",
        "compression_view.choose",
        "compression_view.list_motions",
        "compression_view.play",
        "compression_view.show",
        "notes_side.collect",
        "notes_side.fill",
        "notes_side.rows",
        "on_demand.show",
        "routes.motifs_csv",
        "routes.motifs_json",
        "routes.motifs_svg",
        "routes.stability_json",
        "routes.timeline_drawing",
        "routes.walk_json",
        "stability_marks.follow",
        "timeline_view.gather",
        "walk_side.make",
    ),
    asks=(
        "compare_view.compute",
        "on_demand.ask",
        "stability_marks.ask",
    ),
    changes=("notes_side.save",),
)
