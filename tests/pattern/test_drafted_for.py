"""Which body a pattern was drafted for, in its file."""

from __future__ import annotations

from dataclasses import replace

import pytest

from swifttailor.errors import PatternError
from swifttailor.pattern import read_specification
from swifttailor.pattern.drafted_for import DraftedFor
from swifttailor.pattern.drafts import draft
from swifttailor.pattern.garmentcode_writer import to_specification

NAMED = DraftedFor("women EU 44", "women", (("bust", 100.0), ("height", 168.0)))


def test_it_is_written_and_read_again():
    pattern = replace(draft("fitted-skirt"), drafted_for=NAMED)
    read = read_specification(to_specification(pattern)).pattern
    assert read.drafted_for == NAMED
    assert read == pattern  # it is no part of what a pattern is


def test_files_without_it_are_for_the_default_body():
    written = to_specification(draft("fitted-skirt"))
    assert "drafted_for" not in written["properties"]
    assert read_specification(written).pattern.drafted_for is None


@pytest.mark.parametrize(
    "raw",
    [
        7,
        "women",
        {},
        {"name": 3},
        {"name": "x", "figure": 1},
        {"name": "x", "measures": [1]},
        {"name": "x", "measures": {"bust": "wide"}},
        {"name": "x", "measures": {"bust": 10**400}},
        {"name": "x", "measures": {"bust": float("inf")}},
        {"name": "x", "measures": {str(k): 1.0 for k in range(1000)}},
    ],
)
def test_anything_else_is_refused(raw):
    written = to_specification(draft("fitted-skirt"))
    written["properties"]["drafted_for"] = raw
    with pytest.raises(PatternError, match="drafted_for"):
        read_specification(written)
