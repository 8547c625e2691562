"""Wide tops fall for longer, until they hang down instead of standing out like bells."""

import numpy as np
import pytest

from swifttailor import draft
from swifttailor.body import Body
from swifttailor.garment_sewer.relaxing import WIDE_FRAMES, hangs_free, relaxed
from swifttailor.garment_sewer.sewer import GarmentSewer


@pytest.fixture(scope="module")
def sewer():
    return GarmentSewer.load()


def test_wide_tops_fall_for_longer(sewer):
    sewn = sewer.sew(draft("t-shirt", chest_ease=30.0, length=32.0, flare=15.0), edge_length=3.0)
    fallen = relaxed(sewn)
    assert fallen.report["relaxed_frames"] == WIDE_FRAMES
    low = np.argsort(fallen.vertices[:, 1])[:40]
    assert np.ptp(fallen.vertices[low, 0]) <= np.ptp(sewn.vertices[low, 0]) + 0.5


@pytest.mark.parametrize(
    ("name", "free"), [("t-shirt", False), ("circle-skirt", False), ("hoodie", False), ("poncho", True)]
)
def test_others_do_not_hang_free(sewer, name, free):
    assert hangs_free(sewer.sew(draft(name), edge_length=3.0), Body.default()) == free
