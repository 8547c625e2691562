"""Where on its panel each vertex of a simulated garment lies.

Texture coordinates are the panels' own coordinates, moved, and divided by the width and the height of the
texture: u and v have different scales (older versions of GarmentCode had others again). The scales are the
same for all panels, so they follow from comparing the islands with the panels of the pattern.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import product

import numpy as np
from scipy.spatial import KDTree

from swifttailor.arrays import Floats, Ints
from swifttailor.data.garmentcodedata.split_mesh import SplitMesh
from swifttailor.errors import InputError
from swifttailor.pattern import Panel, Pattern

_OUTLINE_POINTS = 65
"""Of each edge, for the extent of a panel."""
_FIT_CM, _FIT_SHARE = 0.25, 0.01
"""By how much a corner of a panel may be away from the nearest vertex: cm, and share of the panel's size."""
_LARGE = 0.3
"""Share of the largest panel's size from which on a panel says something about the scale."""
_NO_BETTER_CM = 1e-6


@dataclass(frozen=True, eq=False)
class PanelCoordinates:
    """The vertices of a simulated garment on the panels of its pattern."""

    panel: Ints
    """(n,) panel index in the pattern."""
    local: Floats
    """(n, 2) panel-local cm."""
    scale: tuple[float, float]
    """Centimetres per unit of u and of v."""


def locate(
    mesh: SplitMesh, segmentation: list[str], pattern: Pattern, panel_order: list[str]
) -> PanelCoordinates:
    """Finds the panel of each vertex and its place there.

    Args:
        mesh: The simulated garment.
        segmentation: From `read_segmentation`; used where it fits the mesh.
        pattern: Its pattern.
        panel_order: Names of the panels in the order in which GarmentCode meshed them.

    Raises:
        InputError: Mesh and pattern do not belong together.
    """
    names = _island_names(mesh, segmentation, pattern, panel_order)
    index = np.array([pattern.panel_index(name) for name in names])
    low, high = _extents(mesh.uv, mesh.island, len(names))
    outlines = [_outline_extent(pattern.panels[k]) for k in index]
    size = np.array([b - a for a, b in outlines])
    spread = high - low
    if (spread <= 0).any():
        raise InputError("The texture coordinates of a panel have no extent; the mesh is damaged.")
    scale = _scale(size, spread)
    local = np.zeros_like(mesh.uv)
    for k, (start, end) in enumerate(outlines):
        own = mesh.island == k
        panel = pattern.panels[index[k]]
        points = (mesh.uv[own] - low[k]) * scale
        shift, misfit = _shift(panel.vertices, points, start, end)
        if misfit > _FIT_CM + _FIT_SHARE * float(size[k].max()):
            raise InputError(
                f"The mesh does not fit the pattern: a corner of the panel '{panel.name}' is {misfit:.1f} cm "
                "from the nearest vertex. Do both files belong to one garment?"
            )
        local[own] = points + shift
    return PanelCoordinates(index[mesh.island].astype(np.int32), local, (float(scale[0]), float(scale[1])))


def _scale(size: Floats, spread: Floats) -> Floats:
    """Centimetres per unit of u and v (2,), from the sizes (p, 2) of panels and of their islands.

    A mesh may cut off the outermost point of a curve, so that its island is too small and the quotient too
    large; of the larger panels the smallest quotient is that of a panel whose corners lie outermost.
    """
    quotient = size / spread
    return np.where(size >= _LARGE * size.max(axis=0), quotient, np.inf).min(axis=0)


def _shift(corners: Floats, points: Floats, start: Floats, end: Floats) -> tuple[Floats, float]:
    """How far an island's points (n, 2), lowest at 0, are from their place, and the worst corner's distance.

    Where the island is smaller than its panel, either of its sides may be the one that was cut off. The
    corners of the panel, which are vertices of every mesh, tell which.
    """
    slack = (end - start) - points.max(axis=0)
    tree = KDTree(points)
    best, shift = np.inf, start
    for part in product((0.0, 0.5, 1.0), repeat=2):
        tried = start + np.array(part) * slack
        distance = float(np.max(tree.query(corners - tried)[0]))
        if distance < best - _NO_BETTER_CM:
            best, shift = distance, tried
    return shift, best


def _island_names(
    mesh: SplitMesh, segmentation: list[str], pattern: Pattern, panel_order: list[str]
) -> list[str]:
    """The panel of each island: by the segmentation, or by their order where that has other vertices."""
    islands = int(mesh.island.max()) + 1
    if islands != len(pattern.panels):
        raise InputError(
            f"The mesh has {islands} pieces and the pattern {len(pattern.panels)} panels. "
            "Do both files belong to one garment?"
        )
    if len(segmentation) != int(mesh.weld.max()) + 1:
        return panel_order
    names: list[str] = []
    for k in range(islands):
        welded = np.unique(mesh.weld[mesh.island == k])
        found = {segmentation[v] for v in welded} - {""}
        if len(found) > 1:
            raise InputError(
                f"The segmentation names several panels for one piece of cloth: {sorted(found)}."
            )
        names.append(found.pop() if found else "")
    missing = [n for n in panel_order if n not in names]
    names = [
        n or (missing.pop(0) if names.count("") == len(missing) == 1 else panel_order[k])
        for k, n in enumerate(names)
    ]
    if sorted(names) != sorted(panel_order):
        raise InputError(
            f"The segmentation names the panels {sorted(set(names))}, the pattern has {panel_order}."
        )
    return names


def _extents(points: Floats, group: Ints, count: int) -> tuple[Floats, Floats]:
    low, high = np.full((count, 2), np.inf), np.full((count, 2), -np.inf)
    np.minimum.at(low, group, points)
    np.maximum.at(high, group, points)
    return low, high


def _outline_extent(panel: Panel) -> tuple[Floats, Floats]:
    points = np.concatenate([panel.sample_edge(k, _OUTLINE_POINTS) for k in range(len(panel.edges))])
    return points.min(axis=0), points.max(axis=0)
