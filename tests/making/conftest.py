from __future__ import annotations

import pytest

from swifttailor.making import CuttingPlan, cutting_plan
from swifttailor.pattern import Edge, EdgeRef, Panel, Pattern, Placement, Stitch


def rectangle(name: str, width: float, height: float, z: float, x: float = 0.0) -> Panel:
    """A panel before or behind the body, its right side facing outward."""
    corners = [[-width / 2, 0.0], [width / 2, 0.0], [width / 2, height], [-width / 2, height]]
    return Panel(name, corners if z > 0 else corners[::-1], (Edge(),) * 4, Placement((x, 60.0, z)))


@pytest.fixture(scope="session")
def skirt() -> Pattern:
    """Two rectangles of 50 x 45 cm, sewn along both sides: hem below, open edge above."""
    front, back = rectangle("skirt_front", 50.0, 45.0, 20.0), rectangle("skirt_back", 50.0, 45.0, -20.0)
    sides = (
        Stitch(EdgeRef("skirt_front", 1), EdgeRef("skirt_back", 1)),
        Stitch(EdgeRef("skirt_front", 3), EdgeRef("skirt_back", 3)),
    )
    return Pattern((front, back), sides, "two rectangles")


@pytest.fixture(scope="session")
def shipped_plans(shipped_patterns) -> dict[str, CuttingPlan]:
    """Of the 20 real patterns beside the tests."""
    return {name: cutting_plan(pattern) for name, pattern in shipped_patterns.items()}


@pytest.fixture(scope="session")
def draft_plans(drafts) -> dict[str, CuttingPlan]:
    return {name: cutting_plan(pattern) for name, pattern in drafts.items()}


@pytest.fixture(scope="session")
def plans(shipped_plans, draft_plans) -> dict[str, CuttingPlan]:
    return shipped_plans | draft_plans
