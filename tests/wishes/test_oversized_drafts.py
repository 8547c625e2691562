"""Tops that are to be far too wide are long and have dropped shoulders, too."""

from __future__ import annotations

import pytest

from swifttailor.describing.claims import Claim
from swifttailor.pattern.drafts import draft
from swifttailor.pattern.drafts.draft_names import NamedDraft
from swifttailor.wishes.drafts.oversized_drafts import oversized_as_asked

OVERSIZED = Claim("fit", "oversized")


@pytest.mark.parametrize(
    "name", ["t-shirt", "shirt", "cardigan", "sweatshirt", "hoodie", "turtleneck", "polo-shirt", "tank-top"]
)
def test_they_are_wide_and_long_and_can_be_drafted(name):
    made = oversized_as_asked(NamedDraft(name), [OVERSIZED])
    options = dict(made.options)
    assert options["chest_ease"] >= 24.0 and options["length"] >= 30.0
    assert draft(name, **options).panels


def test_sleeves_end_where_they_did():
    options = dict(oversized_as_asked(NamedDraft("shirt"), [OVERSIZED]).options)
    assert options["shoulder_extension"] == 8.0 and options["sleeve_length"] < 60.0
    tee = oversized_as_asked(NamedDraft("t-shirt"), [OVERSIZED, Claim("sleeves", "long")])
    assert dict(tee.options)["sleeve_length"] > 50.0 and dict(tee.options)["sleeve_end"] < 35.0


def test_sleeves_that_are_called_short_do_not_reach_the_elbow():
    tee = NamedDraft("t-shirt", (("sleeve_length", 30.0),))
    made = [oversized_as_asked(tee, [OVERSIZED, Claim("sleeves", word)]) for word in ("short", "elbow")]
    assert [dict(one.options)["sleeve_length"] for one in made] == [26.0, 30.0]


def test_a_length_that_is_told_stays():
    cropped = NamedDraft("t-shirt", (("length", -4.0),))
    made = oversized_as_asked(cropped, [OVERSIZED, Claim("top_hem", "cropped")])
    assert dict(made.options)["length"] == -4.0


def test_coats_and_others_stay_as_they_are():
    coat = NamedDraft("hooded-coat", (("opening", 1.0),))
    assert oversized_as_asked(coat, [OVERSIZED]) == coat
    assert oversized_as_asked(NamedDraft("t-shirt"), []) == NamedDraft("t-shirt")
