"""Halves of a garment exchanged for those of another pattern."""

import pytest

from swifttailor import draft
from swifttailor.describing.measuring.parts import LOWER_PARTS, UPPER_PARTS
from swifttailor.pattern import Severity, check_pattern
from swifttailor.recutting.amounts.donor_parts import lower_from, upper_from
from swifttailor.recutting.table.cutter import Cutter

DRESS, OTHER = draft("fitted-dress"), draft("shirt-dress")


def shapes(pattern, names):
    return {name: pattern.panel(name).vertices.round(6).tolist() for name in names}


@pytest.mark.parametrize("donor", ["shirt-dress", "circle-skirt", "strapless-dress"])
def test_a_new_skirt_leaves_the_bodice_bit_for_bit(donor):
    cutter, other = Cutter(DRESS), Cutter(draft(donor))
    made = lower_from(cutter, other)
    assert made is not None
    upper = cutter.names(*UPPER_PARTS)
    after = Cutter(made)
    assert set(after.names(*UPPER_PARTS)) == set(upper)
    # Edges may be cut where the new skirt has a seam; no corner is lost or moved.
    for name in upper:
        own, new = cutter.pattern.panel(name), made.panel(name)
        kept = new.to_world(new.vertices).round(4).tolist()
        assert all(corner in kept for corner in own.to_world(own.vertices).round(4).tolist())
    assert after.facts.skirt and other.facts.skirt
    assert after.facts.skirt.length == pytest.approx(other.facts.skirt.length, rel=0.05)
    assert not [f for f in check_pattern(made) if f.severity is Severity.ERROR]


def test_a_new_bodice_leaves_the_skirt_as_it_is():
    cutter, other = Cutter(OTHER), Cutter(DRESS)
    made = upper_from(cutter, other)
    if made is None:  # the waists differ too much
        assert abs(cutter.facts.torso.lower_edge - other.facts.torso.lower_edge) > 1.0
        return
    lower = cutter.names(*LOWER_PARTS)
    assert set(shapes(made, lower)) == set(lower)
    assert len(made.components()) == 1


def test_there_is_nothing_to_sew_to_without_a_bodice():
    assert lower_from(Cutter(draft("t-shirt")), Cutter(OTHER)) is None
    assert upper_from(Cutter(draft("circle-skirt")), Cutter(DRESS)) is None
