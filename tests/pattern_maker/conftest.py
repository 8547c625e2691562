from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from swifttailor.pattern import Pattern, read_specification
from swifttailor.pattern.check.repair import Repair
from swifttailor.pattern_maker.maker import PatternMaker


@pytest.fixture(scope="session")
def real_patterns(real_samples) -> Callable[..., Iterator[Pattern]]:
    """Every k-th pattern of files of GarmentCode samples; see `real_samples`."""

    def read(*names: str, every: int = 1) -> Iterator[Pattern]:
        for sample in real_samples(*names, every=every):
            yield read_specification(sample["pattern"], name=sample["id"]).pattern

    return read


@pytest.fixture(scope="session")
def tiny_maker() -> PatternMaker:
    """An untrained network that repeats and plans."""
    return PatternMaker.load(Path(__file__).with_name("tiny_maker.zip"))


@pytest.fixture
def unmended(monkeypatch) -> None:
    """For tests of the writing: to mend what an untrained network scribbles takes seconds a pattern."""
    monkeypatch.setattr(
        "swifttailor.pattern_maker.maker.mend", lambda pattern, *, alike: Repair(pattern, (), ())
    )
