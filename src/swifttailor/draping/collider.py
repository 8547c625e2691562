"""The body as the solver sees it: distance fields and which vertices may touch which parts."""

from __future__ import annotations

import numpy as np

from swifttailor.body import Body, BodyPart, DistanceField
from swifttailor.draping.xpbd_kernels import FieldArrays
from swifttailor.garment import PatternMesh
from swifttailor.pattern import body_region

FIELD_SPACING_CM = 1.0
ARMS = frozenset({BodyPart.LEFT_ARM, BodyPart.RIGHT_ARM})


def vertices_ignoring_arms(mesh: PatternMesh) -> np.ndarray:
    """(v,) uint8, 1 for vertices of panels that cover the legs.

    Wide skirts start out around the hands of a body in A-pose; GarmentCode lets such panels pass through
    the arms too.
    """
    on_leg = np.array([body_region(p.name, p.label) == "leg" for p in mesh.pattern.panels], dtype=np.uint8)
    ignores = np.zeros(mesh.vertex_count, dtype=np.uint8)
    np.maximum.at(ignores, mesh.weld, on_leg[mesh.flat_panel])
    return ignores


def build_field_arrays(body: Body, mesh: PatternMesh) -> FieldArrays:
    """Gets the body's distance fields (cached between runs) on one common lattice."""
    full = body.distance_field(spacing=FIELD_SPACING_CM, covering=True)
    ignores = vertices_ignoring_arms(mesh)
    armless = full
    if ignores.any():
        armless = body.distance_field(spacing=FIELD_SPACING_CM, without=ARMS, covering=True)
        armless = _on_lattice(armless, full)
    return FieldArrays(
        np.ascontiguousarray(full.values, dtype=np.float32),
        np.ascontiguousarray(armless.values, dtype=np.float32),
        np.ascontiguousarray(full.origin, dtype=np.float64),
        float(full.spacing),
        ignores,
    )


def _on_lattice(field: DistanceField, lattice: DistanceField) -> DistanceField:
    """`field` on the nodes of `lattice`; both have nodes at whole multiples of the same spacing."""
    if field.values.shape == lattice.values.shape and np.allclose(field.origin, lattice.origin):
        return field
    axes = [lattice.origin[k] + lattice.spacing * np.arange(lattice.values.shape[k]) for k in range(3)]
    nodes = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1).reshape(-1, 3)
    values = field.sample(nodes)[0].reshape(lattice.values.shape).astype(np.float32)
    return DistanceField(values, lattice.origin, lattice.spacing)


def faces_without_arms(body: Body) -> np.ndarray:
    """(m, 3) faces of the body that have no vertex on an arm."""
    on_arm = np.isin(body.vertex_part, [int(p) for p in ARMS])
    return body.faces[~on_arm[body.faces].any(axis=1)]
