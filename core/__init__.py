"""Motionscape's analysis package: numpy arrays in, small frozen dataclasses out."""
