"""Every command and every line of Python in the guide works as printed."""

from __future__ import annotations

import re
import shlex
from pathlib import Path

import pytest

from swifttailor.cli.main import run
from swifttailor.making.paper import PAPERS

GUIDE = Path(__file__).parents[2] / "docs" / "making.md"
pytestmark = pytest.mark.skipif(not GUIDE.is_file(), reason="only in the repository")


def blocks(language: str) -> list[str]:
    return re.findall(rf"```{language}\n(.*?)```", GUIDE.read_text(), re.DOTALL)


def test_the_guide(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    lines = [line for block in blocks("console") for line in block.splitlines()]
    for line in lines:
        words = shlex.split(line)
        assert words[0] == "swifttailor" and run(words[1:]) == 0, line
    made = {p.name for p in tmp_path.iterdir()}
    assert made == {
        "dress.json", "dress.pdf", "dress.dxf", "dress-steps.md", "dress-marker.svg", "dress-cad.zip",
        "dress-panels.obj", "dress-sizes", "dress-sizes.pdf", "dress-sizes.dxf",
    }  # fmt: skip
    capsys.readouterr()
    for block in blocks("python"):
        exec(compile(block, "making.md", "exec"), {})
    assert "Bodice front Cut 2, mirrored" in capsys.readouterr().out


def test_all_papers_and_options_are_told():
    text = GUIDE.read_text()
    assert all(f"`{name}`" in text for name in PAPERS)
    options = (
        "paper allowance hem-allowance edge-allowance dialect color print print-width with-body fold "
        "seconds one-way width cloth-width"
    )
    for option in options.split():
        assert f"--{option}" in text, option
