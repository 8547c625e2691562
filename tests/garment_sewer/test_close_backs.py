"""Which garments are smoothed down before they fall: those that follow the back."""

from __future__ import annotations

import numpy as np
import pytest

from swifttailor.body import Body
from swifttailor.garment_sewer.relaxing import CLOSE_BEHIND_CM, lies_close_behind


@pytest.mark.parametrize(("away", "close"), [(0.4, True), (CLOSE_BEHIND_CM + 2.0, False)])
def test_what_follows_the_back_lies_close(away, close):
    body = Body.default()
    cloth = body.vertices - np.array([0.0, 0.0, away])
    assert lies_close_behind(cloth, body) == close


def test_skirts_and_trousers_have_no_back():
    body = Body.default()
    below = body.vertices[body.vertices[:, 1] < body.measurements.waist_level]
    assert not lies_close_behind(below, body)
