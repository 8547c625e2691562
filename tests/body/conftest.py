from __future__ import annotations

import pytest

from swifttailor.body import Body


@pytest.fixture(scope="session")
def body() -> Body:
    return Body.default()


@pytest.fixture(scope="session")
def cache(tmp_path_factory, request):
    """A cache folder of the tests' own."""
    patch = pytest.MonkeyPatch()
    folder = tmp_path_factory.mktemp("cache")
    patch.setenv("SWIFTTAILOR_CACHE", str(folder))
    yield folder
    patch.undo()
