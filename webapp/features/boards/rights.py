"""What the routes of this page do to the workspace."""

from webapp.shell.rights import Rights

RIGHTS = Rights(
    package="webapp.features.boards",
    reads=(
        "routes.board_group",
        "routes.board_history",
        "routes.list_boards",
        "routes.report_file",
        "routes.show_block",
        "routes.show_board",
        "routes.show_comments",
        "routes.show_report",
        "routes.view_history",
        "routes.view_picture",
    ),
    changes=("routes.change_view", "routes.make_board", "routes.save_view"),
    boards=("routes.change_board", "routes.change_comments", "routes.compute_block"),
)
