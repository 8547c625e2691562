"""Garments that slip off the shoulders once they are sewn."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import swifttailor
from swifttailor.body import Body
from swifttailor.tailor import Tailor
from swifttailor.tailor.worn_shoulders import slips_off

_MEASURES = Body.default().measurements


@pytest.fixture(scope="module")
def tailor():
    return Tailor.load()


@pytest.mark.parametrize("name", ["t-shirt", "fitted-dress", "slip-dress", "hoodie"])
def test_what_hangs_from_the_shoulders_has_not_slipped_until_it_lies_at_the_bust(tailor, name):
    garment = tailor.sew(swifttailor.draft(name), edge_length=4.0).garment
    assert not slips_off(garment, _MEASURES)
    lower = replace(garment, vertices=garment.vertices - np.array([0.0, 22.0, 0.0]))
    assert slips_off(lower, _MEASURES)


@pytest.mark.parametrize("name", ["strapless-dress", "trousers"])
def test_what_has_no_shoulders_does_not_slip_off_them(tailor, name):
    garment = tailor.sew(swifttailor.draft(name), edge_length=4.0).garment
    lower = replace(garment, vertices=garment.vertices - np.array([0.0, 22.0, 0.0]))
    assert not slips_off(lower, _MEASURES)
