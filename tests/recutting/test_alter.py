"""Altering: wishes come true, nothing else changes, no fault is added, and the same input gives the same."""

from __future__ import annotations

import numpy as np
import pytest

from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import QUANTITIES, Change, Gain, Step
from swifttailor.describing.facts import GarmentFacts
from swifttailor.describing.measuring import measure_facts
from swifttailor.errors import SwiftTailorError
from swifttailor.pattern import Pattern, Severity, check_pattern, to_specification
from swifttailor.pattern.drafts import draft
from swifttailor.recutting import alter


def gain(name: str, value: str | float) -> Gain:
    return Gain(Claim(name, value))


WISHES: list[tuple[str, Change]] = [
    ("shirt-dress", gain("skirt_hem", "maxi")),
    ("shirt-dress", gain("skirt_hem", "mini")),
    ("shirt-dress", gain("sleeves", "none")),
    ("shirt-dress", gain("sleeves", "three-quarter")),
    ("shirt-dress", Step("length", -1, 12.0)),
    ("t-shirt", gain("sleeve_cm", 58.0)),
    ("t-shirt", gain("top_hem", "cropped")),
    ("t-shirt", gain("neckline", "v")),
    ("t-shirt", gain("neckline", "square")),
    ("t-shirt", gain("left_neckline", "v")),
    ("t-shirt", gain("neck_depth", "low")),
    ("t-shirt", gain("neck_depth_cm", 16.0)),
    ("t-shirt", gain("back_neckline", "v")),
    ("t-shirt", gain("waistband", "hem")),
    ("t-shirt", gain("cuffs", "band")),
    ("t-shirt", gain("cuff_cm", 5.0)),
    ("t-shirt", gain("kind", "dress")),
    ("t-shirt", gain("left_sleeve", "long")),
    ("hoodie", Step("cuff opening", 1)),
    ("t-shirt", gain("bodice", "flared")),
    ("t-shirt", Step("neck width", 1)),
    ("t-shirt", Step("neck width", -1)),
    ("t-shirt", Step("chest", 1, 10.0)),
    ("t-shirt", Step("sleeve length", -1)),
    ("tank-top", Step("back depth", 1)),
    ("tank-top", Step("shoulders", -1)),
    ("hoodie", gain("hood", "none")),
    ("hoodie", gain("cuffs", "none")),
    ("hoodie", gain("waistband", "none")),
    ("hoodie", Step("waistband height", 1, 4.0)),
    ("hoodie", Step("chest", -1)),
    ("hoodie", gain("neckline", "v")),
    ("trousers", gain("leg_hem", "knee")),
    ("trousers", gain("legs", "flared")),
    ("trousers", gain("leg_width_cm", 60.0)),
    ("trousers", gain("kind", "shorts")),
    ("trousers", gain("inseam_cm", 50.0)),
    ("trousers", gain("waistband", "none")),
    ("trousers", gain("leg_cuffs", "band")),
    ("jumpsuit", gain("kind", "trousers")),
    ("jumpsuit", Step("bodice length", 1)),
    ("fitted-dress", gain("kind", "skirt")),
    ("fitted-dress", gain("kind", "top")),
    ("fitted-dress", Step("chest", 1)),
    ("fitted-dress", gain("waist_seam", "dropped")),
    ("fitted-skirt", gain("slit", "left")),
    ("fitted-skirt", gain("slit", "back")),
    ("fitted-skirt", gain("slit_cm", 20.0)),
    ("fitted-skirt", gain("hem_cm", 130.0)),
    ("fitted-skirt", gain("skirt_length_cm", 70.0)),
    ("gathered-skirt", Step("skirt gathers", 1)),
    ("gathered-skirt", gain("waistband_cm", 7.0)),
]


def faults(pattern: Pattern) -> set[tuple[str, str]]:
    return {(f.code, f.panel) for f in check_pattern(pattern) if f.severity is not Severity.INFO}


