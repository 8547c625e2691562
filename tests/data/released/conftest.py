from __future__ import annotations

import pytest

from swifttailor.pattern import Pattern, read_specification


@pytest.fixture(scope="session")
def garments(real_samples) -> dict[str, Pattern]:
    """The 20 patterns from GarmentCode beside the tests, by id."""
    return {
        s["id"]: read_specification(s["pattern"], name=s["id"]).pattern for s in real_samples("repository")
    }
