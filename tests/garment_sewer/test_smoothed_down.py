"""Close garments are smoothed down over the body before they fall: their backs lie in no rolls."""

import numpy as np
import pytest

from swifttailor import draft
from swifttailor.body import Body
from swifttailor.draping.relax import relax
from swifttailor.garment_sewer.relaxing import SMOOTHED_FRAMES, relaxed
from swifttailor.garment_sewer.sewer import GarmentSewer


@pytest.fixture(scope="module")
def sewer():
    return GarmentSewer.load()


def _roll(garment) -> float:
    """How far cloth faces up or down, behind, about the waist; root of the mean square."""
    corners = garment.vertices[garment.mesh.faces]
    across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    middle, waist = corners.mean(axis=1), Body.default().measurements.waist_level
    behind = (middle[:, 2] < -5.0) & (np.abs(middle[:, 0]) < 10.0) & (np.abs(middle[:, 1] - waist) < 9.0)
    facing = across[behind, 1] / np.linalg.norm(across[behind], axis=1)
    return float(np.sqrt((facing**2).mean()))


def test_backs_of_close_dresses_are_smoothed_down(sewer):
    dress = sewer.sew(draft("shift-dress", length=44.0, stretch=10.0, chest_ease=2.0, waist_shaping=4.0))
    left, smooth = relaxed(dress), relax(dress, smoothed=SMOOTHED_FRAMES)
    assert np.array_equal(left.vertices, smooth.vertices)
    rolled = relax(dress)
    assert _roll(smooth) < 0.85 * _roll(rolled)
    assert rolled.vertices[:, 1].min() - 5.0 < smooth.vertices[:, 1].min() < rolled.vertices[:, 1].min()


def test_hoods_stay_on_heads(sewer):
    hoodie = sewer.sew(draft("hoodie"), edge_length=3.0)
    fallen = relaxed(hoodie)
    assert "not_relaxed" not in fallen.report
    assert fallen.vertices[:, 1].max() > hoodie.vertices[:, 1].max() - 1.0
