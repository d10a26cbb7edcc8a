"""What the routes and callbacks of this page do to the workspace."""

from webapp.shell.rights import Rights

RIGHTS = Rights(
    package="webapp.features.motion_map",
    reads=(
        "callbacks.clips",
        "callbacks.draw",
        "callbacks.light",
        "callbacks.multiples",
        "callbacks.region",
        "callbacks.show",
        "routes.document",
        "routes.drawn",
        "routes.map_paths",
        "routes.node",
        "routes.nodes",
        "routes.whole",
    ),
    asks=("callbacks.extend",),
)
