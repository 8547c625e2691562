"""Of a double-breasted front the middle is no edge."""

from __future__ import annotations

from dataclasses import replace

import pytest

from swifttailor.garment.double_breasted import seams_under_a_front
from swifttailor.pattern.drafts import draft


@pytest.mark.parametrize(("trim", "many"), [("double-breasted buttons", True), ("buttons", False)])
def test_the_seam_in_the_middle_lies_under_a_front(trim, many):
    pattern = replace(draft("coat"), trims=(trim,))
    found = [pattern.stitches[k] for k in seams_under_a_front(pattern)]
    assert bool(found) is many
    assert all({side.panel for side in s.sides} == {"left_ftorso", "right_ftorso"} for s in found)
