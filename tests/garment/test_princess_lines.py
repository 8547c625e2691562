"""Where princess seams run in front, darts are not drawn beside them."""

from __future__ import annotations

from dataclasses import replace

from swifttailor.garment.princess_lines import darts_in_princess_seams
from swifttailor.pattern.drafts import draft


def test_darts_in_princess_seams():
    plain = draft("skater-dress")
    assert not darts_in_princess_seams(plain)
    pattern = replace(plain, trims=("princess seams",))
    found = [pattern.stitches[k] for k in darts_in_princess_seams(pattern)]
    assert {side.panel for stitch in found for side in stitch.sides} == {"left_ftorso", "right_ftorso"}
    assert all(len({side.panel for side in stitch.sides}) == 1 for stitch in found)
