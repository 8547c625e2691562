"""Patterns sampled from GarmentCode: exact round trips, few findings, faults put into them found again."""

from __future__ import annotations

import json
import random
from dataclasses import replace

import numpy as np
import pytest

from swifttailor.pattern import (
    EdgeRef,
    Severity,
    Stitch,
    check_pattern,
    load_pattern,
    read_specification,
    repair_pattern,
    to_specification,
)

EVERY = {"repository": 1, "train": 20, "train-2": 40, "edits": 40, "test": 1, "validation": 1}


def as_sets(specification):
    """The specification with everything that GarmentCode orders at random put in order."""
    pattern = dict(specification["pattern"])
    pattern["panels"] = sorted(pattern["panels"].items())
    pattern["stitches"] = sorted(json.dumps(s) for s in pattern["stitches"])
    return {**specification, "pattern": pattern}


@pytest.mark.parametrize("name", EVERY)
def test_every_pattern_comes_back_exactly(real_samples, name):
    count = 0
    for sample in real_samples(name, every=EVERY[name]):
        identifier, specification = sample["id"], sample["pattern"]
        reading = read_specification(specification, name=identifier)
        assert reading.findings == (), identifier
        written = to_specification(reading.pattern)
        assert as_sets(json.loads(json.dumps(written))) == as_sets(specification), identifier
        again = read_specification(written, name=identifier).pattern
        assert again == reading.pattern and again.canonical() == reading.pattern.canonical()
        count += 1
    if not count:
        pytest.skip(f"{name}.jsonl.gz is not there")
    assert count >= 20


def test_garmentcodes_own_examples_are_clean(garmentcode_folder):
    files = sorted(garmentcode_folder.glob("*_specification.json"))
    if not files:
        pytest.skip(f"no example specifications in {garmentcode_folder}")
    for path in files:
        assert check_pattern(load_pattern(path)) == (), path.name


def test_the_facts_of_the_format_hold(real_samples):
    """Normals face outward; darts and stitches are what docs/checks.md takes for granted."""
    for sample in real_samples("repository", "validation", every=2):
        identifier, pattern = sample["id"], read_specification(sample["pattern"]).pattern
        for panel in pattern.panels:
            facing = panel.normal() @ np.array(panel.placement.translation)
            assert facing >= -1e-9, (identifier, panel.name)
        used = [ref for s in pattern.stitches for ref in s.sides]
        assert len(used) == len(set(used)) and len(pattern.components()) == 1
        for s in pattern.stitches:
            if s.first.panel == s.second.panel:
                count = len(pattern.panel(s.first.panel).edges)
                assert (s.first.edge - s.second.edge) % count in (1, count - 1)


def test_real_patterns_have_few_findings(real_samples):
    clean, total = 0, 0
    for sample in (*real_samples("repository"), *real_samples("train", "validation", every=30)):
        identifier, pattern = sample["id"], read_specification(sample["pattern"]).pattern
        found = check_pattern(pattern)
        codes = {f.code for f in found}
        assert not codes & {"twisted-seam", "inside-out-panel", "turned-panel", "collapsed-edge"}, identifier
        assert not any(f.severity is Severity.ERROR for f in found if f.code != "self-crossing"), identifier
        repair = repair_pattern(pattern)
        if not found:
            clean += 1
            assert repair.pattern is pattern and repair.changes == ()
        total += 1
    assert clean >= 0.95 * total


def test_single_turned_stitches_are_all_found_and_turned_back(real_samples):
    rng = random.Random(3)
    turned = certain = 0
    for sample in (*real_samples("repository"), *real_samples("train", every=60)):
        identifier, pattern = sample["id"], read_specification(sample["pattern"]).pattern
        k = rng.randrange(len(pattern.stitches))
        stitches = list(pattern.stitches)
        stitches[k] = replace(stitches[k], right_wrong=not stitches[k].right_wrong)
        twisted = replace(pattern, stitches=tuple(stitches))
        found = [f.stitch for f in check_pattern(twisted) if f.code == "twisted-seam"]
        assert found == [k], identifier
        mended = repair_pattern(twisted).pattern.stitches
        assert mended in (pattern.stitches, twisted.stitches), identifier
        turned, certain = turned + 1, certain + (mended == pattern.stitches)
    assert certain >= 0.95 * turned


def test_panels_wound_alike_are_reversed_back(real_samples):
    """What programs write that wind every panel counter-clockwise."""
    mended = total = 0
    for sample in (*real_samples("repository"), *real_samples("train", every=60)):
        identifier, pattern = sample["id"], read_specification(sample["pattern"]).pattern
        clockwise = {p.name: len(p.edges) - 1 for p in pattern.panels if p.signed_area() < 0}

        def renumber(ref, last=clockwise):
            return EdgeRef(ref.panel, last[ref.panel] - ref.edge) if ref.panel in last else ref

        alike = replace(
            pattern,
            panels=tuple(p.reversed() if p.name in clockwise else p for p in pattern.panels),
            stitches=tuple(
                Stitch(renumber(s.first), renumber(s.second), s.right_wrong) for s in pattern.stitches
            ),
        )
        repair = repair_pattern(alike)
        assert {c.panel for c in repair.changes if c.code == "inside-out-panel"} <= set(clockwise), identifier
        total += 1
        mended += np.all([
            p.signed_area() * q.signed_area() > 0
            for p, q in zip(repair.pattern.panels, pattern.panels, strict=True)
        ])  # fmt: skip
    assert mended >= 0.95 * total
