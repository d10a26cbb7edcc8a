"""Map: see layout and callbacks."""

from webapp.pages.motion_map.callbacks import register
from webapp.pages.motion_map.layout import page

__all__ = ["page", "register"]
