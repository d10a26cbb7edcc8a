"""What the routes and callbacks of this page do to the workspace."""

from webapp.shell.rights import Rights

RIGHTS = Rights(
    package="webapp.features.library",
    reads=(
        "adding.name_upload",
        "adding.open_dialog",
        "adding.show_choices",
        "body_editor.show_posture",
        "body_editor.take_file",
        "callbacks.show_cards",
        "callbacks.show_chosen",
        "callbacks.show_detail",
        "callbacks.show_facts",
        "callbacks.show_trash",
        "dialogs.open_dialog",
        "long_lists.rows_of_clips",
        "long_lists.rows_of_files",
        "property_routes.properties_file",
        "property_routes.show_properties",
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
        "dialogs.start",
        "property_routes.change_properties",
    ),
)
