"""Where across the cloth panels are cut: halves that need no seam between them as one, by their middles."""

from __future__ import annotations

import numpy as np

from swifttailor.arrays import Array
from swifttailor.panel_mesh.pattern_mesh import PatternMesh
from swifttailor.pattern.centre_seams import needless_centre_seams


def shifts_across(mesh: PatternMesh, points: Array) -> Array:
    """How far each panel moves across the cloth, so that prints go on over the middle of front and back.

    Halves that are sewn there lie as if cut on the fold, and what is cut in one has its middle at 0.

    Args:
        mesh: Any.
        points: (m, 2) flat vertices, cm from the lower left corner of their panels, as of
            `uv_layout.cut_from_cloth`.

    Returns:
        (n,) cm to the right.
    """
    panel, count = mesh.flat_panel, len(mesh.pattern.panels)
    low, high = np.full(count, np.inf), np.full(count, -np.inf)
    np.minimum.at(low, panel, points[:, 0])
    np.maximum.at(high, panel, points[:, 0])
    low[~np.isfinite(low)] = high[~np.isfinite(high)] = 0.0
    shift = -(low + high) / 2
    number = {one.name: k for k, one in enumerate(mesh.pattern.panels)}
    needless = needless_centre_seams(mesh.pattern)
    for seam in mesh.seams:
        if seam.stitch not in needless or not len(seam.vertices):
            continue
        a, b = (number[side.panel] for side in mesh.pattern.stitches[seam.stitch].sides)
        ends = np.isin(mesh.weld, seam.vertices)
        edge_a, edge_b = (float(points[ends & (panel == k), 0].mean()) for k in (a, b))
        # The seam itself is the middle of both.
        shift[a], shift[b] = -edge_a, -edge_b
    return shift
