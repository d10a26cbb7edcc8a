"""Algorithms on any sequence: warping and repeats."""
