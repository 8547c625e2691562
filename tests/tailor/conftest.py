from __future__ import annotations

from pathlib import Path

import pytest

from swifttailor.garment_sewer.sewer import GarmentSewer

TINY_SEWER = Path(__file__).parents[1] / "garment_sewer" / "tiny_sewer.onnx"


@pytest.fixture(scope="session")
def sewer() -> GarmentSewer:
    """Untrained: it sews what its prior says."""
    return GarmentSewer.load(TINY_SEWER)


@pytest.fixture(scope="module", autouse=True)
def _sews_untrained(rough_falls) -> None:
    """What is tested here is what is made of an order, not how cloth falls."""
