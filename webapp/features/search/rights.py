"""What the routes and callbacks of this page do to the workspace."""

from webapp.shell.rights import Rights

RIGHTS = Rights(
    package="webapp.features.search",
    reads=(
        "callbacks.list_clips",
        "callbacks.list_motifs",
        "callbacks.search",
        "callbacks.show_menus",
        "evaluation.choose_measure",
        "evaluation.show",
        "routes.explain",
        "routes.hits_csv",
        "routes.hits_json",
        "routes.ranking_json",
        "routes.ratings_csv",
        "routes.votes_csv",
        "storage.show",
        "study.gather",
        "study.show_results",
        "words_view.ask",
        "words_view.find",
    ),
    asks=(
        "callbacks.took",
        "study.grant",
    ),
    changes=(
        "callbacks.read",
        "study.keep",
    ),
)
