"""The body as the solver sees it: distance fields and which vertices may touch which parts."""

from __future__ import annotations

import numpy as np

from swifttailor.body import Body, DistanceField
from swifttailor.body.parts import ARMS
from swifttailor.draping.loop_arguments import FieldArrays
from swifttailor.panel_mesh.pattern_mesh import PatternMesh
from swifttailor.pattern.check import panel_regions

FIELD_SPACING_CM = 1.0


def vertices_ignoring_arms(mesh: PatternMesh) -> np.ndarray:
    """(v,) uint8, 1 for vertices of panels that cover the legs.

    Wide skirts start out around the hands of a body in A-pose; GarmentCode lets such panels pass through
    the arms too.
    """
    on_leg = np.array([r == "leg" for r in panel_regions(mesh.pattern).values()], dtype=np.uint8)
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
    return join_fields(full, armless, ignores)


def join_fields(full: DistanceField, armless: DistanceField, ignores_arms: np.ndarray) -> FieldArrays:
    """Two fields on the lattice of the first.

    Args:
        full: Of the whole body.
        armless: Without the arms: on a part of the same lattice.
        ignores_arms: (v,) 1 for vertices that feel the second.
    """
    return FieldArrays(
        np.ascontiguousarray(full.values, dtype=np.float32),
        np.ascontiguousarray(_on_lattice(armless, full).values, dtype=np.float32),
        np.ascontiguousarray(full.origin, dtype=np.float64),
        float(full.spacing),
        np.ascontiguousarray(ignores_arms, dtype=np.uint8),
    )


def _on_lattice(field: DistanceField, lattice: DistanceField) -> DistanceField:
    """`field` on the nodes of `lattice`; both have nodes at whole multiples of the same spacing.

    Nodes beyond the field get the value at its border, which is less than their distance: enough for the
    solver, which wants to know how far at least a vertex may go unwatched.
    """
    before = np.rint((field.origin - lattice.origin) / lattice.spacing).astype(np.int64)
    after = np.array(lattice.values.shape) - np.array(field.values.shape) - before
    if not (before.any() or after.any()):
        return field
    first, last = np.maximum(-before, 0), np.array(field.values.shape) - np.maximum(-after, 0)
    inner = field.values[first[0] : last[0], first[1] : last[1], first[2] : last[2]]
    width = np.stack([np.maximum(before, 0), np.maximum(after, 0)], axis=1)
    return DistanceField(np.pad(inner, width, mode="edge"), lattice.origin, lattice.spacing)


def faces_without_arms(body: Body) -> np.ndarray:
    """(m, 3) faces of the body that have no vertex on an arm."""
    on_arm = np.isin(body.vertex_part, [int(p) for p in ARMS])
    return body.faces[~on_arm[body.faces].any(axis=1)]
