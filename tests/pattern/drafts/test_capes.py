"""Capes that are short and closed far down."""

from __future__ import annotations

import pytest
from draft_checks import assert_sound
from test_cut import seam_length

from swifttailor.pattern.drafts import DraftMeasurements, draft
from swifttailor.pattern.drafts.draft_names import NamedDraft


@pytest.mark.parametrize("opening", [0.0, 8.0])
def test_a_short_cape_is_never_closed_beyond_its_hem(opening):
    cape = draft("cape", length=-20.0, closed=60.0, opening=opening)
    assert_sound(cape)
    longer = draft("cape", length=55.0, closed=30.0, opening=opening)
    assert_sound(longer)


def test_a_narrow_short_cape_opens_less():
    assert_sound(draft("cape", length=-20.0, spread=65.0, neck_widening=1.0, opening=14.0))


def test_a_neckline_ends_above_the_hem_of_a_short_cape():
    short = DraftMeasurements(waist_line=33.0)
    assert_sound(draft("cape", measurements=short, length=-20.0, neck_depth=14.0))


def test_a_closed_cape_is_a_poncho():
    """Sewn together in front, and of what is open in front it shows nothing."""
    opened, closed = (draft("cape", length=20.0, front=front) for front in ("open", "closed"))
    assert_sound(closed)
    front, short = (seam_length(p, "left_ftorso", "right_ftorso")[0] for p in (closed, opened))
    assert front > 40.0 > short
    names = [NamedDraft("cape", (("front", front),)).shows for front in ("open", "closed")]
    assert names == [("cape", "open_front"), ("cape",)]


@pytest.mark.parametrize("collar", ["shirt", "flat", "standing", "rolled"])
def test_a_cape_coat_is_closed_down_the_front_and_has_a_collar(collar):
    cape = draft("cape", length=60.0, closed=90.0, opening=4.0, collar=collar, collar_width=7.0)
    assert_sound(cape)
    assert seam_length(cape, "left_ftorso", "right_ftorso")[0] > 80.0
    assert any("collar" in panel.name for panel in cape.panels)


def test_a_hood_takes_the_place_of_a_collar():
    hooded = draft("cape", hood=True, collar="flat")
    assert_sound(hooded)
    assert not any("collar" in panel.name for panel in hooded.panels)
