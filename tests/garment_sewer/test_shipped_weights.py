"""The weights that come with the package, at their work."""

from __future__ import annotations

import json

import numpy as np
import pytest

from swifttailor.body import Body
from swifttailor.draping.worn_height import worn_height
from swifttailor.garment_sewer.pixels.sewn_prior import vertices_ignoring_arms
from swifttailor.garment_sewer.sewer import SHIPPED, GarmentSewer
from swifttailor.panel_mesh.topology import topology
from swifttailor.pattern.drafts import draft


@pytest.fixture(scope="module")
def sewer():
    return GarmentSewer.load()


@pytest.fixture(scope="module", params=["t-shirt", "fitted-dress", "trousers", "hoodie"])
def garment(sewer, request):
    return sewer.sew(draft(request.param))


def test_card_beside_the_file_is_the_one_in_it(sewer):
    card = json.loads(SHIPPED.with_suffix(".json").read_text())
    assert card == sewer.model.card
    assert card["training"]["garments_seen"] > 0 and card["data"]["train"]["garments"] > 0
    assert card["validation"]["mean"] < 5
    assert "/work" not in json.dumps(card) and "/home" not in json.dumps(card)


def test_garment_is_whole_and_sewn(garment):
    found = topology(garment.faces, len(garment.vertices))
    assert found.nonmanifold_edges == found.inconsistent_edges == 0
    assert found.components == 1
    assert garment.report["sewing"]["seam_gap_before_median_cm"] < 1.0


def test_garment_is_worn_and_outside_the_body(garment, sewer):
    assert (
        garment.vertices[:, 1].max() > worn_height(garment.mesh.pattern, Body.default().measurements).lowest
    )
    distance, _ = sewer.body.sample(garment.vertices, vertices_ignoring_arms(garment.mesh))
    assert (distance < 0).mean() <= 0.005


def test_cloth_keeps_its_area(garment):
    corners = garment.vertices[garment.faces]
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    area = np.linalg.norm(normal, axis=1).sum() / 2
    flat = sum(abs(p.signed_area()) for p in garment.mesh.pattern.panels)
    assert 0.9 < area / flat < 1.1
