"""Sweeps: see layout and callbacks."""

from webapp.pages.sweeps.callbacks import register
from webapp.pages.sweeps.layout import page

__all__ = ["page", "register"]
