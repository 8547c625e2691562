from __future__ import annotations

import pytest

from swifttailor.body import Body
from swifttailor.garment_sewer.pixels.body_distance import BodyDistance
from swifttailor.garment_sewer.pixels.pixel_table import PixelTable, tabulate
from swifttailor.ggi import Layout, lay_out
from swifttailor.pattern.drafts import draft


@pytest.fixture(scope="session")
def body_distance() -> BodyDistance:
    return BodyDistance.of(Body.default())


@pytest.fixture(scope="session", params=["t-shirt", "shirt-dress", "trousers"])
def layout(request) -> Layout:
    return lay_out(draft(request.param), 96)


@pytest.fixture(scope="session")
def table(layout, body_distance) -> PixelTable:
    """With the sewn prior."""
    return tabulate(layout, "sewn", body_distance)
