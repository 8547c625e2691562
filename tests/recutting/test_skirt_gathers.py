"""Skirts gathered more, darts let out for it."""

import pytest

from swifttailor import draft
from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Gain, Step
from swifttailor.recutting import alter
from swifttailor.recutting.amounts.cuts import let_out_skirt
from swifttailor.recutting.table.cutter import Cutter


@pytest.mark.parametrize("wish", [Step("skirt gathers", 1), Gain(Claim("skirt", "gathered"))])
@pytest.mark.parametrize("name", ["fitted-dress", "fitted-skirt"])
def test_darts_are_let_out(name, wish):
    before = Cutter(draft(name))
    assert before.facts.skirt.darts
    altered = alter(before.pattern, [wish])
    assert altered.done and altered.cuts[0] == "skirt darts let out"
    assert Cutter(altered.pattern).faults <= before.faults
    assert altered.facts.skirt.darts == 0


def test_what_darts_took_in_goes_left_and_right_alike():
    before = Cutter(draft("fitted-skirt"))
    after = Cutter(let_out_skirt(before))
    for name in before.names(*{p.part for p in before.anatomy.parts.values()}):
        old, new = before.pattern.panel(name), after.pattern.panel(name)
        assert new.bounding_box() == pytest.approx(old.bounding_box(), abs=0.5)
    assert after.facts.skirt.gather > before.facts.skirt.gather + 0.02
    assert let_out_skirt(after) is None
    assert let_out_skirt(Cutter(draft("t-shirt"))) is None
