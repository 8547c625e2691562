"""Wide sleeves that are crumpled are laid around the arms; others stay."""

from __future__ import annotations

import numpy as np
import pytest

from swifttailor import draft
from swifttailor.body import Body
from swifttailor.body.parts import BodyPart
from swifttailor.garment_sewer.sleeves_laid import sleeves_laid
from swifttailor.panel_mesh import mesh_pattern
from swifttailor.panel_mesh.pattern_mesh import PatternMesh

BODY = Body.default()


def crumpled(mesh: PatternMesh) -> np.ndarray:
    """Placed flat, and the sleeves drawn up to half their length."""
    places = np.zeros((len(mesh.flat_vertices), 3))
    for k, panel in enumerate(mesh.pattern.panels):
        own = mesh.flat_panel == k
        flat = mesh.flat_vertices[own].copy()
        if "sleeve" in panel.name:
            flat[:, 0] *= 0.5
        places[own] = panel.placement.apply(flat)
    return mesh.welded_mean(places)


def goes_around(mesh: PatternMesh, vertices: np.ndarray, side: str) -> bool:
    """Whether the end of a sleeve lies on all sides of the arm."""
    arm = BODY.vertices[BODY.vertex_part == (BodyPart.LEFT_ARM if side == "left" else BodyPart.RIGHT_ARM)]
    along = np.linalg.svd(arm - arm.mean(axis=0), full_matrices=False)[2][0]
    panels = [k for k, panel in enumerate(mesh.pattern.panels) if panel.name.startswith(f"{side}_sleeve")]
    own = np.unique(mesh.weld[np.isin(mesh.flat_panel, panels)])
    out = np.abs(vertices[own, 0])
    end = vertices[own[out > out.max() - 8.0]]
    near = np.abs((arm - end.mean(axis=0)) @ along) < 4.0
    off = end - arm[near].mean(axis=0)
    return bool(off[:, 2].min() < -1.0 < 1.0 < off[:, 2].max() and off[:, 1].min() < -6.0)


def test_crumpled_wide_sleeves_go_around_the_arms():
    mesh = mesh_pattern(draft("robe"), 4.0)
    before = crumpled(mesh)
    laid = sleeves_laid(mesh, before, BODY)
    assert laid is not None
    assert all(goes_around(mesh, laid, side) for side in ("left", "right"))
    sleeves = [k for k, panel in enumerate(mesh.pattern.panels) if "sleeve" in panel.name]
    others = np.unique(mesh.weld[~np.isin(mesh.flat_panel, sleeves)])
    np.testing.assert_allclose(laid[others], before[others])


@pytest.mark.parametrize("name", ["shirt", "t-shirt", "tank-top", "circle-skirt"])
def test_close_sleeves_and_those_with_cuffs_stay(name):
    mesh = mesh_pattern(draft(name), 4.0)
    assert sleeves_laid(mesh, crumpled(mesh), BODY) is None
