"""A library of a few known patterns."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import numpy as np

from swifttailor.describing import measure_facts
from swifttailor.pattern import Pattern
from swifttailor.pattern_library.known import KnownPattern, PatternLibrary, write_library
from swifttailor.pattern_library.truth_table import TruthTable
from swifttailor.picture_reader.truth import Truth


def library_of(patterns: Mapping[str, Pattern], folder: Path) -> PatternLibrary:
    """Written to a folder and opened from there."""
    known = [KnownPattern(name, pattern.canonical()) for name, pattern in patterns.items()]
    truths = [Truth.of(one.pattern, measure_facts(one.pattern)) for one in known]
    path = folder / "known.zip"
    write_library(path, known, TruthTable.of(truths), np.ones(len(known), np.int64), {"model": "library"})
    return PatternLibrary.load(path)
