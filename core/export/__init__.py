"""What leaves Motionscape for other tools: features of a data set as npz or Parquet, clips as BVH."""

from core.export.features import (
    FeatureParameters,
    FeatureTable,
    feature_table,
    labelled,
    pack_features,
    unpack_features,
)
from core.export.files import write_features
from core.export.splits import motion_groups, split_groups

__all__ = [
    "FeatureParameters",
    "FeatureTable",
    "feature_table",
    "labelled",
    "motion_groups",
    "pack_features",
    "split_groups",
    "unpack_features",
    "write_features",
]
