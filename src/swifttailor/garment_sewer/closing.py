"""Closes the seams of predicted panels and takes the cloth out of the body, smoothly.

The network leaves each pair of sewn edges a few millimetres apart. Averaging them would put the whole
correction on the boundary vertices, as a crease along the seam. Here the panels keep the shape that was
predicted, face by face, and one sparse least-squares problem finds the vertices, seams closed, whose faces
come nearest to it (gradient-domain decoding; Sorkine 2006, sec. 2): what a seam needs is spread over the
panels.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.sparse import csc_array, diags_array

from swifttailor.arrays import Floats
from swifttailor.garment_sewer.covering import cover_body
from swifttailor.garment_sewer.pixels.body_distance import BodyDistance
from swifttailor.garment_sewer.pixels.rest_shape import flat_gradients, limit_stretch, rest_shape
from swifttailor.garment_sewer.pixels.sewn_prior import factorized, vertices_ignoring_arms
from swifttailor.panel_mesh.edge_sampling import stitched_pairs
from swifttailor.panel_mesh.pattern_mesh import PatternMesh


@dataclass(frozen=True)
class ClosingSettings:
    """How seams are closed."""

    stay: float = 0.02
    """Weight per cm^2 with which a vertex stays where it was predicted, against one for its faces' shape:
    seams are felt about 1 / sqrt(stay) cm into the panels."""
    longest: float = 1.02
    """Faces that are predicted longer than this share of the flat cloth are shortened to it."""
    clearance: float = 0.3
    """Distance that vertices keep from the body, cm."""
    rounds: int = 4
    """Of pushing out of the body and finding the vertices again."""


def close_seams(
    mesh: PatternMesh,
    flat_positions: Floats,
    body: BodyDistance | None,
    settings: ClosingSettings | None = None,
) -> Floats:
    """Finds the garment that is nearest to predicted panels.

    Args:
        mesh: The panels' mesh.
        flat_positions: (m, 3) predicted position of each flat vertex, cm.
        body: Kept out of; None closes the seams alone.
        settings: How; the defaults when None.

    Returns:
        (v, 3) welded vertices, cm.
    """
    settings = settings or ClosingSettings()
    shape = rest_shape(mesh)
    back = shape.weighted
    stay = settings.stay * np.maximum(shape.vertex_area, 1e-2)
    solve = factorized(csc_array(back @ shape.gradient + diags_array(stay)))
    wanted = limit_stretch(flat_gradients(mesh, shape, flat_positions), settings.longest)
    pull = back @ wanted.reshape(-1, 3)
    target = mesh.welded_mean(flat_positions)
    vertices = solve(pull + stay[:, None] * target)
    if body is None:
        return vertices
    ignores = vertices_ignoring_arms(mesh)
    for _ in range(settings.rounds):
        pushed = body.push_out(vertices, ignores, settings.clearance)
        moved = pushed - vertices
        if not moved.any():
            return cover_body(mesh, vertices, body, ignores)
        # The faces around take the push as a wish as well, so that it reaches beyond the single vertex.
        target = target + moved
        vertices = solve(pull + back @ (shape.gradient @ moved) + stay[:, None] * target)
    vertices = body.push_out(vertices, ignores, settings.clearance, rounds=3)
    return cover_body(mesh, vertices, body, ignores)


def seam_gaps(mesh: PatternMesh, flat_positions: Floats) -> Floats:
    """(k,) distances between all pairs of flat vertices that a stitch joins, stitch after stitch."""
    pairs = [np.zeros((0, 2), np.int64)]
    for stitch in mesh.pattern.stitches:
        a, b = (mesh.edge_vertices[mesh.pattern.panel_index(r.panel)][r.edge] for r in stitch.sides)
        pairs.append(stitched_pairs(a.astype(np.int64), b.astype(np.int64), stitch.right_wrong))
    joined = np.concatenate(pairs)
    return np.linalg.norm(flat_positions[joined[:, 0]] - flat_positions[joined[:, 1]], axis=1)
