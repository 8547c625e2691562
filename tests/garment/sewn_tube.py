"""A garment small enough to reason about: a tube of two panels, the back one wound clockwise, with a dart."""

from __future__ import annotations

import numpy as np

from swifttailor.garment.garment import Garment
from swifttailor.panel_mesh import mesh_pattern
from swifttailor.pattern import Arc, Cubic, Edge, EdgeRef, Line, Panel, Pattern, Placement, Quadratic, Stitch

RADIUS = 17.0


def tube_pattern(front: str = "front", back: str = "back") -> Pattern:
    """Two rectangles, 50 x 60 cm, stitched at both sides; the front has a dart in its hem."""
    front_panel = Panel(
        front,
        np.array([[-25.0, 0], [-2, 0], [0, 12], [2, 0], [25, 0], [25, 60], [-25, 60]]),
        (
            Edge(),
            Edge(),
            Edge(),
            Edge(),
            Edge(Line(), "side"),
            Edge(Quadratic((0.5, 0.12))),
            Edge(Line()),
        ),
        Placement((0.0, 80.0, 20.0)),
        "body",
    )
    back_panel = Panel(
        back,
        np.array([[-25.0, 0], [-25, 60], [25, 60], [25, 0]]),
        (Edge(), Edge(Cubic((0.3, -0.05), (0.7, -0.05))), Edge(), Edge(Arc(60.0, False, False))),
        Placement((0.0, 80.0, -20.0)),
        "body",
    )
    stitches = (
        Stitch(EdgeRef(front, 4), EdgeRef(back, 2)),
        Stitch(EdgeRef(front, 6), EdgeRef(back, 0)),
        Stitch(EdgeRef(front, 1), EdgeRef(front, 2)),
    )
    return Pattern((front_panel, back_panel), stitches, "tube")


def tube_garment(edge_length: float = 3.0, **names: str) -> Garment:
    """The tube around the Y axis, with wrinkles; every welded vertex where its flat ones agree."""
    mesh = mesh_pattern(tube_pattern(**names), edge_length)
    x, y = mesh.flat_vertices.T
    angle = np.clip(x / 25.0, -1, 1) * np.pi / 2
    radius = RADIUS + 0.6 * np.cos(8 * angle) + 0.3 * np.sin(y / 3)
    side = np.where(mesh.flat_panel == 0, 1.0, -1.0)
    flat = np.stack([radius * np.sin(angle), y + 80.0, side * radius * np.cos(angle)], axis=1)
    vertices = np.zeros((mesh.vertex_count, 3))
    np.add.at(vertices, mesh.weld, flat)
    vertices /= np.bincount(mesh.weld, minlength=mesh.vertex_count)[:, None]
    return Garment(mesh, vertices, {"engine": "by hand", "seconds": 0.5})


def edge_counts(faces: np.ndarray) -> np.ndarray:
    """How many faces have each edge of a mesh (m, 3)."""
    edges = np.sort(faces[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    return np.unique(edges, axis=0, return_counts=True)[1]


def component_count(faces: np.ndarray) -> int:
    """Connected components of the used vertices of a mesh (m, 3)."""
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import connected_components

    used, index = np.unique(faces, return_inverse=True)
    index = index.reshape(-1, 3)
    rows, columns = index[:, [0, 1]].ravel(), index[:, [1, 2]].ravel()
    graph = coo_array((np.ones(len(rows)), (rows, columns)), shape=(len(used), len(used)))
    return int(connected_components(graph, directed=False)[0])
