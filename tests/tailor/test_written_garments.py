"""What makes a written pattern a garment to show: no holes, both sides, a level hem, what is usual."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from test_fitting import Listening, Reading, Scripted, answer, wanted, written

import swifttailor
from swifttailor.describing import Claim, measure_facts
from swifttailor.describing.differences import Gain
from swifttailor.pattern import Pattern
from swifttailor.pattern.drafts import list_drafts
from swifttailor.recutting.amounts.cuts import free_hem
from swifttailor.recutting.holes import has_holes
from swifttailor.recutting.level_hems import LEVEL_CM, level_hem, unevenness
from swifttailor.recutting.one_sided import made_of_one_side, one_sided_panels
from swifttailor.recutting.table.cutter import Cutter
from swifttailor.recutting.ways.hem_line import bend_hem
from swifttailor.tailor.fitting import fit
from swifttailor.tailor.order import Order
from swifttailor.wishes.corrections.sureness import likely_wishes
from swifttailor.wishes.reader import Wish


def without(pattern: Pattern, *names: str) -> Pattern:
    return replace(
        pattern,
        panels=tuple(p for p in pattern.panels if p.name not in names),
        stitches=tuple(s for s in pattern.stitches if all(side.panel not in names for side in s.sides)),
    )


def unsewn(pattern: Pattern, one: str, other: str) -> Pattern:
    between = {one, other}
    return replace(
        pattern, stitches=tuple(s for s in pattern.stitches if {x.panel for x in s.sides} != between)
    )


@pytest.mark.parametrize("name", [d.name for d in list_drafts()])
def test_no_draft_has_holes(name):
    assert not has_holes(swifttailor.draft(name))


@pytest.mark.parametrize(
    ("name", "one", "other"),
    [
        ("t-shirt", "left_ftorso", "left_btorso"),
        ("t-shirt", "left_ftorso", "left_sleeve_f"),
        ("trousers", "pant_b_l", "pant_b_r"),
    ],
)
def test_a_seam_left_open_is_a_hole(name, one, other):
    whole = swifttailor.draft(name)
    torn = unsewn(whole, one, other)
    assert len(torn.stitches) < len(whole.stitches)
    assert has_holes(torn)


@pytest.mark.parametrize(("front", "back"), [(12.0, 0.0), (-9.0, 6.0), (0.0, 14.0)])
def test_a_bent_hem_is_made_level(front, back):
    skirt = swifttailor.draft("circle-skirt")
    bent = bend_hem(skirt, free_hem(Cutter(skirt)), {"front": front, "back": back})
    assert bent is not None
    before, (after, words) = measure_facts(bent), level_hem(bent)
    hem = measure_facts(after).hem
    assert before.hem is not None and hem is not None
    assert unevenness(before.hem) > 5.0
    assert unevenness(hem) < LEVEL_CM
    assert words
    assert level_hem(skirt) == (skirt, "")


@pytest.mark.parametrize("longer", [-8.0, 9.0])
def test_the_hem_of_a_circle_skirt_is_drawn_around_the_waist_again(longer):
    skirt = swifttailor.draft("circle-skirt")
    hem = {ref.panel: ref.edge for ref in free_hem(Cutter(skirt))}
    panels = []
    for panel in skirt.panels:  # the sides are longer, or shorter, than the middle
        vertices = panel.vertices.copy()
        if panel.name in hem:
            edge, count = hem[panel.name], len(vertices)
            for corner, start in ((edge, edge - 1), (edge + 1, edge + 2)):
                along = vertices[corner % count] - vertices[start % count]
                vertices[corner % count] += longer * along / np.linalg.norm(along)
        panels.append(replace(panel, vertices=vertices))
    pointed = replace(skirt, panels=tuple(panels))
    facts, after = measure_facts(pointed).hem, measure_facts(level_hem(pointed)[0]).hem
    assert facts is not None and after is not None
    assert unevenness(facts) > LEVEL_CM
    assert unevenness(after) < 1.0
    ends = facts.front, facts.back, facts.left, facts.right
    assert min(ends) - 3.0 < after.level < max(ends) + 3.0  # it is long in the corners


def test_half_a_pair_of_shorts_is_completed():
    whole = swifttailor.draft("trousers")
    half = without(whole, "pant_f_r", "pant_b_r")
    made = made_of_one_side(half, unsewn=True)
    assert one_sided_panels(half)
    assert not one_sided_panels(made)
    assert {frozenset(s.sides) for s in made.stitches} == {frozenset(s.sides) for s in whole.stitches}
    assert made_of_one_side(whole) is whole


def test_sides_that_are_to_differ_stay():
    half = without(swifttailor.draft("t-shirt"), "right_sleeve_f", "right_sleeve_b")
    one = Wish(Gain(Claim("sleeves", "left only")), 0.95)
    assert fit(written(half), wanted([one], unsaid=True)).pattern is half
    asked = fit(written(half), wanted([Wish(Gain(Claim("kind", "top")), 0.95)], unsaid=True))
    facts = measure_facts(asked.pattern)
    assert facts.left_sleeve is not None and facts.right_sleeve is not None


def test_a_hood_that_nobody_asked_for_comes_off_where_words_are_all_there_is():
    hoodie = swifttailor.draft("hoodie")
    top = [Wish(Gain(Claim("kind", "top")), 0.95)]
    plain = fit(written(hoodie), wanted(top, unsaid=True))
    assert measure_facts(plain.pattern).hood is None
    assert plain.verdict.open == ()
    assert fit(written(hoodie), wanted(top)).pattern is hoodie  # a picture may show one
    asked = [*top, Wish(Gain(Claim("hood", "hood")), 0.95)]
    assert measure_facts(fit(written(hoodie), wanted(asked, unsaid=True)).pattern).hood is not None


def test_what_is_likely_is_cut_last_and_no_fault_where_it_cannot_be():
    shirt = swifttailor.draft("t-shirt")
    top = [Wish(Gain(Claim("kind", "top")), 0.95)]
    long = Wish(Gain(Claim("sleeves", "long")), 0.6)
    fitted = fit(written(shirt), wanted(top, None, [long], unsaid=True))
    assert long.change.holds(fitted.pattern, measure_facts(fitted.pattern))
    impossible = Wish(Gain(Claim("kind", "skirt")), 0.6)
    assert fit(written(shirt), wanted(top, None, [impossible], unsaid=True)).verdict.rank == (0, 0, 0)


def test_what_is_likely_is_what_nothing_else_is_read_of():
    none, long = Wish(Gain(Claim("sleeves", "none")), 0.95), Wish(Gain(Claim("sleeves", "long")), 0.6)
    skirt, number = Wish(Gain(Claim("kind", "skirt")), 0.7), Wish(Gain(Claim("hem_cm", 50.0)), 0.8)
    assert likely_wishes([none, long, skirt, number]) == (skirt,)


def test_garments_that_nobody_can_wear_are_the_last_to_be_taken():
    trousers = swifttailor.draft("trousers")
    band = without(trousers, "pant_f_l", "pant_b_l", "pant_f_r", "pant_b_r")
    fitted = answer(Scripted(band, trousers), Order("🩳", attempts=2), Reading())
    assert {p.name for p in fitted.pattern.panels} == {p.name for p in trousers.panels}
    judged = fit(written(band), wanted(unsaid=True)).verdict
    assert judged.senseless and judged.fault == "nobody could wear it"


def test_every_second_attempt_is_asked_in_words_that_were_taught():
    shirt = swifttailor.draft("t-shirt")
    wishes = Wish(Gain(Claim("kind", "skirt")), 0.95), Wish(Gain(Claim("skirt", "gathered")), 0.95)
    maker = Listening(shirt, shirt, shirt)
    answer(maker, Order("a bleu gatherd skrit with a slit", attempts=3, source="writer"), Reading(*wishes))
    assert maker.asked[0] == maker.asked[2] == "a bleu gathered skirt with a slit"
    assert "skirt" in maker.asked[1].lower()
    assert "bleu" not in maker.asked[1]
    picture = Listening(shirt, shirt)
    image = np.full((8, 8, 3), 200, np.uint8)
    answer(picture, Order("a pencil skirt", image, attempts=2, source="writer"), Reading(*wishes))
    assert picture.asked == ["a pencil skirt", "a pencil skirt"]
