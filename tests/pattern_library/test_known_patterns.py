"""The file of known patterns: what goes in comes out, and nothing else is taken for it."""

from __future__ import annotations

import json
import zipfile
from dataclasses import replace

import numpy as np
import pytest

from swifttailor.errors import InputError
from swifttailor.pattern import Pattern, Severity, check_pattern
from swifttailor.pattern.digest import pattern_digest
from swifttailor.pattern.panel import Placement
from swifttailor.pattern_library.known import (
    SHIPPED,
    PatternLibrary,
    rounded,
    write_library,
)
from swifttailor.pattern_library.packing import MOST_BYTES, deflated, inflated, short_json
from swifttailor.pattern_library.truth_table import BOX_UNIT_CM, TruthTable

NEAR_CM = 0.006


def test_patterns_come_back_as_they_were_but_for_roundings(known, library):
    assert library.ids == tuple(one.id for one in known)
    for k, one in enumerate(known):
        found = library.pattern(k)
        assert found.name == one.id
        assert found.stitches == one.pattern.stitches
        assert [p.name for p in found.panels] == [p.name for p in one.pattern.panels]
        for now, was in zip(found.panels, one.pattern.panels, strict=True):
            assert now.label == was.label
            assert [e.label for e in now.edges] == [e.label for e in was.edges]
            assert [type(e.curve) for e in now.edges] == [type(e.curve) for e in was.edges]
            np.testing.assert_allclose(now.vertices, was.vertices, atol=NEAR_CM)
            np.testing.assert_allclose(
                now.to_world(now.vertices), was.to_world(was.vertices), atol=3 * NEAR_CM
            )
            for k_edge in range(len(was.edges)):
                assert now.edge_length(k_edge) == pytest.approx(was.edge_length(k_edge), abs=0.03)


def test_a_check_finds_nothing_new_in_what_comes_back(known):
    for one in known:
        before = sorted((f.code, f.severity) for f in check_pattern(one.pattern))
        assert sorted((f.code, f.severity) for f in check_pattern(rounded(one.pattern))) == before


def test_rounding_twice_changes_nothing_more(known):
    for one in known[::4]:
        once = rounded(one.pattern)
        assert pattern_digest(rounded(once)) == pattern_digest(once)


def test_what_is_true_comes_back(truths, library):
    assert len(library.table) == len(library) == len(truths)
    for k, truth in enumerate(truths):
        found = library.table[k]
        assert found.part == truth.part
        np.testing.assert_array_equal(found.statements, truth.statements)
        np.testing.assert_array_equal(found.panels, truth.panels)
        np.testing.assert_allclose(found.measures, truth.measures, rtol=1e-3)
        np.testing.assert_allclose(found.boxes, truth.boxes, atol=BOX_UNIT_CM)


def test_it_says_what_it_is_of(known, library):
    assert library.card == {"seed": 7}
    assert library.digests == tuple(pattern_digest(one.pattern) for one in known)
    np.testing.assert_array_equal(library.stands_for, np.arange(len(known)) % 5)


def test_the_same_patterns_give_the_same_bytes(known, truths, library_file, tmp_path):
    table, stand = TruthTable.of(truths), np.arange(len(known)) % 5
    again = write_library(tmp_path / "again.zip", known, table, stand, {"seed": 7})
    assert again.read_bytes() == library_file.read_bytes()


def test_some_rows_of_a_table(truths):
    table = TruthTable.of(truths)
    some = table.take([3, 0, 5])
    for row, k in enumerate((3, 0, 5)):
        np.testing.assert_array_equal(some[row].boxes, table[k].boxes)
        np.testing.assert_array_equal(some[row].statements, table[k].statements)
    assert len(table.take([])) == 0


