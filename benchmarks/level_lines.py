"""Where a level of the body runs across cloth, folds left out.

A fold that hangs lifts and lowers the cloth on its way around the body. The line of one height then zigzags
across the flat panel and is longer than the panel is wide there, by what depends on how the folds happened to
fall. A cutter measures straight across. So heights are evened out within each panel before the line is drawn.
"""

from __future__ import annotations

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.panel_mesh.pattern_mesh import PatternMesh
from swifttailor.refitting.growing import PanelSheet

FOLD_CM = 8.0
"""Over about so much cloth heights are evened out: the width of a fold."""


def without_folds(mesh: PatternMesh, heights: Floats) -> Floats:
    """Heights (m,) of the flat vertices, evened out over each panel.

    A slope across the whole panel stays, as does a curve longer than a fold: the level of a flared skirt is
    an arc.

    Args:
        mesh: Of the garment.
        heights: (m,) of the flat vertices, cm.
    """
    result = np.array(heights, np.float64)
    for number in range(len(mesh.pattern.panels)):
        own = np.flatnonzero(mesh.flat_panel == number)
        faces = np.searchsorted(own, mesh.flat_faces[mesh.face_panel == number])
        sheet = PanelSheet(mesh.flat_vertices[own], faces)
        weight = np.sqrt(sheet.mass)[:, None]
        plane = np.column_stack([sheet.vertices, np.ones(len(own))])
        slopes, *_ = np.linalg.lstsq(weight * plane, weight[:, 0] * heights[own], rcond=None)
        tilted = plane @ slopes
        result[own] = tilted + sheet.smoothed((heights[own] - tilted)[:, None], FOLD_CM)[:, 0]
    return result
