"""Skirts whose name means a round one, where a text asks for a close one."""

from __future__ import annotations

import pytest

from swifttailor.describing.claims import Claim
from swifttailor.pattern.drafts.draft_names import NamedDraft
from swifttailor.wishes.drafts.close_skirts import close_skirt_as_asked

CLOSE, A_LINE, FLARED = Claim("hips", "close"), Claim("skirt", "a-line"), Claim("skirt", "flared")


@pytest.mark.parametrize(
    ("told", "said", "wanted"),
    [
        ([CLOSE], [CLOSE], "fitted-skirt(length=42;flare=-2;hip_ease=3)"),
        ([CLOSE, A_LINE], [CLOSE, A_LINE], "fitted-skirt(length=42;flare=6;hip_ease=3)"),
        ([CLOSE, A_LINE], [CLOSE], "fitted-skirt(length=42;flare=-2;hip_ease=3)"),
        ([CLOSE, FLARED], [CLOSE, FLARED], "circle-skirt(fraction=0.3;length=42)"),
        ([CLOSE, Claim("hem_shape", "pointed")], [CLOSE], "circle-skirt(fraction=0.3;length=42)"),
        ([A_LINE], [A_LINE], "circle-skirt(fraction=0.3;length=42)"),
    ],
)
def test_a_fitted_denim_skirt_is_straight(told, said, wanted):
    draft = NamedDraft.parse("circle-skirt(fraction=0.3;length=42)")
    assert close_skirt_as_asked(draft, told, said) == NamedDraft.parse(wanted)


def test_what_sits_on_the_hips_stays():
    low = NamedDraft.parse("circle-skirt(length=40;below_waist=14)")
    assert close_skirt_as_asked(low, [CLOSE], [CLOSE]) == low
