"""Patterns and facts that the tests of edits share."""

from __future__ import annotations

import gzip
import json
from itertools import islice

import pytest

from swifttailor.data.captions import GarmentFacts, measure_facts
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
def garmentcode_edits(garmentcode_folder) -> list[tuple[dict, dict]]:
    """Lines of edits of validation patterns, each after the line of its base."""
    if not (garmentcode_folder / "edits.jsonl.gz").exists():
        pytest.skip(f"no edits.jsonl.gz in {garmentcode_folder}")
    with gzip.open(garmentcode_folder / "validation.jsonl.gz", "rt") as lines:
        bases = {s["id"]: s for s in map(json.loads, lines)}
    with gzip.open(garmentcode_folder / "edits.jsonl.gz", "rt") as lines:
        edits = [e for e in map(json.loads, lines) if e["base"] in bases]
    return [(bases[e["base"]], e) for e in edits]
