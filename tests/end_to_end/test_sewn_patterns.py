"""Real patterns, sewn by the weights of the package."""

from __future__ import annotations

import json

import numpy as np
from soundness import SEWN_FILES, assert_sound

from swifttailor.cli.main import run
from swifttailor.garment.garment import Garment
from swifttailor.pattern import check_pattern, load_pattern, write_pattern


def test_twenty_real_patterns_are_sewn(shipped_patterns, tmp_path, capsys):
    """Twice as coarse as usual, for it is cloth of some hundred metres."""
    files = []
    for name, pattern in shipped_patterns.items():
        files.append(str(tmp_path / f"{name}.json"))
        write_pattern(pattern, tmp_path / f"{name}.json")
    out = tmp_path / "out"
    flawed = {name for name, pattern in shipped_patterns.items() if check_pattern(pattern)}
    assert len(flawed) <= 1
    asked = ["sew", *files, "--out", str(out), "--json", "--no-preview", "--edge-length", "4"]
    assert run(asked) == bool(flawed)
    reports = json.loads(capsys.readouterr().out)
    assert len(reports) == len(shipped_patterns) == 20
    assert {p.name for p in out.iterdir()} == shipped_patterns.keys()
    gaps, inside = [], []
    for name, given in shipped_patterns.items():
        pattern, _, report = assert_sound(out / name, SEWN_FILES)
        assert pattern.canonical() == given.canonical()
        gaps.append(report["sewing"]["seam_gap_before_median_cm"])
        inside.append(report["sewing"]["inside_body"])
    # Before they are closed the network brings seams together, and cloth stays outside the body.
    # One has five gathered tiers, the last of 59 m: of it the network closes nothing.
    assert sorted(gaps)[-2] < 0.5 and np.median(gaps) < 0.15
    assert max(inside) <= 0.01


def test_what_was_sewn_is_a_pattern_to_sew_again(shipped_patterns, tmp_path, capsys):
    write_pattern(shipped_patterns["gc_1001309"], tmp_path / "pattern.json")
    assert run(["sew", str(tmp_path / "pattern.json"), "--out", str(tmp_path / "one")]) == 0
    assert run(["sew", str(tmp_path / "one" / "pattern.json"), "--out", str(tmp_path / "two")]) == 0
    for name in ("pattern.json", "pattern.svg", "garment.glb", "garment.obj"):
        assert (tmp_path / "one" / name).read_bytes() == (tmp_path / "two" / name).read_bytes()
    assert load_pattern(tmp_path / "two" / "pattern.json") == Garment.load(tmp_path / "two").pattern
