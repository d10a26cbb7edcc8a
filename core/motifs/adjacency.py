"""Which letters may stand for each other (MMG section 3.2): the paper's spheres, or one radius for all."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

KINDS = ("radius", "spheres")


class Adjacency(NamedTuple):
    """Distances between letters and which of them may stand for each other.

    distances: ``(kappa, kappa)`` float32 distance between cluster centres; costs: the same where two letters are
    adjacent, infinity where they are not; radius: largest distance of two adjacent centres.
    """

    distances: np.ndarray
    costs: np.ndarray
    radius: float


def centre_distances(centres: np.ndarray) -> np.ndarray:
    """Euclidean distances between centres ``(kappa, d)``: ``(kappa, kappa)`` float32, zero diagonal."""
    x = np.asarray(centres, np.float64)
    x = x - x.mean(0)
    squares = (x**2).sum(1)
    distances = np.sqrt(np.maximum(squares[:, None] + squares[None] - 2 * x @ x.T, 0)).astype(np.float32)
    np.fill_diagonal(distances, 0)
    symmetric: np.ndarray = np.minimum(distances, distances.T)
    return symmetric


def nearest_pairs_radius(centres: np.ndarray, share: float) -> float:
    """The distance below which ``share`` of all pairs of centres ``(kappa, d)`` lie; 0 for a single centre."""
    distances = centre_distances(centres)[np.triu_indices(len(centres), 1)]
    return float(np.quantile(distances, share)) if len(distances) else 0.0


def radius_adjacency(centres: np.ndarray, radius: float) -> Adjacency:
    """Letters are adjacent when their centres ``(kappa, d)`` are at most ``radius`` apart."""
    distances = centre_distances(centres)
    return _adjacency(distances, distances <= radius)


def sphere_adjacency(centres: np.ndarray, letters: np.ndarray, to_centre: np.ndarray) -> Adjacency:
    """The paper's: a sphere at each centre ``(kappa, d)`` reaches its furthest frame; adjacent when two intersect.

    letters, to_centre: ``(n,)`` letter of each frame and its distance from the centre of that letter.
    """
    radii = np.zeros(len(centres), np.float32)
    np.maximum.at(radii, letters, to_centre.astype(np.float32))
    distances = centre_distances(centres)
    return _adjacency(distances, distances <= radii[:, None] + radii[None])


def _adjacency(distances: np.ndarray, adjacent: np.ndarray) -> Adjacency:
    np.fill_diagonal(adjacent, True)
    costs = np.where(adjacent, distances, np.float32(np.inf))
    return Adjacency(distances, costs, float(distances[adjacent].max()))
