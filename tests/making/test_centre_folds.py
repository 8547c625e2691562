"""Straight seams in the middle can be cut on the fold; nothing else of the pattern changes."""

from __future__ import annotations

from dataclasses import replace

import pytest
import shapely

from swifttailor.making import cutting_plan
from swifttailor.making.centre_folds import fold_centres
from swifttailor.making.notch_check import notch_faults
from swifttailor.making.overlaps import allowance_faults
from swifttailor.pattern import check_pattern
from swifttailor.pattern.drafts import draft


def world_points(pattern) -> shapely.MultiPoint:
    return shapely.MultiPoint(
        [p for panel in pattern.panels for p in panel.to_world(panel.outline(0.1)).tolist()]
    )


@pytest.mark.parametrize(("front", "back"), [(True, False), (False, True), (True, True)])
def test_a_shirt_has_its_front_on_the_fold(front, back):
    shirt = draft("t-shirt").canonical()
    folded = fold_centres(shirt, front=front, back=back)
    seams = front + back
    assert len(folded.panels) == len(shirt.panels) - seams
    assert len(folded.stitches) == len(shirt.stitches) - seams
    assert sum(abs(p.signed_area()) for p in folded.panels) == pytest.approx(
        sum(abs(p.signed_area()) for p in shirt.panels)
    )
    instructions = {p.name: p.instruction for p in cutting_plan(folded).pieces}
    assert instructions["Bodice front"] == ("Cut 1 on the fold" if front else "Cut 2, mirrored")
    assert instructions["Bodice back"] == ("Cut 1 on the fold" if back else "Cut 2, mirrored")


def test_every_seam_keeps_its_lengths_and_its_place(shipped_patterns):
    joined = 0
    for pattern in shipped_patterns.values():
        pattern = pattern.canonical()
        folded = fold_centres(pattern, front=True, back=True)
        if folded == pattern:  # the same as other tests of cutting plans look at
            continue
        joined += len(pattern.panels) - len(folded.panels)

        def lengths(p):
            return sorted(tuple(sorted(round(p.edge_length(r), 6) for r in s.sides)) for s in p.stitches)

        kept, before_it = lengths(folded), lengths(pattern)
        assert all(pair in before_it for pair in kept)
        assert len(kept) == len(pattern.stitches) - (len(pattern.panels) - len(folded.panels))
        assert shapely.hausdorff_distance(world_points(pattern), world_points(folded)) < 0.5
        before = {f.code for f in check_pattern(pattern) if f.severity.value == "error"}
        assert {f.code for f in check_pattern(folded) if f.severity.value == "error"} <= before
        plan = cutting_plan(folded)
        assert notch_faults(plan) == []
        assert not any(allowance_faults(p.runs, p.cut) for p in plan.pieces)
    assert joined >= 8


def test_other_seams_stay(skirt):
    assert fold_centres(skirt, front=True, back=True) == skirt.canonical()
    trousers = draft("trousers").canonical()
    assert fold_centres(trousers, front=True, back=True) == trousers  # crotch seams are curved


def test_halves_that_differ_keep_their_seam():
    shirt = draft("t-shirt").canonical()
    index = next(k for k, p in enumerate(shirt.panels) if "ftorso" in p.name or "front" in p.name)
    panel = shirt.panels[index]
    corners = panel.vertices.copy()
    far = abs(corners[:, 0]).argmax()
    corners[far, 0] *= 1.05
    other = replace(
        shirt,
        panels=tuple(replace(p, vertices=corners) if k == index else p for k, p in enumerate(shirt.panels)),
    )
    assert len(fold_centres(other, front=True, back=False).panels) == len(other.panels)
