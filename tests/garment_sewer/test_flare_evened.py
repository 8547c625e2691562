"""Flared coats and dresses are at least as wide as they are deep; others stay."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest

from swifttailor import draft
from swifttailor.body import Body
from swifttailor.draping.placement import place_vertices
from swifttailor.garment_sewer.flare_evened import flare_evened
from swifttailor.panel_mesh import mesh_pattern

BODY = Body.default()


def hung(name: str, wide: float, deep: float, **options) -> SimpleNamespace:
    """A garment whose panels are bent to ellipses: half as wide and deep at the hem as told, cm."""
    mesh = mesh_pattern(draft(name, **options), 4.0)
    vertices = place_vertices(mesh).copy()
    y = vertices[:, 1]
    share = np.clip((y.max() - y) / np.ptp(y), 0.0, 1.0)
    turn = np.linspace(0.0, 2 * np.pi, len(vertices))
    vertices[:, 0] = (12.0 + share * (wide - 12.0)) * np.sin(turn)
    vertices[:, 2] = (12.0 + share * (deep - 12.0)) * np.cos(turn)
    return SimpleNamespace(mesh=mesh, pattern=mesh.pattern, vertices=vertices)


@pytest.mark.parametrize(("name", "options"), [("coat", {"flare": 70.0}), ("swing-dress", {})])
def test_what_hangs_before_and_behind_is_brought_to_the_sides(name, options):
    garment = hung(name, 24.0, 36.0, **options)
    moved = flare_evened(garment, BODY)
    assert moved is not None
    low = garment.vertices[:, 1] < garment.vertices[:, 1].min() + 8.0
    before, after = (np.ptp(v[low][:, [0, 2]], axis=0) for v in (garment.vertices, moved))
    assert after[0] > 1.2 * before[0] and after[1] < before[1]
    assert after[0] / after[1] > 1.3 * before[0] / before[1]
    np.testing.assert_allclose(moved[:, 1], garment.vertices[:, 1])
    high = garment.vertices[:, 1] > BODY.measurements.armpit_level
    np.testing.assert_allclose(moved[high], garment.vertices[high])


@pytest.mark.parametrize(
    ("name", "wide", "deep"),
    [("coat", 36.0, 26.0), ("coat", 17.0, 18.0), ("jumpsuit", 24.0, 36.0), ("shirt", 24.0, 36.0)],
)
def test_others_stay(name, wide, deep):
    assert flare_evened(hung(name, wide, deep), BODY) is None
