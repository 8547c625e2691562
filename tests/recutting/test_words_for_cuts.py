"""What a cut is called in notes and reports."""

from __future__ import annotations

import pytest

from swifttailor.recutting.levers.all_levers import LEVERS


@pytest.mark.parametrize(
    ("lever", "was", "now", "said"),
    [
        ("sleeves", 20.0, 58.04, "sleeves 38.0 cm longer"),
        ("sleeves", 58.0, 20.0, "sleeves 38.0 cm shorter"),
        ("sleeve heads", 1.0, 1.46, "sleeve heads more gathered: from 1.00 to 1.46 times the seam"),
        ("sleeve heads", 1.46, 1.0, "sleeve heads less gathered: from 1.46 to 1.00 times the seam"),
        ("tiers", 2.0, 3.0, "tiers: 1 more"),
        ("godets let in", None, 6.0, "godets let in, 6"),
        ("sleeves sewn on", None, 58.0, "sleeves sewn on, 58.0 cm"),
    ],
)
def test_what_was_done_in_words(lever, was, now, said):
    assert next(one for one in LEVERS if one.name == lever).said(was, now) == said