def symmetric(facts: GarmentFacts) -> bool:
    pairs: list[tuple[float, float]] = []
    if facts.hem:
        pairs.append((facts.hem.left, facts.hem.right))
    if facts.left_sleeve and facts.right_sleeve:
        pairs.append((facts.left_sleeve.length, facts.right_sleeve.length))
        pairs.append((facts.left_sleeve.end_width, facts.right_sleeve.end_width))
    if facts.torso and facts.torso.left_shoulder and facts.torso.right_shoulder:
        pairs.append((facts.torso.left_shoulder, facts.torso.right_shoulder))
    for neck in (facts.front_neck, facts.back_neck):
        if neck and neck.left and neck.right:
            pairs += [(neck.left.depth, neck.right.depth), (neck.left.width, neck.right.width)]
    return all(abs(a - b) < 0.1 for a, b in pairs)


@pytest.mark.parametrize(("name", "wish"), WISHES, ids=lambda v: str(v).replace(" ", ""))
def test_a_wish_comes_true_and_nothing_breaks(name, wish):
    pattern = draft(name)
    spoken = to_specification(pattern)
    before = measure_facts(pattern)
    assert not wish.holds(before, before)

    altered = alter(pattern, [wish])

    assert altered.done == (wish,) and altered.open == ()
    assert altered.cuts
    after = measure_facts(altered.pattern)
    assert wish.holds(before, after)
    assert altered.facts == after
    assert faults(altered.pattern) <= faults(pattern)
    used = [r for s in altered.pattern.stitches for r in s.sides]
    assert len(used) == len(set(used)) and len(altered.pattern.components()) == 1
    assert to_specification(pattern) == spoken, "the pattern that came was changed"
    one_sided = isinstance(wish, Gain) and ("left" in wish.claim.name or wish.claim.value == "left")
    assert one_sided or symmetric(after)


# What else may change with a measure, since it is measured across it.
UNTOUCHED = [
    ("t-shirt", gain("sleeve_cm", 58.0), {"sleeve length", "sleeve end"}),
    ("t-shirt", Step("neck width", 1), {"neck width", "shoulders", "neck depth", "back depth"}),
    ("t-shirt", gain("neckline", "v"), set()),
    ("t-shirt", gain("neck_depth_cm", 16.0), {"neck depth"}),
    ("t-shirt", Step("chest", 1, 10.0), {"chest", "shoulders", "top width", "sleeve length"}),
    ("shirt-dress", gain("skirt_hem", "maxi"), {"length", "skirt hem", "base width", "dip"}),
    ("trousers", gain("legs", "flared"), {"leg end", "thigh"}),
    ("fitted-skirt", gain("slit", "left"), {"left slit"}),
    ("hoodie", Step("waistband height", 1, 4.0), {"waistband height", "length"}),
]


@pytest.mark.parametrize(
    ("name", "wish", "may_change"),
    UNTOUCHED,
    ids=lambda v: "-".join(sorted(v)) if isinstance(v, set) else str(v).replace(" ", ""),
)
def test_what_was_not_asked_for_stays(name, wish, may_change):
    before = measure_facts(draft(name))
    after = alter(draft(name), [wish]).facts
    for key, quantity in QUANTITIES.items():
        was, now = quantity.of(before), quantity.of(after)
        if key not in may_change and was is not None and now is not None:
            assert abs(now - was) < quantity.least / 2, key


def test_an_amount_is_met():
    before = measure_facts(draft("shirt-dress"))
    for direction in (1, -1):
        after = alter(draft("shirt-dress"), [Step("length", direction, 9.0)]).facts
        assert (after.length - before.length) * direction == pytest.approx(9.0, abs=1.0)


def test_several_wishes_hold_together():
    wishes = [
        gain("neckline", "v"),
        gain("neck_depth", "low"),
        gain("sleeves", "long"),
        Step("length", 1, 15.0),
        Step("chest", 1, 8.0),
    ]
    pattern = draft("t-shirt")
    altered = alter(pattern, wishes)
    before, after = measure_facts(pattern), measure_facts(altered.pattern)
    assert altered.open == () and set(altered.done) == set(wishes)
    assert all(w.holds(before, after) for w in wishes)


def test_a_wish_that_holds_is_kept_and_not_reported():
    pattern = draft("trousers")
    facts = measure_facts(pattern)
    flared = gain("legs", "flared")
    wide = alter(pattern, [flared]).pattern
    altered = alter(wide, [flared, gain("leg_hem", "knee")])
    assert altered.done == (gain("leg_hem", "knee"),)
    assert flared.holds(facts, altered.facts)


