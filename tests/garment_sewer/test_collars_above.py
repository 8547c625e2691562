"""What is turned down of a collar stays above the cloth that it lies on."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest

from swifttailor import draft
from swifttailor.body import Body
from swifttailor.draping.placement import place_vertices
from swifttailor.garment_sewer.collars_above import collar_above
from swifttailor.garment_sewer.pixels.body_distance import BodyDistance
from swifttailor.panel_mesh import mesh_pattern

BODY = Body.default()


@pytest.mark.parametrize("name", ["shirt", "blazer"])
def test_a_collar_that_has_sunk_is_lifted(name):
    mesh = mesh_pattern(draft(name), 3.0)
    hold = collar_above(mesh, place_vertices(mesh), BODY)
    assert hold is not None
    distance, no_arms = BodyDistance.of(BODY), np.zeros(len(hold.collar), dtype=bool)
    body = BODY.vertices[(BODY.vertices[:, 1] > 125.0) & (np.abs(BODY.vertices[:, 0]) < 18.0)]
    at = np.resize(body, (mesh.vertex_count, 3))
    ways = distance.sample(at, np.zeros(len(at), dtype=bool))[1]
    places = at + 1.5 * ways  # the cloth 1.5 cm above the skin
    places[hold.collar] = at[hold.collar] + 0.6 * ways[hold.collar]
    state = SimpleNamespace(positions=places, velocities=-10.0 * ways)
    before = distance.sample(places[hold.collar], no_arms)[0]
    hold(state, 0.5)
    after = distance.sample(state.positions[hold.collar], no_arms)[0]
    assert np.median(after - before) > 0.5
    still = np.setdiff1d(np.arange(mesh.vertex_count), hold.collar)
    np.testing.assert_allclose(state.positions[still], places[still])


@pytest.mark.parametrize("name", ["t-shirt", "hoodie", "circle-skirt"])
def test_without_a_turned_down_collar_nothing_is_held(name):
    mesh = mesh_pattern(draft(name), 4.0)
    assert collar_above(mesh, place_vertices(mesh), BODY) is None
