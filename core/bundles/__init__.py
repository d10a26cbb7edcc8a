"""Bundles: a data set with its results, notes, saved views and boards as one zip that another workspace takes over.

``manifest.json`` lists every file with its SHA-256. A bundle of features only leaves the recordings out; it is taken
over where the same recordings are there already. What a bundle says of itself is not believed: names, sizes and hashes
are checked before anything is kept, nothing is written outside a temporary folder of the workspace, nothing is
unpickled.
"""

from core.bundles.taking import Taken, describe, take_bundle
from core.bundles.writing import write_bundle

__all__ = ["Taken", "describe", "take_bundle", "write_bundle"]
