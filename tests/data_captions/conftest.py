"""Patterns that the tests of captions share."""

from __future__ import annotations

import gzip
import json
from collections.abc import Iterator
from pathlib import Path

import pytest

from swifttailor.data.captions import GarmentFacts, measure_facts
from swifttailor.pattern import Pattern, read_specification
from swifttailor.pattern.drafts import draft, list_drafts

EVERY_REAL = 4
"""Of the validation patterns; the others are looked at when captions are worked on (docs/captions.md)."""


@pytest.fixture(scope="session")
def drafts() -> dict[str, Pattern]:
    return {d.name: draft(d.name) for d in list_drafts()}


@pytest.fixture(scope="session")
def draft_facts(drafts) -> dict[str, GarmentFacts]:
    return {name: measure_facts(pattern) for name, pattern in drafts.items()}


@pytest.fixture(scope="session")
def real_patterns(garmentcode_folder: Path) -> dict[str, Pattern]:
    return dict(_read(garmentcode_folder / "validation.jsonl.gz"))


@pytest.fixture(scope="session")
def real_facts(real_patterns) -> dict[str, GarmentFacts]:
    return {name: measure_facts(pattern) for name, pattern in real_patterns.items()}


def _read(path: Path) -> Iterator[tuple[str, Pattern]]:
    with gzip.open(path, "rt") as lines:
        for k, line in enumerate(lines):
            if k % EVERY_REAL == 0:
                sample = json.loads(line)
                yield sample["id"], read_specification(sample["pattern"], name=sample["id"]).pattern
