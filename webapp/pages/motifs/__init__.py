"""Motifs: parameters, the motif graph, the motif table, metrics."""

from webapp.pages.motifs.callbacks import register
from webapp.pages.motifs.layout import page

__all__ = ["page", "register"]
