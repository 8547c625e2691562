"""The coarse drape tells what is too tight."""

from __future__ import annotations

from dataclasses import replace

import pytest

from swifttailor.garment_sewer import GarmentSewer
from swifttailor.garment_sewer.tightness import is_too_tight, stretch
from swifttailor.pattern.drafts import DraftMeasurements, draft

SMALLER = {"bust": 0.82, "waist": 0.82, "hips": 0.82, "back_width": 0.82, "waist_back_width": 0.82}
SMALLER |= {"hip_back_width": 0.82}


@pytest.fixture(scope="module")
def sewer():
    return GarmentSewer.load()


def of_somebody_smaller():
    usual = DraftMeasurements()
    return replace(usual, **{name: share * getattr(usual, name) for name, share in SMALLER.items()})


@pytest.mark.parametrize("name", ["fitted-dress", "leggings", "tank-top"])
def test_what_is_cut_for_somebody_smaller_stretches_more(sewer, name):
    own, smaller = draft(name), draft(name, measurements=of_somebody_smaller())
    assert not is_too_tight(sewer.prepare(own))
    assert stretch(sewer.prepare(smaller)) > stretch(sewer.prepare(own)) + 0.04


def test_a_dress_far_too_small_is_too_tight(sewer):
    assert is_too_tight(sewer.prepare(draft("fitted-dress", measurements=of_somebody_smaller())))


def test_gathers_are_loose(sewer):
    assert stretch(sewer.prepare(draft("gathered-skirt"))) < 0.03
