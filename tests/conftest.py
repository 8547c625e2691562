"""Fixtures shared by all tests."""

from __future__ import annotations

import os
from pathlib import Path

import pytest
from hypothesis import settings

from swifttailor.pattern import EdgeRef, Pattern, Placement, Stitch
from swifttailor.pattern.panel import Edge, Panel

# No test is timed: on a busy machine an example may take any time.
settings.register_profile("untimed", deadline=None)
settings.load_profile("untimed")


@pytest.fixture(scope="session")
def garmentcode_folder() -> Path:
    """Folder of GarmentCode samples (``*.jsonl.gz``): $SWIFTTAILOR_GARMENTCODE or ../shared/garmentcode."""
    default = Path(__file__).resolve().parents[2] / "shared" / "garmentcode"
    folder = Path(os.environ.get("SWIFTTAILOR_GARMENTCODE", default))
    if not any(folder.glob("*.jsonl.gz")):
        pytest.skip(f"no GarmentCode samples (*.jsonl.gz) in {folder}; set SWIFTTAILOR_GARMENTCODE")
    return folder


@pytest.fixture
def square_pattern() -> Pattern:
    """Two 40 x 60 cm rectangles, front and back, sewn along both sides into a tube around the body."""
    corners = [[-20.0, 0.0], [20.0, 0.0], [20.0, 60.0], [-20.0, 60.0]]
    front = Panel("front", corners, (Edge(),) * 4, Placement((0.0, 80.0, 25.0)))
    # The back is travelled clockwise, so that its right side faces away from the body.
    back = Panel("back", corners[::-1], (Edge(),) * 4, Placement((0.0, 80.0, -25.0)))
    sides = (Stitch(EdgeRef("front", 1), EdgeRef("back", 1)), Stitch(EdgeRef("front", 3), EdgeRef("back", 3)))
    return Pattern((front, back), sides, "tube")
