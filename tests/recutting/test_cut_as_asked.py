"""Changes that people ask for and that no single lever brings: what holds then, and what stays."""

from __future__ import annotations

import pytest

from swifttailor import draft
from swifttailor.describing.change_text import read_change
from swifttailor.describing.claims import Claim
from swifttailor.describing.dimensions import QUANTITIES
from swifttailor.describing.facts_paths import sleeves_of
from swifttailor.recutting import alter
from swifttailor.recutting.amounts.cuts import lengthen_hem
from swifttailor.recutting.amounts.sleeve_cuts import renew_sleeves
from swifttailor.recutting.table.cutter import Cutter
from swifttailor.recutting.unasked import unasked


@pytest.mark.parametrize(
    ("name", "wish"),
    [
        ("t-shirt", "sleeve_shape=balloon"),
        ("shirt-dress", "sleeve_shape=balloon"),
        ("t-shirt", "kind=jumpsuit"),
        ("hoodie", "kind=jumpsuit"),
        ("jumpsuit", "chest +8"),
        ("jumpsuit", "chest -5"),
        ("t-shirt", "length +8"),
        ("t-shirt", "length -4"),
    ],
)
def test_it_is_cut_and_nothing_else(name, wish):
    start = Cutter(draft(name))
    done = alter(start.pattern, [wish], keep_others=True)
    assert not done.open, done
    assert Cutter(done.pattern).faults <= start.faults
    if wish.startswith("length"):
        width = QUANTITIES["top width"].of
        assert width(done.facts) == pytest.approx(width(start.facts), abs=0.5 if "+" in wish else 4.0)
    if wish == "kind=jumpsuit":
        assert done.facts.front_neck == start.facts.front_neck
        assert sleeves_of(done.facts) == sleeves_of(start.facts)


@pytest.mark.parametrize("name", ["t-shirt", "shirt-dress", "hoodie"])
def test_sleeves_are_cut_anew_for_the_armholes_that_there_are(name):
    start = Cutter(draft(name))
    renewed = renew_sleeves(start, 36.0)
    assert renewed is not None
    after = Cutter(renewed)
    was, now = start.facts.left_sleeve, after.facts.left_sleeve
    assert now.length == pytest.approx(was.length, abs=1.0)
    assert (now.cuff is None) == (was.cuff is None)
    assert now.head_gather == pytest.approx(1.0, abs=0.01)
    kept = {p.name for p in renewed.panels if "sleeve" not in p.name and "cuff" not in p.name}
    assert all(renewed.panel(n) == start.pattern.panel(n) for n in kept)


@pytest.mark.parametrize("cm", [1.0, 2.5, 4.0, 6.0, 9.0])
def test_what_is_cut_off_does_not_depend_on_where_a_seam_is_pieced(cm):
    start = Cutter(draft("t-shirt"))
    longer = start.with_pattern(lengthen_hem(start, 3.0))
    shorter = lengthen_hem(longer, -cm)
    assert shorter is not None
    assert longer.facts.length - Cutter(shorter).facts.length == pytest.approx(cm, abs=0.6)


def test_a_skirt_that_is_cut_smooth_makes_no_bodice_more_gathered():
    quantity = QUANTITIES["bodice gathers"]
    assert not quantity.seen(0.5, 1.0)
    assert quantity.seen(1.0, 1.3)


def test_no_longer_hem_makes_a_dress_of_a_jumpsuit():
    before, after = (Cutter(draft(name)).facts for name in ("jumpsuit", "shirt-dress"))
    found = unasked(frozenset({"bodice", "hem"}), before, after)
    assert read_change("kind=dress") in found


def test_one_more_tier_is_one():
    start = draft("fitted-skirt")
    assert Claim("tiers", 2.0).holds(alter(start, ["tiers +"]).facts)
