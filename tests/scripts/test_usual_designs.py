"""Usual garments, drawn and drafted by this package's own programs, and designs placed for training."""

from __future__ import annotations

import gzip
import json
import subprocess
import sys
from pathlib import Path

from swifttailor.parameter_reader import ParameterReader
from swifttailor.parameter_reader.placed_designs import PlacedDesigns
from swifttailor.pattern import read_specification
from swifttailor.pattern.digest import pattern_digest
from swifttailor.programs import make_pattern

SCRIPTS = Path(__file__).resolve().parents[2] / "scripts"


def run(script: str, *arguments: object) -> str:
    command = [sys.executable, str(SCRIPTS / script), *map(str, arguments)]
    return subprocess.run(command, check=True, capture_output=True, text=True, timeout=300).stdout


def drawn(path: Path, workers: int) -> list[dict]:
    run("draw_usual_designs.py", "--count", 8, "--start", 70_000_000, "--workers", workers, "--out", path)
    with gzip.open(path, "rt", encoding="utf-8") as file:
        return [json.loads(line) for line in file]


def test_usual_designs_are_the_same_on_any_number_of_cores_and_make_their_patterns(tmp_path):
    path = tmp_path / "usual.jsonl.gz"
    lines = drawn(path, 2)
    assert lines == drawn(tmp_path / "again.jsonl.gz", 1)
    assert len(lines) >= 6 and len({line["archetype"] for line in lines}) > 3
    for line in lines:
        read = read_specification(line["pattern"], name=line["id"]).pattern.canonical()
        assert pattern_digest(read) == pattern_digest(make_pattern(line["design"]).canonical())

    said = run("place_designs.py", "--patterns", path, "--out", tmp_path / "designs.safetensors")
    placed = PlacedDesigns.read(tmp_path / "designs.safetensors")
    assert placed.parameters == ParameterReader.load().parameters
    assert set(placed.rows) <= {line["id"] for line in lines} and len(placed.rows) >= 5
    assert f"{len(placed.rows)} of {len(lines)} designs" in said
