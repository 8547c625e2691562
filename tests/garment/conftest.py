from __future__ import annotations

import pytest
from sewn_tube import tube_garment

from swifttailor.garment.garment import Garment
from swifttailor.garment.triangle_mesh import TriangleMesh, mesh_of_garment


@pytest.fixture(scope="session")
def tube() -> Garment:
    return tube_garment()


@pytest.fixture(scope="session")
def tube_mesh(tube: Garment) -> TriangleMesh:
    return mesh_of_garment(tube)
