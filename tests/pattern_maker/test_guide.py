"""docs/pattern-maker.md says what is so."""

from __future__ import annotations

import re
import shutil
from pathlib import Path

import numpy as np
import pytest

from swifttailor.pattern import Pattern
from swifttailor.pattern_maker.tokens import normalization
from swifttailor.pattern_maker.tokens.vocabulary import TOKENS

GUIDE = Path(__file__).parents[2] / "docs" / "pattern-maker.md"

pytestmark = pytest.mark.skipif(
    not GUIDE.is_file(), reason="only in the repository, not in an installed package"
)


def test_the_examples_run(tmp_path, monkeypatch):
    """In order; the weights are those of an untrained network."""
    shutil.copy(Path(__file__).with_name("tiny_maker.zip"), tmp_path / "pattern_maker.zip")
    monkeypatch.chdir(tmp_path)
    names: dict = {}
    for block in re.findall(r"^```python\n(.*?)^```$", GUIDE.read_text(), re.MULTILINE | re.DOTALL):
        exec(compile(block, GUIDE.name, "exec"), names)
    assert isinstance(names["pattern"], Pattern) and len(names["pattern"].panels) > 4
    assert isinstance(names["made"].pattern, Pattern) and isinstance(names["shorter"].pattern, Pattern)


def test_the_ids_are_those_of_the_table():
    rows = re.findall(r"^\| (\d+)(?:(?:,| to) (\d+))? \| (`<.*?) \|", GUIDE.read_text(), re.MULTILINE)
    ends = [(int(first), int(last or first), re.findall(r"`(<.*?>)`", text)) for first, last, text in rows]
    assert [e[0] for e in ends[1:]] == [e[1] + 1 for e in ends[:-1]]
    assert ends[0][0] == 0 and ends[-1][1] == len(TOKENS) - 1
    for first, last, shown in ends:
        if shown != ["<panel:NAME>"]:
            assert shown[0] == TOKENS[first] and set(shown) <= set(TOKENS[first : last + 1])
        else:
            assert all(token.startswith("<panel:") for token in TOKENS[first : last + 1])


@pytest.mark.parametrize(
    ("row", "shift", "scale"),
    [
        ("points", normalization.POINT_SHIFT, normalization.POINT_SCALE),
        ("translations", normalization.TRANSLATION_SHIFT, normalization.TRANSLATION_SCALE),
    ],
)
def test_the_constants_are_those_of_the_table(row, shift, scale):
    line = next(x for x in GUIDE.read_text().splitlines() if x.startswith(f"| {row} |"))
    numbers = [[float(n) for n in cell.split(",")] for cell in line.split("|")[2:4]]
    assert np.array_equal(numbers, [shift, scale])
