"""Edges of collars, which are drawn stronger than hems, and the seams within them, which nobody looks for."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from swifttailor.arrays import Array

if TYPE_CHECKING:
    from swifttailor.garment.garment import Garment
    from swifttailor.pattern.pattern import Pattern

_COLLAR = "collar"
"""What the names of all panels of collars and lapels hold."""


def seams_within_collars(pattern: Pattern) -> frozenset[int]:
    """Indices of the stitches that join panels of collars: folds, and where quarters meet on the shoulders.

    A collar is cut in one piece, as a rule; lines across it would make a shawl collar look notched.
    """
    return frozenset(
        k for k, stitch in enumerate(pattern.stitches) if all(_COLLAR in side.panel for side in stitch.sides)
    )


def is_of_collar(garment: Garment) -> Array:
    """(v,) bool: the vertices of collars and lapels; none where the garment has no such panels."""
    of_panel = np.array([_COLLAR in panel.name for panel in garment.pattern.panels], bool)
    found = np.zeros(len(garment.vertices), bool)
    found[garment.faces[of_panel[garment.mesh.face_panel]]] = True
    return found
