"""Other witnesses join what a network says of sleeves, collars and legs, and of what is worn below."""

from __future__ import annotations

import numpy as np
import pytest

from swifttailor.picture_reader.bare_limbs import BareLimbs
from swifttailor.picture_reader.labels import PARTS, statement_labels
from swifttailor.picture_reader.person_halves import LOWER, UPPER
from swifttailor.picture_reader.said import share_of
from swifttailor.picture_reader.worn_heads import COLLARED
from swifttailor.picture_reader.worn_signs import WornSigns, with_signs, worn_below

LABELS = statement_labels()
SEEN = BareLimbs(knees_seen=0.97, hips_seen=0.97)


def answers(part, claim, shares, present=0.0):
    """Answers that say these words of a claim so surely."""
    statements = np.full((len(PARTS), len(LABELS)), -6.0)
    for word, share in shares.items():
        statements[part, LABELS.index((claim, word))] = np.log(share) - np.log1p(-share)
    return {"statements": statements, "present": np.full(len(PARTS), present)}


def said(found, part, claim):
    shares = share_of(found["statements"][part])
    return {word: float(shares[k]) for k, (name, word) in enumerate(LABELS) if name == claim}


def logs(shares):
    return {word: float(np.log(share)) for word, share in shares.items()}


def likeliest(found, part, claim):
    shares = said(found, part, claim)
    return max(shares, key=shares.__getitem__)


@pytest.mark.parametrize(
    ("read", "limbs", "told"),
    [
        ({"none": 0.7, "long": 0.25}, BareLimbs(forearms=-3, upper_arms=-3), "long"),
        ({"none": 0.7, "short": 0.25}, BareLimbs(forearms=3, upper_arms=-3), "short"),
        ({"long": 0.6, "short": 0.3}, BareLimbs(forearms=3), "short"),
        ({"long": 0.9, "short": 0.05}, BareLimbs(forearms=0.5), "long"),
        ({"none": 0.7, "long": 0.25}, BareLimbs(), "none"),
        ({"three-quarter": 0.5, "long": 0.4}, BareLimbs(), "long"),
    ],
)
@pytest.mark.parametrize("street", [True, False])
def test_sleeves_agree_with_arms(read, limbs, told, street):
    before = answers(UPPER, "sleeves", read)
    found = with_signs(before, WornSigns(limbs), UPPER, street=street)
    assert likeliest(found, UPPER, "sleeves") == told
    assert sum(said(found, UPPER, "sleeves").values()) == pytest.approx(1, abs=0.03)
    others = [k for k, (claim, _) in enumerate(LABELS) if claim != "sleeves"]
    assert (found["statements"][:, others] == before["statements"][:, others]).all()
    assert (found["statements"][LOWER] == before["statements"][LOWER]).all()


def test_one_sleeve_alone_stays_what_it_is():
    before = answers(UPPER, "sleeves", {"left only": 0.9, "long": 0.05})
    found = with_signs(before, WornSigns(BareLimbs(forearms=-3)), UPPER, street=True)
    assert likeliest(found, UPPER, "sleeves") == "left only"
    assert said(found, UPPER, "sleeves")["long"] == pytest.approx(0.1, abs=0.02)


@pytest.mark.parametrize(
    ("read", "shins", "seen", "told"),
    [
        ({"skirt": 0.6, "trousers": 0.4}, -2.0, {}, "trousers"),
        ({"trousers": 0.6, "shorts": 0.4}, 2.0, {}, "shorts"),
        ({"skirt": 0.9, "trousers": 0.1}, 0.0, {}, "skirt"),
        ({"skirt": 0.7, "trousers": 0.3}, 0.0, {"trousers": 0.9, "skirt": 0.05, "shorts": 0.05}, "trousers"),
        ({"skirt": 0.7, "trousers": 0.3}, 0.0, {"trousers": 0.4, "skirt": 0.3, "shorts": 0.3}, "skirt"),
    ],
)
def test_kinds_agree_with_shins_and_with_what_photographs_look_like(read, shins, seen, told):
    before = answers(LOWER, "kind", read)
    signs = WornSigns(BareLimbs(shins=shins), {"kind": logs(seen)} if seen else {})
    found = with_signs(before, signs, LOWER, street=True)
    assert likeliest(found, LOWER, "kind") == told
    assert (found["statements"][UPPER] == before["statements"][UPPER]).all()


