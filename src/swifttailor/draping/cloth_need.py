"""How much cloth a garment is made of, and what it weighs."""

from __future__ import annotations

from typing import Any

import numpy as np

from swifttailor.draping.fabric import Fabric
from swifttailor.panel_mesh.pattern_mesh import PatternMesh


def cloth_need(mesh: PatternMesh, fabric: Fabric) -> dict[str, Any]:
    """Area and weight of a garment's panels, for its report.

    Args:
        mesh: Of the garment.
        fabric: What it is made of.

    Returns:
        The fabric's name, kg/m^2 and whether that is measured, the panels' area in m^2 (flat, without seam
        allowances) and what they weigh in g.
    """
    corners = mesh.flat_vertices[mesh.flat_faces]
    a, b = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    area = float(np.abs(a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]).sum()) / 2 * 1e-4
    return {
        "fabric": fabric.name,
        "kg_m2": fabric.density,
        "measured": fabric.is_measured,
        "area_m2": round(area, 4),
        "mass_g": round(1000 * area * fabric.density, 1),
    }
