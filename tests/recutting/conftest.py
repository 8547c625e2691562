"""What every alteration must leave sound."""

from __future__ import annotations

import numpy as np
import pytest
from shapely.geometry import Polygon

from swifttailor.pattern import Pattern
from swifttailor.recutting.alter import Alteration
from swifttailor.recutting.table.cutter import Cutter


def _sound(before: Pattern, altered: Alteration) -> Cutter:
    """All wishes hold, panels are simple, the checker finds nothing new, what is symmetric stays so."""
    was, after = Cutter(before), Cutter(altered.pattern)
    assert altered.open == () and altered.cuts
    assert after.faults <= was.faults
    for panel in altered.pattern.panels:
        assert Polygon(panel.outline(0.05)).is_valid, panel.name
    if _is_symmetric(before):
        assert _is_symmetric(altered.pattern)
    return after


def _is_symmetric(pattern: Pattern) -> bool:
    """Whether what lies on the left covers as much as what lies on the right, panel by panel."""
    sizes: dict[bool, list[float]] = {True: [], False: []}
    for panel in pattern.panels:
        x = float(panel.to_world(panel.vertices)[:, 0].mean())
        if abs(x) > 1.0:
            sizes[x > 0].append(round(abs(panel.signed_area()), 2))
    left, right = (sorted(sizes[side]) for side in (True, False))
    return len(left) == len(right) and bool(np.allclose(left, right, rtol=5e-3))


@pytest.fixture(scope="session")
def sound():
    """Checks an alteration, and returns the pattern on the cutting table."""
    return _sound
