"""A first guess of the garment in space: its panels sewn together around the body, without physics.

As-rigid-as-possible iterations (Sorkine and Alexa 2007) on a coarse mesh whose seams are closed from the
start, against the flat panels as rest shape: turn every face's gradient into the nearest one without stretch,
solve for the vertices that have these gradients, move those inside the body out of it. Nothing falls: the
garment stays about where its panels were placed. It is smooth, hence a coarse mesh is enough.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csc_array, diags_array
from scipy.sparse.linalg import splu

from swifttailor.arrays import Floats
from swifttailor.draping.placement import place_vertices
from swifttailor.garment_sewer.pixels.body_distance import BodyDistance, panels_ignoring_arms
from swifttailor.garment_sewer.pixels.rest_shape import nearest_unstretched, rest_shape
from swifttailor.panel_mesh.pattern_mesh import PatternMesh


@dataclass(frozen=True)
class SewingSettings:
    """How the panels are sewn."""

    edge_length: float = 6.0
    """Of the coarse mesh, cm."""
    iterations: int = 60
    inertia: float = 0.002
    """Weight per cm^2 with which a vertex stays where it was, against one for its faces' gradients."""
    clearance: float = 0.4
    """Distance that vertices keep from the body, cm."""


def vertices_ignoring_arms(mesh: PatternMesh) -> NDArray[np.bool_]:
    """(v,) whether a welded vertex belongs to a panel over the legs."""
    ignores = np.zeros(mesh.vertex_count, np.bool_)
    np.logical_or.at(ignores, mesh.weld, panels_ignoring_arms(mesh.pattern)[mesh.flat_panel])
    return ignores


def factorized(matrix: csc_array) -> Callable[[Floats], Floats]:
    """Solves with a symmetric positive definite matrix (v, v) for right sides (v, k)."""
    options = {"SymmetricMode": True, "Equil": False}
    solver = splu(matrix, permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0, options=options)
    return solver.solve


def sew_around_body(mesh: PatternMesh, body: BodyDistance, settings: SewingSettings | None = None) -> Floats:
    """Sews the panels together around the body.

    Args:
        mesh: Of the pattern; coarse.
        body: Kept out of.
        settings: How; the defaults when None.

    Returns:
        (v, 3) welded vertices, cm. The vertices, not the faces between them, are clear of the body.
    """
    settings = settings or SewingSettings()
    shape = rest_shape(mesh)
    ignores = vertices_ignoring_arms(mesh)
    back = shape.weighted
    # A vertex without faces of any size keeps its place by a weight of its own.
    stay = settings.inertia * np.maximum(shape.vertex_area, 1e-2)
    solve = factorized(csc_array(back @ shape.gradient + diags_array(stay)))
    vertices = place_vertices(mesh)
    for _ in range(settings.iterations):
        target = body.push_out(vertices, ignores, settings.clearance)
        unstretched = nearest_unstretched(shape.gradients(vertices))
        vertices = solve(back @ unstretched.reshape(-1, 3) + stay[:, None] * target)
    return body.push_out(vertices, ignores, settings.clearance, rounds=2)
