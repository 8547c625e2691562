"""Patterns and facts that the tests of edits share."""

from __future__ import annotations

import gzip
import json
from collections.abc import Callable, Iterator
from itertools import islice

import pytest

from swifttailor.data.captions import GarmentFacts, measure_facts
from swifttailor.data.edits.edit_file import read_edits
from swifttailor.data.pattern_source import parsed_pattern
from swifttailor.draping.batch.patterns import read_patterns
from swifttailor.pattern import Pattern, read_specification
from swifttailor.pattern.drafts import draft, list_drafts


@pytest.fixture(scope="session")
def drafts() -> dict[str, Pattern]:
    return {d.name: draft(d.name) for d in list_drafts()}


@pytest.fixture(scope="session")
def draft_facts(drafts) -> dict[str, GarmentFacts]:
    return {name: measure_facts(pattern) for name, pattern in drafts.items()}


@pytest.fixture(scope="session")
def real_patterns(garmentcode_folder) -> dict[str, Pattern]:
    with gzip.open(garmentcode_folder / "validation.jsonl.gz", "rt") as lines:
        samples = [json.loads(line) for line in islice(lines, 0, 150, 15)]
    return {s["id"]: read_specification(s["pattern"], name=s["id"]).pattern for s in samples}


@pytest.fixture(scope="session")
def garmentcode_edits(garmentcode_folder) -> Callable[..., Iterator[tuple[Pattern, Pattern]]]:
    """Goes through GarmentCode's edits of validation patterns, each after its base."""
    if not (garmentcode_folder / "edits.jsonl.gz").exists():
        pytest.skip(f"no edits.jsonl.gz in {garmentcode_folder}")
    bases = {p.id: p for p in read_patterns(garmentcode_folder / "validation.jsonl.gz")}
    edits = [v for v in read_edits(garmentcode_folder / "edits.jsonl.gz") if v.base in bases]

    def read(every: int = 1):
        for version in edits[::every]:
            yield parsed_pattern(bases[version.base]), parsed_pattern(version.pattern)

    return read
