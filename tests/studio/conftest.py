"""A studio to ask: a real one on loopback, with all of it."""

from __future__ import annotations

import gzip
import json
import signal
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import httpx
import pytest
from running_studio import RunningStudio, start_studio, wait_until_ready

_SAMPLES = Path(__file__).parents[1] / "garmentcode_patterns" / "patterns.jsonl.gz"


@pytest.fixture(scope="session")
def studio(tmp_path_factory: pytest.TempPathFactory) -> Iterator[RunningStudio]:
    """One server for all tests that leave it as it was, its networks loaded."""
    running = start_studio(tmp_path_factory.mktemp("studio") / "projects")
    try:
        wait_until_ready(running)
        yield running
    finally:
        running.end(signal.SIGKILL)


@pytest.fixture(scope="session")
def client(studio: RunningStudio) -> Iterator[httpx.Client]:
    with studio.client() as asking:
        yield asking


@pytest.fixture(scope="session")
def dress(client: httpx.Client) -> dict[str, Any]:
    """The document of the first example, a dress."""
    return client.get("/api/examples/summer-dress").json()


@pytest.fixture(scope="session")
def real_pattern() -> dict[str, Any]:
    """A pattern that GarmentCode has sampled."""
    with gzip.open(_SAMPLES, "rt") as lines:
        return json.loads(next(lines))["pattern"]
