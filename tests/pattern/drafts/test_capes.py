"""Capes that are short and closed far down."""

from __future__ import annotations

import pytest
from draft_checks import assert_sound

from swifttailor.pattern.drafts import draft


@pytest.mark.parametrize("opening", [0.0, 8.0])
def test_a_short_cape_is_never_closed_beyond_its_hem(opening):
    cape = draft("cape", length=-20.0, closed=60.0, opening=opening)
    assert_sound(cape)
    longer = draft("cape", length=55.0, closed=30.0, opening=opening)
    assert_sound(longer)
