"""Clip: see layout and callbacks."""

from webapp.pages.clip.callbacks import register
from webapp.pages.clip.layout import page

__all__ = ["page", "register"]