@pytest.mark.parametrize(
    ("read", "collared", "street", "told"),
    [
        ({"none": 0.8, "lapel": 0.15}, 0.9, True, "lapel"),
        ({"none": 0.8, "lapel": 0.15}, 0.3, True, "none"),
        ({"stand": 0.9, "none": 0.1}, 0.9, False, "stand"),
        ({"lapel": 0.6, "none": 0.4}, 0.1, False, "none"),
    ],
)
def test_collars_are_there_where_photographs_look_so(read, collared, street, told):
    shares = {"none": 1 - collared, COLLARED: collared}
    signs = WornSigns(told={"collar": logs(shares)})
    found = with_signs(answers(UPPER, "collar", read), signs, UPPER, street=street)
    assert likeliest(found, UPPER, "collar") == told


def test_hems_of_legs_agree_with_what_photographs_look_like():
    words = [word for claim, word in LABELS if claim == "leg_hem"]
    shares = dict.fromkeys(words, 0.01) | {"full": 1 - 0.01 * (len(words) - 1)}
    before = answers(LOWER, "leg_hem", {"ankle": 0.6, "full": 0.3})
    found = with_signs(before, WornSigns(told={"leg_hem": logs(shares)}), LOWER, street=True)
    assert likeliest(found, LOWER, "leg_hem") == "full" and likeliest(before, LOWER, "leg_hem") == "ankle"
    assert likeliest(with_signs(before, WornSigns(), LOWER, street=True), LOWER, "leg_hem") == "ankle"


def test_legs_in_a_street_are_mostly_straight():
    read = {"slim": 0.6, "tapered": 0.2, "straight": 0.1}
    before = answers(LOWER, "legs", read)
    found = with_signs(before, WornSigns(), LOWER, street=True)
    assert likeliest(found, LOWER, "legs") == "straight"
    assert sum(said(found, LOWER, "legs").values()) == pytest.approx(0.9, abs=0.03)
    assert likeliest(with_signs(before, WornSigns(), LOWER, street=False), LOWER, "legs") == "slim"
    sure = answers(LOWER, "legs", {"wide": 0.97})
    assert likeliest(with_signs(sure, WornSigns(), LOWER, street=True), LOWER, "legs") == "wide"


def test_a_skirt_gets_no_legs():
    found = with_signs(answers(LOWER, "kind", {"skirt": 0.95}), WornSigns(), LOWER, street=True)
    assert sum(said(found, LOWER, "legs").values()) < 0.05


def test_clothes_in_a_street_are_mostly_easy():
    for part, read in ((UPPER, {"loose": 0.6, "easy": 0.2}), (LOWER, {"close": 0.6, "easy": 0.3})):
        found = with_signs(answers(part, "fit", read), WornSigns(), part, street=True)
        assert likeliest(found, part, "fit") == "easy"


def test_who_shows_legs_wears_something_on_them():
    top = answers(UPPER, "kind", {"top": 0.9})
    dress = answers(UPPER, "kind", {"dress": 0.95})
    unsure, sure = ({"present": np.full(len(PARTS), logit)} for logit in (-0.5, 3.0))
    assert worn_below(top, unsure, SEEN) > 0
    assert worn_below(top, sure, BareLimbs(knees_seen=0.02, hips_seen=0.05)) < 0
    assert worn_below(dress, unsure, SEEN) < worn_below(top, unsure, SEEN) < worn_below(top, sure, SEEN)
    assert worn_below(top, None, SEEN) < worn_below(top, unsure, SEEN)
