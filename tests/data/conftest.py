from __future__ import annotations

import json
from collections.abc import Iterator
from functools import partial
from pathlib import Path

import pytest

from swifttailor.pattern.drafts import draft
from swifttailor.pattern.garmentcode_writer import to_specification


@pytest.fixture(scope="session", autouse=True)
def _no_power_fails() -> Iterator[None]:
    """Files are not waited for until they are on the disk: that shows only where the power fails."""
    with pytest.MonkeyPatch.context() as patched:
        patched.setattr("os.fsync", lambda descriptor: None)
        yield


@pytest.fixture(scope="session")
def specification() -> dict:
    """A small pattern."""
    return to_specification(draft("fitted-skirt"))


@pytest.fixture(scope="session")
def patterns_into(specification):
    """Writes a file of patterns with the given ids into a folder; each pattern is a little different."""

    def write(folder: Path, *ids: str, name: str = "patterns.jsonl") -> Path:
        lines = []
        for id in ids:
            lines.append(json.dumps({"id": id, "pattern": specification, "note": f"of {id}"}))
        path = folder / name
        path.write_text("".join(line + "\n" for line in lines))
        return path

    return write


@pytest.fixture
def patterns_file(tmp_path, patterns_into):
    """The same into the folder of the test."""
    return partial(patterns_into, tmp_path)
