"""Patterns with every fault that a check knows: each is sewn, or refused with the reason."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from pattern_faults import FAULTS

from swifttailor.errors import SwiftTailorError
from swifttailor.garment_sewer.pixels.sewn_prior import vertices_ignoring_arms
from swifttailor.garment_sewer.sewer import GarmentSewer
from swifttailor.panel_mesh.topology import topology

TINY = Path(__file__).with_name("tiny_sewer.onnx")
REFUSED = {
    "no-area": "no area",
    "self-crossing": "crosses or touches itself",
    "near-crossing": "crosses or touches itself",
    "dangling-stitch": "does not exist",
    "self-stitched-edge": "can be sewn once",
    "duplicate-stitch": "can be sewn once",
    "edge-stitched-twice": "can be sewn once",
}
TWISTED = {"twisted-seam"}
"""Sewn as they are, a panel's front against another's back."""


@pytest.fixture(scope="module")
def sewer() -> GarmentSewer:
    return GarmentSewer.load(TINY)


@pytest.mark.parametrize("code", sorted(FAULTS))
def test_every_fault_is_sewn_or_refused_with_the_reason(sewer, code):
    faulty = FAULTS[code][1]
    if code in REFUSED:
        with pytest.raises(SwiftTailorError, match=REFUSED[code]) as refused:
            sewer.sew(faulty, edge_length=3.0)
        assert "swifttailor check" in str(refused.value)
        return
    garment = sewer.sew(faulty, edge_length=3.0)
    assert np.isfinite(garment.vertices).all()
    counts = topology(garment.faces, len(garment.vertices))
    assert counts.nonmanifold_edges == 0
    assert (counts.inconsistent_edges > 0) == (code in TWISTED)
    assert counts.components == (2 if code == "disconnected" else 1)
    distance, _ = sewer.body.sample(garment.vertices, vertices_ignoring_arms(garment.mesh))
    assert (distance < 0).mean() <= 0.005
