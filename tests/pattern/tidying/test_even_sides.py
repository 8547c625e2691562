"""What is nearly even of a written pattern is made exactly so."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import swifttailor
from swifttailor.pattern import Edge, EdgeRef, Panel, Pattern, Placement, Stitch
from swifttailor.pattern.drafts import list_drafts
from swifttailor.pattern.tidying.closed_slits import NARROWEST_CM, open_slits
from swifttailor.pattern.tidying.corner_slivers import without_corner_slivers
from swifttailor.pattern.tidying.even_seams import even_seams, hem_seams
from swifttailor.pattern.tidying.even_sides import even_sides
from swifttailor.pattern.tidying.mending import mend
from swifttailor.pattern.tidying.symmetry import OTHER_SIDE, distance, reflected, self_reflection


def uneven(pattern: Pattern, most: float, seed: int = 0) -> Pattern:
    """Every corner moved by up to so much, cm."""
    rng = np.random.default_rng(seed)
    panels = [
        replace(p, vertices=p.vertices + rng.uniform(-most, most, p.vertices.shape)) for p in pattern.panels
    ]
    return replace(pattern, panels=tuple(panels))


def lopsidedness(pattern: Pattern) -> float:
    """The farthest that a panel is from its reflection, cm."""
    found = []
    for panel in pattern.panels:
        other = OTHER_SIDE.get(panel.name)
        if other is None:
            own = self_reflection(panel)
            assert own is not None
            found.append(own.deviation)
        else:
            apart = distance(panel, reflected(pattern.panel(other), panel.name))
            assert apart is not None
            found.append(apart)
    return max(found)


@pytest.mark.parametrize("name", [draft.name for draft in list_drafts()])
def test_drafts_are_even_already(name):
    pattern = swifttailor.draft(name)
    # Of these, one front lies over the other or runs on to the other side, or pleats turn to one side.
    overlapping = name.startswith("wrap-") or name in (
        "sarong",
        "coat",
        "hooded-coat",
        "robe",
        "cardigan",
        "blazer",
    )
    one_sided = overlapping or name == "pleated-skirt"
    assert one_sided or lopsidedness(pattern) < 0.05
    for step in (even_sides, even_seams, open_slits, without_corner_slivers):
        after, changes = step(pattern)
        assert after is pattern
        assert changes == ()


@pytest.mark.parametrize("name", ["t-shirt", "fitted-dress", "trousers", "circle-skirt"])
def test_both_sides_become_their_mean(name):
    pattern = swifttailor.draft(name)
    before = uneven(pattern, 1.0)
    after, changes = even_sides(before)
    assert lopsidedness(before) > 0.5
    assert lopsidedness(after) < 1e-6
    assert {c.code for c in changes} == {"uneven-sides"}
    assert after.stitches == before.stitches
    # The mean of both is nearer to the truth than they are.
    off = [
        np.concatenate([a.panel(p.name).vertices - p.vertices for p in pattern.panels])
        for a in (before, after)
    ]
    assert (off[1] ** 2).mean() < 0.8 * (off[0] ** 2).mean()
    assert even_sides(after)[1] == ()


def test_what_is_plainly_different_stays():
    pattern = swifttailor.draft("t-shirt")
    left = pattern.panel("left_ftorso")
    longer = replace(left, vertices=left.vertices * [1.0, 1.3])
    other = replace(pattern, panels=tuple(longer if p.name == left.name else p for p in pattern.panels))
    assert even_sides(other) == (other, ())


def test_edits_are_not_evened():
    before = uneven(swifttailor.draft("t-shirt"), 0.4)
    assert not any(c.code.startswith("uneven-") for c in mend(before).changes)
    assert any(c.code == "uneven-sides" for c in mend(before, alike=True).changes)


def test_a_back_that_was_cut_longer_meets_the_front():
    pattern = swifttailor.draft("fitted-skirt")
    lowest = {p.name: p.vertices[:, 1].min() for p in pattern.panels}
    back = pattern.panel("skirt_back")
    vertices = back.vertices - np.where(
        back.vertices[:, 1:] < lowest[back.name] + 1.0, [0.0, 6.0], [0.0, 0.0]
    )
    longer = replace(
        pattern, panels=tuple(replace(p, vertices=vertices) if p is back else p for p in pattern.panels)
    )
    apart = [abs(a - b) for _, a, b in hem_seams(longer)]
    assert max(apart) > 5.0
    after, changes = even_seams(longer)
    assert max(abs(a - b) for _, a, b in hem_seams(after)) < 1e-6
    assert {c.code for c in changes} == {"uneven-hem"}
    # Both have come half the way, and nothing else of the panels has moved.
    moved = {p.name: np.abs(after.panel(p.name).vertices - p.vertices).max(axis=1) for p in longer.panels}
    assert max(moved["skirt_front"]) == pytest.approx(3.0, abs=0.3)
    assert [int((m > 1e-9).sum()) for m in moved.values()].count(2) == 2


def square_with(extra: list[list[float]]) -> Pattern:
    """A panel 40 cm wide and 60 long with more corners in its hem, both sides sewn to another."""
    corners = [[0.0, 0.0], *extra, [40.0, 0.0], [40.0, 60.0], [0.0, 60.0]]
    front = Panel("skirt_front", corners, tuple(Edge() for _ in corners), Placement((0, 0, 20)))
    back = Panel("skirt_back", [[0, 0], [40, 0], [40, 60], [0, 60]], tuple(Edge() for _ in range(4)))
    count = len(corners)
    right, left = EdgeRef("skirt_front", count - 3), EdgeRef("skirt_front", count - 1)
    seams = Stitch(right, EdgeRef("skirt_back", 3)), Stitch(left, EdgeRef("skirt_back", 1))
    return Pattern((front, back), seams)


def test_a_slit_without_width_is_opened():
    closed = square_with([[20.2, 0.0], [20.0, 15.0], [19.9, 0.0]])
    after, changes = open_slits(closed)
    mouth = after.panel("skirt_front").vertices[[1, 3], 0]
    assert mouth[1] - mouth[0] == pytest.approx(NARROWEST_CM)
    assert [c.code for c in changes] == ["closed-slit"]
    assert open_slits(after)[1] == ()
    open_one = square_with([[18.0, 0.0], [20.0, 15.0], [22.0, 0.0]])
    assert open_slits(open_one) == (open_one, ())


@pytest.mark.parametrize("at", ["right", "left"])
def test_a_sliver_between_seam_and_hem_is_left_out(at):
    extra = [[40.2, -1.9]] if at == "right" else [[-0.1, -1.5]]
    whole = square_with(extra)
    if at == "left":  # the loop begins with the sliver
        panel = whole.panel("skirt_front")
        assert np.linalg.norm(panel.vertices[1] - panel.vertices[0]) < 2.0
    after, changes = without_corner_slivers(whole)
    panel = after.panel("skirt_front")
    assert [c.code for c in changes] == ["corner-sliver"]
    assert len(panel.edges) == 4
    assert {tuple(extra[0])} <= {tuple(v) for v in panel.vertices}
    for stitch in after.stitches:  # the seams still run down the sides
        side = stitch.first if stitch.first.panel == "skirt_front" else stitch.second
        across, down = np.abs(np.diff(panel.chord(side.edge), axis=0))[0]
        assert down > 55.0
        assert across < 1.0
