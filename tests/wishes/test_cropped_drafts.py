"""Tops that end above the hips are drawn in at their hems."""

from __future__ import annotations

import pytest

from swifttailor import draft
from swifttailor.describing import Claim
from swifttailor.pattern.drafts.draft_names import NamedDraft
from swifttailor.wishes.drafts.cropped_drafts import cropped_as_asked

PUFFER = NamedDraft.parse("turtleneck(collar_height=7;rolled=false;chest_ease=24;sleeve_end=29;arm_ease=14)")


@pytest.mark.parametrize("hem", ["cropped", "waist", "high hip"])
def test_short_padded_jackets_have_a_band(hem):
    made = cropped_as_asked(PUFFER, [Claim("top_hem", hem)])
    assert made.name == "bomber-jacket" and dict(made.options)["arm_ease"] == 14.0
    assert "wb_back" in {panel.name for panel in draft(made.name, **dict(made.options)).panels}


@pytest.mark.parametrize(
    ("named", "claims"),
    [
        (PUFFER, [Claim("top_hem", "hip")]),
        (PUFFER, [Claim("top_hem", "cropped"), Claim("sleeves", "none")]),
        (NamedDraft.parse("turtleneck(chest_ease=24)"), [Claim("top_hem", "cropped")]),
        (NamedDraft.parse("turtleneck(rolled=false;chest_ease=5)"), [Claim("top_hem", "cropped")]),
    ],
)
def test_others_have_none(named, claims):
    assert cropped_as_asked(named, claims).name == "turtleneck"


@pytest.mark.parametrize("length", [-8.0, -4.0, -1.0])
def test_camisoles_lie_on_the_ribs(length):
    """Darts take in what hangs from the bust; wide hems and cloth that stretches have none."""

    def corners(**options):
        return [len(draft("camisole", **options).panel(f"left_{side}torso").edges) for side in "fb"]

    plain = corners(length=1.0)
    assert corners(length=length) == [count + 3 for count in plain]
    assert corners(length=length, flare=12.0) == corners(length=length, stretch=12.0) == plain


def test_cropped_camisoles_are_close_at_the_bust():
    made = cropped_as_asked(NamedDraft("camisole"), [Claim("top_hem", "cropped")])
    assert made.options == (("length", -4.0),)


@pytest.mark.parametrize(("hem", "length"), [("cropped", 4.0), ("waist", 6.0)])
def test_short_cardigans_are_buttoned_to_the_hem(hem, length):
    made = dict(cropped_as_asked(NamedDraft("cardigan"), [Claim("top_hem", hem)]).options)
    assert (made["length"], made["opening"], made["closed_to"]) == (length, 0.0, 0.0)


@pytest.mark.parametrize("named", ["cardigan(length=-4;opening=8;closed_to=-30)", "cardigan(length=2)"])
def test_open_ones_and_shorter_ones_stay_as_they_are(named):
    draft_named = NamedDraft.parse(named)
    assert cropped_as_asked(draft_named, [Claim("top_hem", "cropped")]) == draft_named


def test_short_jackets_on_a_standing_collar_are_shaped():
    """Else their backs hang like capes."""
    jacket = NamedDraft.parse("turtleneck(collar_height=4;rolled=false)")
    made = dict(cropped_as_asked(jacket, [Claim("top_hem", "cropped")]).options)
    assert (made["length"], made["waist_shaping"], made["chest_ease"]) == (-2.0, 3.0, 8.0)
    loose = dict(cropped_as_asked(jacket, [Claim("top_hem", "cropped"), Claim("fit", "loose")]).options)
    assert "waist_shaping" not in loose


def test_cropped_tops_off_the_shoulders_narrow_to_the_ribs():
    made = cropped_as_asked(NamedDraft("off-shoulder-top"), [Claim("top_hem", "cropped")])
    assert made.options == (("length", -4.0),)
    corners = draft(made.name, length=-4.0).panel("left_btorso").vertices
    low, high = corners[:, 1].min(), corners[:, 1].max()
    hem = corners[corners[:, 1] < low + 2.0, 0].max()
    assert hem < corners[corners[:, 1] < high, 0].max() - 1.0
