"""The examples run as they stand, in a folder of their own, and check themselves."""

from __future__ import annotations

import runpy
import sys
from pathlib import Path

import pytest

from swifttailor.draping import engines

EXAMPLES = sorted((Path(__file__).parents[1] / "examples").glob("*.py"))


@pytest.mark.parametrize("example", EXAMPLES, ids=lambda path: path.stem)
def test_example(example, tmp_path, monkeypatch, capsys):
    monkeypatch.setattr(engines, "_MAKERS", dict(engines._MAKERS))
    monkeypatch.setattr(sys, "argv", [str(example)])
    monkeypatch.chdir(tmp_path)
    runpy.run_path(str(example), run_name="__main__")
    assert capsys.readouterr().out.strip()


def test_each_example_says_what_it_shows_and_checks_itself():
    assert len(EXAMPLES) >= 6
    for example in EXAMPLES:
        text = example.read_text()
        assert f"python examples/{example.name}" in text, example.name
        assert "assert " in text, example.name
        assert len(text.splitlines()) <= 50, example.name
