"""Darts put into a bodice that hangs together at the waist."""

from __future__ import annotations

import pytest

from swifttailor import draft
from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Gain, Step
from swifttailor.describing.measuring.parts import LOWER_PARTS, Part
from swifttailor.recutting import alter
from swifttailor.recutting.amounts.cuts import let_out_skirt
from swifttailor.recutting.table.cutter import Cutter
from swifttailor.recutting.ways.fullness import let_out_darts
from swifttailor.recutting.ways.waist_darts import add_waist_darts

DARTED = Gain(Claim("bodice", "darted"))


@pytest.fixture(scope="module")
def loose():
    """A dress with a bodice without darts, gathered at the waist."""
    hoodie = alter(draft("t-shirt"), [Gain(Claim("waistband", "hem"))]).pattern
    cropped = alter(hoodie, [Gain(Claim("top_hem", "waist"))])
    assert not cropped.open
    return cropped.pattern


def test_darts_take_in_what_was_gathered(loose, sound):
    gathered = alter(loose, [Step("bodice gathers", 1, 0.3)]).pattern
    before = Cutter(gathered)
    after = sound(gathered, alter(gathered, [DARTED]))
    was, now = before.facts.torso, after.facts.torso
    assert now.darts == 4 and now.gather < was.gather
    assert now.chest == pytest.approx(was.chest, abs=1.0)
    assert after.facts.waistband.upper == pytest.approx(before.facts.waistband.upper, rel=1e-3)
    for stitch in after.pattern.stitches:
        first, second = (after.anatomy.edge_length(r) for r in stitch.sides)
        if stitch.first.panel == stitch.second.panel:
            assert first == pytest.approx(second, rel=1e-6)  # the legs of a dart


def test_a_lower_edge_that_is_not_gathered_stays_as_long(loose, sound):
    before = Cutter(loose)
    after = sound(loose, alter(loose, [DARTED]))
    assert after.facts.torso.gather == pytest.approx(before.facts.torso.gather, abs=0.12)


def test_darts_can_be_let_out_again(loose):
    cutter = Cutter(loose)
    seam = cutter.anatomy.seam(Part.TORSO, {Part.WAISTBAND} | LOWER_PARTS).own
    darted = add_waist_darts(loose, seam, 3.0, 12.0, 9.0)
    names = cutter.names(Part.TORSO)
    plain = let_out_darts(darted, names)
    for name in names:
        was, now = (abs(p.panel(name).signed_area()) for p in (loose, plain))
        assert now == pytest.approx(was, rel=1e-3)
    assert add_waist_darts(loose, seam, 60.0, 12.0, 9.0) is None
    assert add_waist_darts(loose, (*seam, seam[0]), 3.0, 12.0, 9.0) is None
    assert let_out_skirt(cutter) is None


def test_a_top_with_a_free_hem_gets_none():
    assert alter(draft("t-shirt"), [DARTED]).open == (DARTED,)
