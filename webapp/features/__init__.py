"""The features of the app, one folder each: a page with its figures, routes, commands and what its selections play.

To add one, write its folder (see ``webapp/shell/feature.py``) and put its name into this list.
"""

from importlib import import_module

from webapp.shell.feature import register

# as in the navigation
NAMES = ("library", "motifs", "sweeps", "motion_map", "search", "grammar", "groups", "clip", "boards")

for _name in NAMES:
    register(import_module(f"{__name__}.{_name}").FEATURE)
