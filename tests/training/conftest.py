from __future__ import annotations

from pathlib import Path

import pytest
from sewer_data import make_data


@pytest.fixture(scope="session")
def data(tmp_path_factory) -> Path:
    """A data set of eight garments."""
    return make_data(tmp_path_factory.mktemp("garments"))
