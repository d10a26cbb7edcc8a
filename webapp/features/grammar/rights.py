"""What the routes and callbacks of this page do to the workspace."""

from webapp.shell.rights import Rights

RIGHTS = Rights(
    package="webapp.features.grammar",
    reads=(
        "actions_view.fill",
        "callbacks.gather",
        "callbacks.show_result",
        "compare_view.play",
        "compare_view.show",
        "compose_view.make",
        "compose_view.others",
        "routes.actions_csv",
        "routes.bakeoff",
        "routes.derivation",
        "routes.grammar_json",
        "routes.rules_csv",
        "routes.tree",
        "routines_view.draw",
        "tune_view.draw",
        "tune_view.fill",
        "tune_view.look",
        "tune_view.plan",
    ),
    asks=(
        "compare_view.ask",
        "tune_view.learn",
        "tune_view.run",
    ),
    changes=(
        "actions_view.save",
        "compose_view.keep",
    ),
)
