"""What the routes of this page do to the workspace."""

from webapp.shell.rights import Rights

RIGHTS = Rights(
    package="webapp.features.groups",
    reads=("routes.groups_file", "routes.show_choices", "routes.show_comparison"),
    changes=("routes.start_comparison",),
)
