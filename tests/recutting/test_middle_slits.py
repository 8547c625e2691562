"""Slits in the middle of a skirt end below the crotch."""

from __future__ import annotations

import pytest

from swifttailor.pattern.drafts import draft
from swifttailor.recutting.levers.slits import SLIT_LEVERS
from swifttailor.recutting.table.cutter import Cutter


@pytest.mark.parametrize(("length", "most"), [(42.0, 7.0), (70.0, 40.0)])
def test_one_behind_ends_below_the_crotch(length, most):
    facts = Cutter(draft("fitted-skirt", length=length)).facts
    spans = {lever.name: lever.span(facts)[1] for lever in SLIT_LEVERS}
    assert spans["slit behind"] <= most
    assert spans["slit left"] > spans["slit behind"]
