"""Room in trousers: legs spread from waist to hem."""

from __future__ import annotations

import pytest

import swifttailor
from swifttailor.describing.measuring import measure_facts


@pytest.mark.parametrize("name", ["trousers", "jumpsuit"])
def test_loose_trousers_have_room_at_hips_and_thighs_and_the_same_length(name):
    before = measure_facts(swifttailor.draft(name))
    altered = swifttailor.alter(swifttailor.draft(name), ["hips=loose"])
    after = measure_facts(altered.pattern)
    assert not altered.open
    assert after.trousers.hips > before.trousers.hips + 10.0
    assert after.trousers.thigh > before.trousers.thigh + 4.0
    assert after.trousers.inseam == pytest.approx(before.trousers.inseam, abs=0.5)
    assert after.trousers.gather > 1.1, "what is wider is gathered at the waist"
    assert not [f for f in swifttailor.check(altered.pattern) if f.severity.name == "ERROR"]


def test_thighs_get_as_much_room_as_is_asked_for():
    before = measure_facts(swifttailor.draft("trousers")).trousers.thigh
    altered = swifttailor.alter(swifttailor.draft("trousers"), ["thigh +8"])
    assert measure_facts(altered.pattern).trousers.thigh - before == pytest.approx(8.0, abs=2.0)
