"""Close tops and jackets have a seam in the middle of the back that is drawn in at the waist."""

from __future__ import annotations

import numpy as np
import pytest

import swifttailor
from swifttailor.pattern.centre_seams import needless_centre_seams
from swifttailor.pattern.drafts import DraftMeasurements
from swifttailor.pattern.drafts.back_hollow import back_hollow


def drawn_in(pattern: swifttailor.Pattern) -> float:
    """How far the edges between the neck and the hem of the left back lie beyond the middle, cm."""
    panel = pattern.panel("left_btorso")
    depths = []
    for edge in range(len(panel.edges)):
        across = np.abs(panel.sample_edge(edge, 9)[:, 0])
        if min(across[0], across[-1]) < 0.1 and np.ptp(panel.sample_edge(edge, 9)[:, 1]) > 8.0:
            depths.append(float(across.max()))
    return max(depths, default=0.0)


@pytest.mark.parametrize(
    ("name", "options"),
    [
        ("t-shirt", {"waist_shaping": 2.5, "chest_ease": 3.0, "stretch": 5.0}),
        ("tank-top", {"waist_shaping": 2.5}),
        ("shirt", {"waist_shaping": 2.5, "chest_ease": 4.0}),
        ("cardigan", {"waist_shaping": 2.5, "chest_ease": 4.0}),
        ("blazer", {}),
        ("coat", {"waist_shaping": 3.0}),
    ],
)
def test_close_backs_are_drawn_in(name: str, options: dict[str, float]) -> None:
    pattern = swifttailor.draft(name, **options)
    assert 1.5 < drawn_in(pattern) < 4.0
    seams = {name for k in needless_centre_seams(pattern) for name in [pattern.stitches[k].first.panel]}
    assert not any("btorso" in name for name in seams)


@pytest.mark.parametrize(
    ("name", "options"),
    [("t-shirt", {}), ("t-shirt", {"waist_shaping": 1.0}), ("shirt", {}), ("coat", {})],
)
def test_loose_backs_are_straight(name: str, options: dict[str, float]) -> None:
    assert drawn_in(swifttailor.draft(name, **options)) < 0.1


def test_what_has_no_room_at_the_waist_is_not_drawn_in() -> None:
    stout = DraftMeasurements(bust=100.0, waist=98.0, hips=104.0)
    pattern = swifttailor.draft("t-shirt", measurements=stout, waist_shaping=2.5, chest_ease=3.0)
    assert drawn_in(pattern) < 0.1
    assert back_hollow(100.0, shaping=2.5, room=3.0) is None
    deepest = back_hollow(100.0, shaping=4.0, room=30.0)
    assert deepest is not None and deepest.depth == pytest.approx(3.2)
