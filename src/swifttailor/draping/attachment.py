"""Which vertices are held up by a waistband or a strapless top, and at what height."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from swifttailor.arrays import Ints
from swifttailor.body import BodyMeasurements
from swifttailor.draping.placement import place_vertices
from swifttailor.panel_mesh.pattern_mesh import PatternMesh
from swifttailor.pattern.check import hangs_from_shoulders

LOW_RISE_CM = HIGH_RISE_CM = 2.0
"""Waistbands placed this far below or above the waist are worn there."""
_HIGHEST_CM = 6.0
"""Nothing is held up further above it, cm."""


@dataclass(frozen=True, eq=False)
class Attachment:
    """Vertices that may not slide below a level."""

    vertices: Ints
    """(k,) welded vertices."""
    levels: NDArray[np.float64]
    """(k,) height of each, cm; what has been sewn on lower is held there."""
    at_first: NDArray[np.bool_]
    """(k,) those that are let go once the garment hangs: necklines, which then rest on the shoulders."""


def find_attachment(mesh: PatternMesh, measurements: BodyMeasurements) -> Attachment:
    """Finds what holds a garment up that does not hang from the shoulders.

    A skirt or trousers are held at the waist by the edges labelled ``lower_interface``, or below or above it
    where they are placed there (low and high rises); files without labels by the topmost free edges. A
    strapless top is held by ``strapless_top``. A garment with a shoulder rests on it; only while it is put
    on, its neckline (``left_collar``, ``right_collar``) is kept from slipping down over the arms. Pulling
    its waist up would turn its bodice over.

    A strapless top is held where its panels stand, at most at the armpits: without friction, as it is sewn,
    a tight one slides off the bust. The armpit level itself would push it up into the arms.
    """
    pattern = mesh.pattern
    if hangs_from_shoulders(pattern):
        strapless, neck = _labelled(mesh, "strapless_top"), _labelled(mesh, "left_collar", "right_collar")
        held = np.concatenate([strapless, np.setdiff1d(neck, strapless)])
        at_first = np.arange(len(held)) >= len(strapless)
        highest = np.where(at_first, np.inf, measurements.armpit_level)
        return Attachment(held, np.minimum(place_vertices(mesh)[held, 1], highest), at_first)
    held = _labelled(mesh, "lower_interface")
    held = held if len(held) else _top_edges(mesh)
    return Attachment(held, _waist_levels(mesh, held, measurements), np.zeros(len(held), dtype=bool))


def _waist_levels(mesh: PatternMesh, held: Ints, measurements: BodyMeasurements) -> NDArray[np.float64]:
    """(k,) the waist, or where panels stand so much lower or higher that the pattern means it."""
    waist = measurements.waist_level
    placed = place_vertices(mesh)[held, 1]
    if len(held) and float(placed.mean()) > waist + HIGH_RISE_CM:
        return np.minimum(placed, waist + _HIGHEST_CM)
    low = len(held) > 0 and float(placed.mean()) < waist - LOW_RISE_CM
    return np.minimum(placed, waist) if low else np.full(len(held), waist)


def _labelled(mesh: PatternMesh, *labels: str) -> Ints:
    found = [
        mesh.edge_vertices[i][k]
        for i, panel in enumerate(mesh.pattern.panels)
        for k, edge in enumerate(panel.edges)
        if edge.label in labels
    ]
    return np.unique(mesh.weld[np.concatenate(found)]) if found else np.zeros(0, dtype=np.int32)


def _top_edges(mesh: PatternMesh) -> Ints:
    """Vertices of the free edges whose middle lies within 10 cm of the highest free edge's, as placed."""
    stitched = {ref for s in mesh.pattern.stitches for ref in s.sides}
    heights, runs = [], []
    for i, panel in enumerate(mesh.pattern.panels):
        for k in range(len(panel.edges)):
            if (panel.name, k) in stitched:
                continue
            run = mesh.edge_vertices[i][k]
            middle = mesh.flat_vertices[run].mean(axis=0, keepdims=True)
            heights.append(panel.to_world(middle)[0, 1])
            runs.append(run)
    if not runs:
        return np.zeros(0, dtype=np.int32)
    top = [r for r, h in zip(runs, heights, strict=True) if h > max(heights) - 10]
    return np.unique(mesh.weld[np.concatenate(top)])
