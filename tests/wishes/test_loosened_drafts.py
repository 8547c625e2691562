"""Drafts that would cling, where room is asked for."""

from __future__ import annotations

import pytest

from swifttailor.describing.claims import Claim
from swifttailor.pattern.drafts.draft_names import NamedDraft
from swifttailor.wishes.drafts.loosened_drafts import is_to_be_loose, loosened_as_asked

EASY, LOOSE = Claim("fit", "easy"), Claim("fit", "loose")


@pytest.mark.parametrize(
    ("named", "claim", "wanted"),
    [
        ("turtleneck(stretch=4;chest_ease=3;waist_shaping=3)", EASY, "turtleneck(chest_ease=10)"),
        ("camisole(waist_shaping=2;chest_ease=20)", LOOSE, "camisole(chest_ease=20)"),
        (
            "fitted-dress(stretch=7;skirt_length=44;hip_ease=2)",
            LOOSE,
            "shift-dress(length=44;chest_ease=13;flare=24;neck_widening=1.5)",
        ),
        (
            "fitted-dress(stretch=7;sleeves=true)",
            LOOSE,
            "shift-dress(length=60;chest_ease=15;flare=24;neck_widening=1.5;sleeves=true)",
        ),
        ("jumpsuit(leg_ease=40)", LOOSE, "jumpsuit(leg_ease=40;bust_ease=16;waist_ease=14)"),
        ("jumpsuit(stretch=8)", LOOSE, "jumpsuit(stretch=8)"),
        ("turtleneck(chest_ease=8)", LOOSE, "turtleneck(chest_ease=8)"),
        ("fitted-dress(skirt_length=44)", LOOSE, "fitted-dress(skirt_length=44)"),
        ("leggings(stretch=8)", LOOSE, "leggings(stretch=8)"),
    ],
)
def test_what_would_cling_hangs_straight(named, claim, wanted):
    assert loosened_as_asked(NamedDraft.parse(named), [claim]) == NamedDraft.parse(wanted)


def test_close_ones_stay():
    draft = NamedDraft.parse("turtleneck(stretch=4;waist_shaping=3)")
    assert loosened_as_asked(draft, [Claim("fit", "close")]) == draft
    assert not is_to_be_loose([Claim("fit", "close")]) and is_to_be_loose([LOOSE])
