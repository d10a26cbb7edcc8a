"""The embedded data set: labelled routines that follow a small hidden grammar, made from recorded motions.

Where the recordings come from, and their licence: core/data/demo_motions.LICENSE.txt.
"""

from core.demo.dataset import make_demo, write_demo

__all__ = ["make_demo", "write_demo"]
