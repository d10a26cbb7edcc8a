"""Grammar: the actions of the recordings, what follows what, and new motion that keeps to it."""

from webapp.pages.grammar.callbacks import register
from webapp.pages.grammar.layout import page

__all__ = ["page", "register"]
