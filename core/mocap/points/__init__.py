"""Recordings of points: positions of joints or markers, without a skeleton and without rotations."""
