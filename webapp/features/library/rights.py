"""What the routes and callbacks of this page do to the workspace."""

from webapp.shell.rights import Rights

RIGHTS = Rights(
    package="webapp.features.library",
    reads=(
        "adding.name_upload",
        "adding.open_dialog",
        "adding.show_choices",
        "callbacks.show_cards",
        "callbacks.show_chosen",
        "callbacks.show_detail",
        "callbacks.show_trash",
        "reading.open_dialog",
        "routes.bvh",
        "routes.features",
    ),
    asks=(
        "callbacks.open_demo",
        "feature_files.deliver",
    ),
    changes=(
        "adding.add_upload",
        "callbacks.act",
        "callbacks.act_on_clips",
        "callbacks.rename",
        "reading.read_again",
    ),
)
