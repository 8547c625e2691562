"""What limbs tell joins what a network says of sleeves, of kinds, and of whether anything is worn below."""

from __future__ import annotations

import numpy as np
import pytest

from swifttailor.picture_reader.bare_limbs import BareLimbs
from swifttailor.picture_reader.labels import PARTS, statement_labels
from swifttailor.picture_reader.person_halves import LOWER, UPPER
from swifttailor.picture_reader.said import share_of
from swifttailor.picture_reader.told_by_limbs import with_limbs, worn_below

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
    found = with_limbs(before, limbs, UPPER, street=street)
    assert likeliest(found, UPPER, "sleeves") == told
    assert sum(said(found, UPPER, "sleeves").values()) == pytest.approx(1, abs=0.03)
    others = [k for k, (claim, _) in enumerate(LABELS) if claim != "sleeves"]
    assert (found["statements"][:, others] == before["statements"][:, others]).all()
    assert (found["statements"][LOWER] == before["statements"][LOWER]).all()


@pytest.mark.parametrize(
    ("read", "shins", "told"),
    [
        ({"skirt": 0.6, "trousers": 0.4}, -2.0, "trousers"),
        ({"trousers": 0.6, "shorts": 0.4}, 2.0, "shorts"),
        ({"skirt": 0.9, "trousers": 0.1}, 0.0, "skirt"),
    ],
)
def test_kinds_agree_with_shins_in_a_street(read, shins, told):
    before = answers(LOWER, "kind", read)
    found = with_limbs(before, BareLimbs(shins=shins), LOWER, street=True)
    assert likeliest(found, LOWER, "kind") == told
    assert with_limbs(before, BareLimbs(shins=shins), LOWER, street=False) is before


def test_who_shows_legs_wears_something_on_them():
    top = answers(UPPER, "kind", {"top": 0.9})
    dress = answers(UPPER, "kind", {"dress": 0.95})
    unsure, sure = ({"present": np.full(len(PARTS), logit)} for logit in (-0.5, 3.0))
    assert worn_below(top, unsure, SEEN) > 0
    assert worn_below(top, sure, BareLimbs(knees_seen=0.02, hips_seen=0.05)) < 0
    assert worn_below(dress, unsure, SEEN) < worn_below(top, unsure, SEEN) < worn_below(top, sure, SEEN)
    assert worn_below(top, None, SEEN) < worn_below(top, unsure, SEEN)