def test_patterns_with_other_angles_are_refused(known, truths, tmp_path):
    panel = known[0].pattern.panels[0]
    turned = replace(panel, placement=Placement(rotation=(1.0, 2.0, 3.0), reading="extrinsic"))
    with pytest.raises(InputError, match="extrinsic"):
        short_json(Pattern((turned,)))
    with pytest.raises(InputError, match="equally many"):
        write_library(tmp_path / "x.zip", known[:2], TruthTable.of(truths), np.zeros(2, int), {})


def test_a_pattern_that_swells_is_refused():
    with pytest.raises(InputError, match="longer than"):
        inflated(deflated(b"0" * (MOST_BYTES + 1), b""), b"")
    with pytest.raises(InputError, match="damaged"):
        inflated(b"\xff\xff\xff", b"")


def _changed(source, target, name, data):
    with zipfile.ZipFile(source) as old, zipfile.ZipFile(target, "w") as new:
        for member in old.namelist():
            new.writestr(member, data(old.read(member)) if member == name else old.read(member))
    return target


def test_damaged_files_are_refused(library_file, tmp_path):
    with pytest.raises(InputError, match="cannot be read"):
        PatternLibrary.load(tmp_path / "nothing.zip")
    (tmp_path / "text.zip").write_text("no archive")
    with pytest.raises(InputError, match="damaged"):
        PatternLibrary.load(tmp_path / "text.zip")
    for name in ("boxes.npy", "true.npy", "digests.npy"):
        cut = _changed(library_file, tmp_path / f"cut-{name}.zip", name, lambda data: data[:-50])
        with pytest.raises(InputError):
            PatternLibrary.load(cut)
    short = _changed(library_file, tmp_path / "short.zip", "patterns", lambda data: data[:-1])
    with pytest.raises(InputError, match="one after the other"):
        PatternLibrary.load(short)


def test_libraries_for_other_statements_are_refused(library_file, tmp_path):
    def other(data):
        return json.dumps(json.loads(data) | {"labels_sha256": "0"}).encode()

    path = _changed(library_file, tmp_path / "other.zip", "about.json", other)
    with pytest.raises(InputError, match="other statements"):
        PatternLibrary.load(path)


def test_damaged_patterns_are_said_to_be(library_file, tmp_path):
    path = _changed(library_file, tmp_path / "bad.zip", "patterns", lambda data: b"\xff" * len(data))
    library = PatternLibrary.load(path)
    with pytest.raises(InputError, match="damaged"):
        library.pattern(0)


def test_the_shipped_library_is_sound():
    library = PatternLibrary.load()
    assert SHIPPED.stat().st_size <= 8e6
    assert 1000 <= len(library) == library.card["patterns"]
    assert len(set(library.digests)) == len(library)
    assert library.card["usual"] >= len(library) / 4
    beside = json.loads(SHIPPED.with_suffix(".json").read_text())
    assert library.card.items() <= beside.items()
    for k in range(0, len(library), 600):
        found = check_pattern(library.pattern(k))
        assert not [f for f in found if f.severity in (Severity.ERROR, Severity.WARNING)]


def test_the_shipped_library_has_no_pattern_to_evaluate_with(real_samples):
    from swifttailor.pattern import read_specification

    library = PatternLibrary.load()
    apart = {
        pattern_digest(read_specification(sample["pattern"]).pattern)
        for sample in real_samples("validation", "test")
    }
    assert not apart & set(library.digests)


def test_what_is_true_of_the_shipped_patterns_is_so():
    from swifttailor.describing import measure_facts
    from swifttailor.picture_reader.truth import Truth

    library = PatternLibrary.load()
    for k in range(0, len(library), 1500):
        pattern = library.pattern(k)
        truth, kept = Truth.of(pattern, measure_facts(pattern)), library.table[k]
        np.testing.assert_array_equal(kept.panels, truth.panels)
        assert (kept.statements != truth.statements).mean() < 0.02  # those on a border, by the rounding
        np.testing.assert_allclose(kept.boxes, truth.boxes, atol=0.15)
