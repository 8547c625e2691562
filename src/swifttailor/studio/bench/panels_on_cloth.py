"""Where the panels of a garment were cut from its cloth, for clients that lay a print on them."""

from __future__ import annotations

import numpy as np

from swifttailor.arrays import Array
from swifttailor.panel_mesh.cloth_places import shifts_across
from swifttailor.panel_mesh.pattern_mesh import PatternMesh
from swifttailor.panel_mesh.uv_layout import cut_from_cloth


def panels_on_cloth(mesh: PatternMesh) -> list[list[float]]:
    """Six numbers of each panel, a to f: from u, v on it to a u + b v + c, d u + e v + f on the cloth.

    All places are in cm. Panels are mirrored, turned and moved, so that they lie as
    `garment.cloth_print.flat_places` has them.

    Args:
        mesh: Any.
    """
    panel, count = mesh.flat_panel, len(mesh.pattern.panels)
    flat, at = np.asarray(mesh.flat_vertices, np.float64), cut_from_cloth(mesh)
    at[:, 0] += shifts_across(mesh, at)[panel]
    corners = np.maximum(np.bincount(panel, minlength=count), 1)[:, None]
    middle, there = _sums(flat, panel, count) / corners, _sums(at, panel, count) / corners
    own, its = flat - middle[panel], at - there[panel]
    # The matrix that takes the one to the other, by least squares.
    spread = _sums(own[:, :, None] * own[:, None, :], panel, count)
    across = _sums(its[:, :, None] * own[:, None, :], panel, count)
    spread[np.abs(np.linalg.det(spread)) < 1e-9] = np.eye(2)  # of panels without an area, which show nothing
    turns = across @ np.linalg.inv(spread)
    shifts = there - np.einsum("pij,pj->pi", turns, middle)
    rows = np.concatenate([turns, shifts[:, :, None]], axis=2).reshape(count, 6)
    return (np.round(rows, 5) + 0.0).tolist()


def _sums(values: Array, panel: Array, count: int) -> Array:
    """(count, ...) the sum of the values (m, ...) of each panel."""
    flat = values.reshape(len(values), -1)
    sums = [np.bincount(panel, column, count) for column in flat.T]
    return np.stack(sums, axis=1).reshape(count, *values.shape[1:])
