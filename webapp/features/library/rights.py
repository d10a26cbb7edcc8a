"""What the routes and callbacks of this page do to the workspace."""

from webapp.shell.rights import Rights

RIGHTS = Rights(
    package="webapp.features.library",
    reads=(
        "adding.name_upload",
        "adding.open_dialog",
        "adding.show_choices",
        "body_editor.open_editor",
        "body_editor.show_posture",
        "body_editor.take_file",
        "callbacks.show_cards",
        "callbacks.show_chosen",
        "callbacks.show_detail",
        "callbacks.show_trash",
        "property_routes.properties_file",
        "property_routes.show_properties",
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
        "body_editor.save_bodies",
        "callbacks.act",
        "callbacks.act_on_clips",
        "callbacks.rename",
        "property_routes.change_properties",
        "reading.read_again",
    ),
)
