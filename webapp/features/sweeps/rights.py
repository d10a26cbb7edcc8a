"""What the routes and callbacks of this page do to the workspace."""

from webapp.shell.rights import Rights

RIGHTS = Rights(
    package="webapp.features.sweeps",
    reads=(
        "callbacks.choices",
        "callbacks.draw",
        "callbacks.draw_heat",
        "callbacks.look",
        "callbacks.tell",
        "form.fill",
        "form.plan",
        "form.show_base",
    ),
    asks=("form.run",),
)
