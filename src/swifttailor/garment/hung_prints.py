"""Prints that go once over a garment as it is worn, from its hem to its top: a colour that fades."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from swifttailor.arrays import Array

if TYPE_CHECKING:
    from swifttailor.garment.garment import Garment

HUNG = frozenset({"ombre", "blocks", "two_blocks", "four_blocks"})
"""Motifs whose lower half, mirrored in the upper one, is the whole garment from below."""


def is_hung(garment: Garment) -> bool:
    """Whether a garment has such a print."""
    printed = garment.print
    return printed is not None and printed.kind == "motif" and printed.motif in HUNG


def worn_heights(garment: Garment) -> Array:
    """(m,) how high on the print the flat vertices lie, cm: 0 at the lowest, half a repeat at the highest.

    Args:
        garment: With a hung print.
    """
    assert garment.print is not None
    height = garment.flat_positions[:, 1].astype(np.float64)
    low, high = height.min(), height.max()
    return (height - low) / max(high - low, 1e-6) * garment.print.size("repeat") / 2


def height_planes(garment: Garment) -> Array:
    """(n, 3) of each panel a, b, c: at u, v of the texture a print lies a u + b v + c high, cm.

    That is as near as a plane comes to `worn_heights`, for pictures of whole panels.
    """
    height, panel = worn_heights(garment), garment.mesh.flat_panel
    planes = np.zeros((len(garment.pattern.panels), 3))
    for k in np.unique(panel):
        own = panel == k
        at = np.column_stack([garment.uv[own], np.ones(own.sum())])
        planes[k] = np.linalg.lstsq(at, height[own], rcond=None)[0]
    return planes
