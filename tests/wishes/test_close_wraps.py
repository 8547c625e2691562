"""Wrapped drafts that are to be close or straight."""

from __future__ import annotations

import pytest

from swifttailor.describing.claims import Claim
from swifttailor.pattern.drafts.draft_names import NamedDraft
from swifttailor.wishes.drafts.close_wraps import roomy_wrap_as_asked, wrapped_close_as_asked


@pytest.mark.parametrize(
    ("draft", "claims", "options"),
    [
        ("wrap-dress", [("fit", "close")], {"hip_ease": 4.0}),
        ("wrap-dress(hip_ease=2)", [("hips", "close")], {"hip_ease": 2.0}),
        ("wrap-dress", [("hips", "close"), ("skirt", "pencil")], {"hip_ease": 4.0, "skirt_flare": 2.0}),
        ("wrap-skirt(length=74)", [("skirt", "straight")], {"length": 74.0, "flare": 2.0}),
        ("wrap-skirt(fraction=0.5)", [("skirt", "straight")], {"fraction": 0.5}),
        ("wrap-dress", [("fit", "easy")], {}),
        ("fitted-dress", [("hips", "close")], {}),
    ],
)
def test_less_room_is_drafted_and_not_cut(draft, claims, options):
    asked = [Claim(name, value) for name, value in claims]
    assert dict(wrapped_close_as_asked(NamedDraft.parse(draft), asked).options) == options


@pytest.mark.parametrize(
    ("name", "claims", "never", "roomy"),
    [
        ("wrap-top", [Claim("fit", "loose")], [], True),
        ("wrap-top", [], [Claim("fit", "close")], True),
        ("wrap-top", [Claim("fit", "close")], [], False),
        ("wrap-dress", [], [Claim("fit", "close")], False),
    ],
)
def test_wrap_tops_have_room_where_close_ones_are_refused(name, claims, never, roomy):
    made = roomy_wrap_as_asked(NamedDraft(name), claims, never)
    assert ("chest_ease" in dict(made.options)) is roomy
