"""A spatial hash for the compiled loops: the bucket of a cell of space."""

from __future__ import annotations

from numba import njit


@njit(cache=True)
def hash_cell(i, j, k, mask):
    """Bucket of a lattice cell."""
    return ((i * 73856093) ^ (j * 19349663) ^ (k * 83492791)) & mask
