from __future__ import annotations

import gzip
import json
from collections.abc import Callable, Iterator

import pytest

from swifttailor.pattern import Pattern, read_specification


@pytest.fixture(scope="session")
def real_patterns(garmentcode_folder) -> Callable[[str, int], Iterator[Pattern]]:
    """Every k-th pattern of a file of GarmentCode samples."""

    def read(name: str, every: int) -> Iterator[Pattern]:
        path = garmentcode_folder / f"{name}.jsonl.gz"
        if not path.exists():
            pytest.skip(f"{path.name} is not in {garmentcode_folder}")
        with gzip.open(path, "rt") as lines:
            for k, line in enumerate(lines):
                if k % every == 0:
                    sample = json.loads(line)
                    yield read_specification(sample["pattern"], name=sample["id"]).pattern

    return read
