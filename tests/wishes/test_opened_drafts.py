"""Kaftans that are to open in front, and sleeves like wings."""

from __future__ import annotations

import pytest

from swifttailor.describing.claims import Claim
from swifttailor.pattern.drafts import draft
from swifttailor.pattern.drafts.draft_names import NamedDraft
from swifttailor.wishes.drafts.opened_drafts import opened_as_asked

BELL = Claim("sleeve_shape", "bell")


@pytest.mark.parametrize(
    ("named", "claims", "wanted", "begun"),
    [
        ("kaftan(length=90)", [], set(), "kaftan(length=90)"),
        (
            "kaftan(length=90;sleeve_length=58;neck_depth=9)",
            [],
            {"open_front"},
            "robe(length=90;sleeve_length=58;flare=20;opening=10;neck_depth=20;front_slit=70)",
        ),
        ("kaftan(sleeve_end=48)", [BELL], set(), "kaftan(sleeve_end=70;arm_ease=34)"),
        ("cape(length=60)", [], {"buttons"}, "cape(length=60;closed=90;opening=4)"),
        ("cape(front=closed)", [], {"buttons"}, "cape(front=closed)"),
        ("shirt", [BELL], {"open_front"}, "shirt"),
    ],
)
def test_they_are_robes_and_have_wings_where_asked(named, claims, wanted, begun):
    draft(NamedDraft.parse(begun).name, **dict(NamedDraft.parse(begun).options))
    found = opened_as_asked(NamedDraft.parse(named), claims, wanted)
    assert (found.name, dict(found.options)) == (
        NamedDraft.parse(begun).name,
        dict(NamedDraft.parse(begun).options),
    )
