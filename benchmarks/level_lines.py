"""Where a level of the body runs across cloth, folds and armholes left out.

A fold that hangs lifts and lowers the cloth on its way around the body. The line of one height then zigzags
across the flat panel and is longer than the panel is wide there, by what depends on how the folds happened to
fall. A cutter measures straight across. So heights are evened out within each panel before the line is
drawn.

Armholes reach down to about the bust points. A line at that level runs through some of them, and a garment
that hangs a centimetre lower loses many centimetres of width there. A tailor measures the chest an inch
below.
"""

from __future__ import annotations

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.body import BodyMeasurements
from swifttailor.describing.measuring.anatomy import Anatomy, Border
from swifttailor.describing.measuring.parts import ARM_PARTS
from swifttailor.panel_mesh.pattern_mesh import PatternMesh
from swifttailor.refitting.growing import PanelSheet

FOLD_CM = 8.0
"""Over about so much cloth heights are evened out: the width of a fold."""
BELOW_ARMHOLE_CM = 2.5
"""A tailor measures the chest so far below the armholes."""


def chest_line(mesh: PatternMesh, heights: Floats, body: BodyMeasurements) -> float:
    """Height at which a garment's chest is measured: the bust level, or below the armholes if these are low.

    Args:
        mesh: Of the garment.
        heights: (m,) of the flat vertices, cm.
        body: Who wears it.
    """
    anatomy = Anatomy.of(mesh.pattern, body)
    number = {panel.name: k for k, panel in enumerate(mesh.pattern.panels)}
    edges = [
        r for loop in anatomy.loops(Border.ARM) for r in loop.edges if anatomy.part_of(r) not in ARM_PARTS
    ]
    edges += [
        a
        for stitch in anatomy.cloth.stitches
        for a, b in (stitch.sides, stitch.sides[::-1])
        if anatomy.part_of(a) not in ARM_PARTS and anatomy.part_of(b) in ARM_PARTS
    ]
    lowest = [heights[mesh.edge_vertices[number[r.panel]][r.edge]].min() for r in edges]
    return min([body.bust_level, *(float(low) - BELOW_ARMHOLE_CM for low in lowest)])


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
