from __future__ import annotations

from pathlib import Path

import pytest
from sewn_splits import make_data

from swifttailor.body import Body
from swifttailor.evaluation.garments import score
from swifttailor.garment_sewer.pixels.body_distance import BodyDistance


@pytest.fixture(scope="session")
def data(tmp_path_factory) -> Path:
    """A data set of three garments."""
    return make_data(tmp_path_factory.mktemp("garments"))


@pytest.fixture(scope="session")
def body_distance() -> BodyDistance:
    return BodyDistance.of(Body.default())


@pytest.fixture
def fewer_points(monkeypatch) -> None:
    """An optimal assignment of 2,048 points takes a second, of 300 no time."""
    monkeypatch.setattr(score, "FEW_POINTS", 300)
