"""Cloth that the network predicts crumpled, and the folds of the coarse drape for it.

How the folds of a wide skirt fall is chance, and a network that is to be near all the drapes there might be
predicts their mean: cloth that is nowhere folded and everywhere shorter than it is. Where that is so, where
the garment lies is taken from the network and how it folds from the coarse drape that the network began from:
that is what it is relaxed from (`relaxing.py`).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.sparse import csc_array, diags_array

from swifttailor.arrays import Floats
from swifttailor.garment.garment import Garment
from swifttailor.garment_sewer.pixels.rest_shape import flat_gradients, rest_shape
from swifttailor.garment_sewer.pixels.sewn_prior import factorized
from swifttailor.panel_mesh.pattern_mesh import PatternMesh

SHORT = 0.7
"""A face is crumpled where it is shorter than this share of the flat cloth in some direction."""
CRUMPLED = 0.05
"""Share of crumpled cloth from which a garment is taken for crumpled (docs/garment-sewer.md)."""
REACH_CM = 7.0
"""What the network moves is smoothed over so many centimetres; what is finer is the coarse drape's."""


@dataclass(frozen=True, eq=False)
class CrumpledGarment(Garment):
    """A garment whose cloth came out crumpled."""

    folded: Floats | None = None
    """(v, 3) the same garment with the folds of the coarse drape, cm: what it is relaxed from."""


def crumpled_share(mesh: PatternMesh, flat_positions: Floats) -> float:
    """Share of the cloth, by area, that is shorter than `SHORT` in some direction.

    Args:
        mesh: The panels' mesh.
        flat_positions: (m, 3) position of each flat vertex, cm.

    Raises:
        GeometryError: The shape of the positions does not fit the mesh.
    """
    shape = rest_shape(mesh)
    first, second = np.moveaxis(flat_gradients(mesh, shape, flat_positions), 1, 0)
    a, b, c = (first * first).sum(1), (first * second).sum(1), (second * second).sum(1)
    # The smaller eigenvalue of [a b; b c] is the square of the smaller stretch.
    least = 0.5 * (a + c - np.hypot(a - c, 2 * b))
    return float(shape.area[least < SHORT**2].sum() / shape.area.sum())


def folded_like(mesh: PatternMesh, flat_positions: Floats, folded: Floats, reach: float = REACH_CM) -> Floats:
    """Where panels are predicted, with the folds of other positions of them.

    Args:
        mesh: The panels' mesh.
        flat_positions: (m, 3) predicted position of each flat vertex, cm.
        folded: (m, 3) the same of cloth that folds.
        reach: Folds narrower than this are those of `folded`, cm.

    Returns:
        (m, 3): `folded`, moved by what the prediction moves it, smoothed over `reach`.
    """
    shape = rest_shape(mesh)
    moved = mesh.welded_mean(flat_positions - folded)
    mass = np.maximum(shape.vertex_area, 1e-2)
    # One implicit step of the heat equation: it damps waves of length 2 pi reach to a half.
    smooth = factorized(csc_array(diags_array(mass) + reach**2 * (shape.weighted @ shape.gradient)))
    return np.asarray(folded + smooth(mass[:, None] * moved)[mesh.weld])
