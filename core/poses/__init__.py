"""A frame as numbers: pose features."""