def test_what_cannot_be_done_is_left_open():
    pattern = draft("t-shirt")
    wishes = [gain("legs", "wide"), gain("godets", 4.0), gain("top_hem", "cropped")]
    altered = alter(pattern, wishes)
    assert altered.open == (wishes[0], wishes[1])
    assert altered.done == (wishes[2],)
    nothing = alter(pattern, wishes[:2])
    assert nothing.pattern is pattern and nothing.cuts == ()


def test_wishes_against_each_other_do_not_undo_each_other():
    wishes = [gain("skirt_hem", "maxi"), gain("skirt_hem", "mini")]
    altered = alter(draft("shirt-dress"), wishes)
    assert len(altered.done) == 1 and len(altered.open) == 1


def test_steps_are_judged_against_the_original():
    pattern = draft("shirt-dress")
    original = measure_facts(pattern)
    wish = Step("length", 1, 10.0)
    once = alter(pattern, [wish])
    again = alter(once.pattern, [wish], original=original)
    assert again.cuts == () and again.open == ()
    more = alter(once.pattern, [wish])
    assert more.done == (wish,)


def test_no_more_cuts_than_allowed():
    wishes = [gain("sleeves", "long"), gain("neckline", "v"), Step("length", 1, 15.0)]
    assert len(alter(draft("t-shirt"), wishes, most_cuts=1).cuts) == 1
    assert alter(draft("t-shirt"), wishes, most_cuts=0).cuts == ()


def test_the_same_again():
    wishes = [gain("neckline", "square"), Step("chest", 1), gain("cuffs", "band")]
    one, other = (alter(draft("t-shirt"), wishes) for _ in range(2))
    assert to_specification(one.pattern) == to_specification(other.pattern)
    assert one.cuts == other.cuts


def test_no_panels_no_alteration():
    with pytest.raises(SwiftTailorError, match="without panels"):
        alter(Pattern((), ()), [gain("hood", "none")])


def test_halves_are_mirrored():
    altered = alter(draft("t-shirt"), [gain("neckline", "v"), Step("neck width", 1)]).pattern
    world = np.concatenate([p.to_world(p.vertices) for p in altered.panels])
    for point in world:
        mirrored = point * np.array([-1.0, 1.0, 1.0])
        assert np.abs(world - mirrored).max(axis=1).min() < 0.05


def test_a_part_comes_off_only_where_it_is_spoken_of():
    hooded = alter(draft("hoodie"), [Step("neck depth", 1), Step("sleeve end", 1), Step("length", 1, 12.0)])
    assert hooded.facts.hood is not None and hooded.facts.waistband is not None
    assert all(s and s.cuff for s in (hooded.facts.left_sleeve, hooded.facts.right_sleeve))
    assert alter(draft("hoodie"), [gain("neckline", "v")]).facts.hood is None


def test_slits_open_move_and_close():
    pattern = draft("fitted-skirt", length=80.0)
    opened = alter(pattern, [gain("slit", "back"), gain("slit", "left")])
    assert opened.open == () and opened.facts.skirt is not None
    assert {s.place for s in opened.facts.skirt.slits} == {"back", "left"}
    higher = alter(opened.pattern, [Step("back slit", 1, 8.0)])
    assert higher.done
    closed = alter(higher.pattern, [gain("slit", "none")])
    assert closed.facts.skirt is not None and closed.facts.skirt.slits == ()
    assert faults(closed.pattern) <= faults(pattern)
    assert closed.facts.skirt.hem == pytest.approx(measure_facts(pattern).skirt.hem, abs=1.5)


def test_a_bent_hem_can_be_made_level_again():
    pattern = draft("circle-skirt")
    bent = alter(pattern, [gain("hem_shape", "high-low")])
    assert bent.facts.hem is not None and bent.facts.hem.front - bent.facts.hem.back > 8.0
    level = alter(bent.pattern, [gain("hem_shape", "level")])
    assert level.facts.hem is not None and abs(level.facts.hem.front - level.facts.hem.back) < 8.0
    assert abs(bent.facts.hem.left - measure_facts(pattern).hem.left) < 3.0
