"""The coarse drape tells what would leave the bust bare."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from swifttailor.body import Body
from swifttailor.garment_sewer import GarmentSewer
from swifttailor.garment_sewer.bare_bust import bares_bust, bust_points
from swifttailor.pattern.drafts import draft


@pytest.fixture(scope="module")
def sewer():
    return GarmentSewer.load()


def test_bust_points_are_landmarks_on_the_body(sewer):
    points = bust_points(sewer.body)
    near = [np.linalg.norm(Body.default().vertices - one, axis=1).min() for one in points]
    assert max(near) < 1.5
    assert points[0, 0] == -points[1, 0] > 5.0


@pytest.mark.parametrize("name", ["t-shirt", "strapless-dress", "halter-top", "waistcoat", "jumpsuit"])
def test_drafts_cover_it(sewer, name):
    assert not bares_bust(sewer.prepare(draft(name)), sewer.body)


def test_what_lies_lower_leaves_it_bare_and_skirts_do_not_count(sewer):
    for name, bare in (("strapless-dress", True), ("circle-skirt", False)):
        prepared = sewer.prepare(draft(name))
        low = prepared.table.prior - np.array([0.0, 25.0, 0.0], dtype=prepared.table.prior.dtype)
        slid = replace(prepared, table=replace(prepared.table, prior=low))
        assert bares_bust(slid, sewer.body) == bare
