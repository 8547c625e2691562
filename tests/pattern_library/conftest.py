from __future__ import annotations

import numpy as np
import pytest

from swifttailor.pattern_library.known import KnownPattern, PatternLibrary, write_library
from swifttailor.pattern_library.truth_table import TruthTable
from swifttailor.picture_reader.truth import Truth


@pytest.fixture(scope="session")
def known(shipped_patterns, drafts) -> list[KnownPattern]:
    """The 20 real patterns beside the tests, and all drafts."""
    found = {**shipped_patterns, **drafts}
    return [KnownPattern(name, pattern.canonical()) for name, pattern in found.items()]


@pytest.fixture(scope="session")
def truths(known) -> list[Truth]:
    from swifttailor.describing import measure_facts

    return [Truth.of(one.pattern, measure_facts(one.pattern)) for one in known]


@pytest.fixture(scope="session")
def library_file(known, truths, tmp_path_factory):
    path = tmp_path_factory.mktemp("library") / "known.zip"
    stand = np.arange(len(known)) % 5
    return write_library(path, known, TruthTable.of(truths), stand, {"seed": 7})


@pytest.fixture(scope="session")
def library(library_file) -> PatternLibrary:
    return PatternLibrary.load(library_file)
