"""Library: datasets, clips, the import report, uploads."""

from webapp.pages.library.callbacks import register
from webapp.pages.library.layout import page

__all__ = ["page", "register"]
