"""A garment that the tests of the texture layout share with those of garments' files."""

from __future__ import annotations

import pytest
from sewn_tube import tube_garment

from swifttailor.garment import Garment


@pytest.fixture(scope="session")
def tube() -> Garment:
    return tube_garment()
