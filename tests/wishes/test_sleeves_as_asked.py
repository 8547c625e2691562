"""Drafts with the sleeves and cuffs that a text asks for."""

from __future__ import annotations

import pytest

import swifttailor
from swifttailor.describing.claims import Claim
from swifttailor.pattern.drafts.draft_names import NamedDraft
from swifttailor.wishes.drafts.said_details import with_details
from swifttailor.wishes.drafts.sleeved_drafts import sleeves_as_asked


@pytest.mark.parametrize(
    ("draft", "claims", "options"),
    [
        ("coat", {"sleeves": "extra-long"}, {"sleeve_length": 71.0}),
        ("hooded-coat", {"sleeves": "extra-long"}, {"sleeve_length": 71.0}),
        ("shirt", {"cuffs": "deep"}, {"cuffs": True, "cuff_height": 14.0}),
        ("shirt-dress", {"cuffs": "deep"}, {"cuffs": True, "cuff_height": 14.0}),
        ("skater-dress", {"sleeves": "long", "sleeve_shape": "slim"}, {"sleeves": True, "sleeve_end": 20.0}),
        ("t-shirt", {"sleeve_shape": "slim"}, {"arm_ease": 3.5, "sleeve_end": 30.0}),
        ("skater-dress", {"sleeve_shape": "slim"}, {}),
        ("t-shirt", {"cuffs": "deep"}, {}),
        ("t-shirt", {"sleeves": "long"}, {"sleeve_length": 60.0, "sleeve_end": 24.0}),
        ("t-shirt", {"sleeves": "three-quarter"}, {"sleeve_length": 41.0, "sleeve_end": 28.0}),
        ("t-shirt", {"sleeves": "short"}, {}),
        (
            "skater-dress",
            {"sleeves": "left only", "left_sleeve": "long"},
            {"sleeves": True, "sleeve_length": 60.0},
        ),
        ("t-shirt", {"cuffs": "flounce"}, {"sleeve_shape": "flounced", "sleeve_length": 60.0}),
        (
            "skater-dress",
            {"cuffs": "flounce", "sleeves": "short"},
            {"sleeve_shape": "flounced", "sleeve_length": 22.0},
        ),
        ("sweatshirt", {"sleeve_shape": "balloon"}, {"sleeve_shape": "balloon"}),
        ("shift-dress", {"sleeves": "long", "sleeve_shape": "wide"}, {"sleeve_shape": "wide"}),
        ("shift-dress", {"sleeves": "elbow", "sleeve_shape": "wide"}, {"sleeve_shape": "plain"}),
    ],
)
def test_sleeves_are_as_long_slim_and_cuffed_as_asked(draft, claims, options):
    asked = sleeves_as_asked(NamedDraft(draft), [Claim(name, value) for name, value in claims.items()])
    found = dict(asked.options)
    assert options.items() <= found.items() and bool(options) == bool(found)


def test_sleeves_of_shirts_trail_without_cuffs():
    asked = with_details(NamedDraft("shirt"), ("trailing_sleeves",), ())
    assert {("sleeve_shape", "trailing"), ("cuffs", False)} <= set(asked.options)
    assert "sleeves" not in dict(asked.options)


@pytest.mark.parametrize("length", [12.0, 20.0, 60.0])
def test_deep_cuffs_leave_something_of_a_sleeve(length):
    pattern = swifttailor.draft("shirt", sleeve_length=length, cuff_height=16.0)
    assert {"left_sleeve_f", "sl_left_cuff_f"} <= {panel.name for panel in pattern.panels}
