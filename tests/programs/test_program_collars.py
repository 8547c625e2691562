"""Collars with panels: turtleneck, lapel, hood."""

from __future__ import annotations

import pytest

from swifttailor.pattern import Pattern
from swifttailor.programs import make_pattern
from swifttailor.programs.necklines import NECKLINES


def shirt(**values) -> Pattern:
    """A sleeveless shirt; the values are those of ``collar``."""
    return make_pattern({"meta.upper": "Shirt", **{f"collar.{name}": v for name, v in values.items()}})


def names(pattern: Pattern) -> set[str]:
    return {p.name for p in pattern.panels if "torso" not in p.name}


def seam(pattern: Pattern, one: str, other: str) -> list[tuple[float, float]]:
    """Lengths on both sides of each stitch between two panels."""
    found = []
    for stitch in pattern.stitches:
        sides = {side.panel: side for side in stitch.sides}
        if sides.keys() == {one, other}:
            found.append((pattern.edge_length(sides[one]), pattern.edge_length(sides[other])))
    return found


@pytest.mark.parametrize("front", NECKLINES)
@pytest.mark.parametrize("back", ["CircleNeckHalf", "SquareNeckHalf"])
def test_necklines_alone_add_no_panels_and_are_labelled(front, back):
    pattern = shirt(f_collar=front, b_collar=back, bc_depth=0.5)
    assert names(pattern) == set()
    for panel in pattern.panels:
        labels = {edge.label for edge in panel.edges}
        assert f"{panel.name.split('_')[0]}_collar" in labels


def test_a_wider_neckline_leaves_less_of_the_shoulder():
    shoulders = []
    for width in (-0.5, -0.2, 0.0, 0.4, 1.0):
        sides_and_shoulder = seam(shirt(width=width), "right_ftorso", "right_btorso")
        shoulders.append(min(sides_and_shoulder)[0])
    assert shoulders == sorted(shoulders, reverse=True)
    assert shoulders[0] - shoulders[-1] > 8


@pytest.mark.parametrize("side", ["right", "left"])
def test_a_turtleneck_is_as_long_as_the_neckline(side):
    pattern = shirt(**{"component.style": "Turtle", "component.depth": 6, "bc_depth": 0.3})
    assert names(pattern) == {f"{s}_collar_{p}" for s in ("left", "right") for p in ("front", "back")}
    for torso, collar in (("ftorso", "front"), ("btorso", "back")):
        pairs = seam(pattern, f"{side}_{torso}", f"{side}_collar_{collar}")
        assert sum(a for a, _ in pairs) == pytest.approx(sum(b for _, b in pairs), abs=0.05)


def test_the_halves_of_a_turtleneck_meet_in_front_and_behind():
    pattern = shirt(**{"component.style": "Turtle"})
    for part in ("front", "back"):
        ((one, other),) = seam(pattern, f"right_collar_{part}", f"left_collar_{part}")
        assert one == pytest.approx(other)


@pytest.mark.parametrize("standing", [True, False])
def test_a_lapel_lies_on_the_bodice_with_its_wrong_side(standing):
    pattern = shirt(**{"component.style": "SimpleLapel", "component.lapel_standing": standing})
    sewn = {frozenset(side.panel for side in stitch.sides): stitch.right_wrong for stitch in pattern.stitches}
    assert sewn[frozenset({"right_ftorso", "right_collar_front"})]
    assert sewn[frozenset({"right_btorso", "right_collar_back"})] is not standing
    assert sewn[frozenset({"right_collar_front", "right_collar_back"})] is standing
    assert not seam(pattern, "right_collar_front", "left_collar_front"), "a lapel is open in front"
    assert seam(pattern, "right_collar_back", "left_collar_back")


def test_a_lying_lapel_is_curved_and_turned_to_lie():
    panel = shirt(**{"component.style": "SimpleLapel", "component.lapel_standing": False}).panel(
        "right_collar_back"
    )
    assert sum(type(e.curve).__name__ == "Arc" for e in panel.edges) == 2
    assert panel.placement.rotation[0] == pytest.approx(90)


def test_a_hood_is_closed_behind_and_as_long_as_the_neckline():
    pattern = shirt(**{"component.style": "Hood2Panels", "bc_depth": 0.2})
    assert names(pattern) == {"right_hood", "left_hood"}
    assert len(seam(pattern, "right_hood", "left_hood")) == 2
    for torso in ("ftorso", "btorso"):
        for one, other in seam(pattern, f"right_{torso}", "right_hood"):
            assert one == pytest.approx(other, rel=0.05)


@pytest.mark.parametrize("name", ["hood_length", "hood_depth"])
def test_a_hood_grows_with_its_parameters(name):
    low, high = (
        shirt(**{"component.style": "Hood2Panels", f"component.{name}": v}).panel("right_hood")
        for v in (1.0, 1.5)
    )
    assert abs(high.signed_area()) > 1.05 * abs(low.signed_area())
