"""Waists of skirts and trousers let out and taken in."""

import pytest

from swifttailor import draft
from swifttailor.describing.differences import Step
from swifttailor.describing.measuring import measure_facts
from swifttailor.recutting import alter


@pytest.mark.parametrize("by", [-3.0, 3.0, 5.0])
@pytest.mark.parametrize(
    "name", ["fitted-skirt", "circle-skirt", "gathered-skirt", "trousers", "jeans", "leggings"]
)
def test_the_band_is_let_out_by_as_much_as_is_asked(name, by, sound):
    pattern = draft(name)
    before = measure_facts(pattern)
    altered = alter(pattern, [Step("waistband width", 1 if by > 0 else -1, abs(by))], keep_others=True)
    after = sound(pattern, altered).facts
    assert after.waistband.upper - before.waistband.upper == pytest.approx(by, abs=0.25 * abs(by))
    assert after.length == pytest.approx(before.length, abs=1.5)
    if before.trousers:
        assert after.trousers.hem == pytest.approx(before.trousers.hem, abs=0.5)
    else:
        assert after.skirt.hem == pytest.approx(before.skirt.hem, rel=0.05)


def test_a_band_at_the_hem_of_a_top_is_no_waist():
    pattern = draft("hoodie", hem_band=True)
    altered = alter(pattern, [Step("waistband width", 1, 4.0)])
    assert not [cut for cut in altered.cuts if cut.startswith("waist")]
