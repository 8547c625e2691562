"""Where princess seams run in front, darts are not drawn beside them."""

from __future__ import annotations

from dataclasses import replace

from swifttailor.garment.princess_lines import seams_in_princess_seams
from swifttailor.pattern.drafts import draft


def test_darts_in_front():
    plain = draft("skater-dress")
    assert not seams_in_princess_seams(plain)
    pattern = replace(plain, trims=("princess seams",))
    found = [pattern.stitches[k] for k in seams_in_princess_seams(pattern)]
    assert {side.panel for stitch in found for side in stitch.sides} == {"left_ftorso", "right_ftorso"}
    assert all(len({side.panel for side in stitch.sides}) == 1 for stitch in found)


def test_panels_from_shoulder_to_hem_hide_the_waist_seam_and_all_darts():
    pattern = replace(draft("skater-dress"), trims=("princess panels",))
    found = [pattern.stitches[k] for k in seams_in_princess_seams(pattern)]
    panels = {frozenset(side.panel for side in stitch.sides) for stitch in found}
    assert frozenset({"skirt_front", "left_ftorso"}) in panels
    assert frozenset({"left_btorso"}) in panels
    assert frozenset({"left_ftorso", "left_btorso"}) not in panels
