from __future__ import annotations

from dataclasses import replace

import swifttailor
from swifttailor.pattern import Edge, EdgeRef, Panel, Pattern, Placement, Severity, Stitch, check_pattern
from swifttailor.pattern.tidying.mending import mend


def test_a_seam_that_cannot_be_is_left_open():
    """The bottom of a square of cloth, and a corner cut off another."""
    corners = [[0, 0], [40, 0], [40, 30], [0, 30]], [[0, 0], [0, 29.5], [0.5, 30], [40, 30], [40, 0]]
    front, back = (
        Panel(name, at, tuple(Edge() for _ in at), Placement((0, 0, z)))
        for name, at, z in zip(("front", "back"), corners, (20, -20), strict=True)
    )
    sides = Stitch(EdgeRef("front", 1), EdgeRef("back", 3)), Stitch(EdgeRef("front", 3), EdgeRef("back", 0))
    slip = Stitch(EdgeRef("front", 0), EdgeRef("back", 1))
    wrong = Pattern((front, back), (sides[0], slip, sides[1]))
    errors = [f for f in check_pattern(wrong) if f.severity is Severity.ERROR]
    assert [(f.code, f.stitch) for f in errors] == [("uneven-seam", 1)]
    repair = mend(wrong)
    assert {frozenset(s.sides) for s in repair.pattern.stitches} == {frozenset(s.sides) for s in sides}
    assert (repair.changes[0].code, repair.changes[0].stitch) == ("uneven-seam", 1)
    assert not [f for f in repair.remaining if f.severity is Severity.ERROR]


def test_what_is_sound_stays():
    sound = swifttailor.draft("shirt-dress")
    assert mend(sound).pattern == sound
    assert mend(sound).changes == ()


def test_what_is_sewn_to_nothing_of_the_garment_is_left_out():
    whole = swifttailor.draft("hoodie")
    hood = {p.name for p in whole.panels if "hood" in p.name}
    loose = tuple(s for s in whole.stitches if len({side.panel in hood for side in s.sides}) == 1)
    repair = mend(replace(whole, stitches=loose))
    assert {p.name for p in repair.pattern.panels} == {p.name for p in whole.panels} - hood
    assert {c.panel for c in repair.changes} == hood
    assert {c.code for c in repair.changes} == {"disconnected"}
    assert len(repair.pattern.components()) == 1
    assert not [f for f in repair.remaining if f.code == "disconnected"]


def test_two_halves_of_a_garment_both_stay():
    whole = swifttailor.draft("t-shirt")
    across = {("left", "right"), ("right", "left")}
    halves = tuple(
        s for s in whole.stitches if tuple(side.panel.split("_")[0] for side in s.sides) not in across
    )
    apart = replace(whole, stitches=halves)
    assert len(apart.components()) == 2
    assert mend(apart).pattern.panels == apart.panels
