from __future__ import annotations

import json

import pytest
from hypothesis import given, settings
from pattern_strategies import patterns

from swifttailor.errors import InputError
from swifttailor.pattern import load_pattern, read_specification, to_specification, write_pattern


@settings(max_examples=60, deadline=None)
@given(patterns())
def test_what_is_written_reads_back_exactly(pattern):
    text = json.dumps(to_specification(pattern), allow_nan=False)
    reading = read_specification(json.loads(text), name=pattern.name)
    assert reading.findings == ()
    assert reading.pattern == pattern
    assert json.dumps(to_specification(reading.pattern)) == text


def test_the_file_has_garmentcodes_keys(square_pattern):
    written = to_specification(square_pattern)
    assert list(written) == ["pattern", "parameters", "parameter_order", "properties"]
    assert written["properties"] == {
        "curvature_coords": "relative",
        "normalize_panel_translation": False,
        "normalized_edge_loops": True,
        "units_in_meter": 100,
    }
    front = written["pattern"]["panels"]["front"]
    assert [e["endpoints"] for e in front["edges"]] == [[0, 1], [1, 2], [2, 3], [3, 0]]
    assert "label" not in front and "curvature" not in front["edges"][0]
    assert written["pattern"]["stitches"][0] == [{"panel": "front", "edge": 1}, {"panel": "back", "edge": 1}]


def test_files_are_written_whole_and_read_back(square_pattern, tmp_path):
    path = write_pattern(square_pattern, tmp_path / "new" / "tube.json")
    assert load_pattern(path) == square_pattern
    assert path.read_text().endswith("}\n")
    assert [p.name for p in path.parent.iterdir()] == ["tube.json"]
    assert square_pattern.save(path) == path


def test_a_folder_in_the_way_is_an_input_error(square_pattern, tmp_path):
    (tmp_path / "taken.json").mkdir()
    with pytest.raises(InputError, match="Cannot write"):
        write_pattern(square_pattern, tmp_path / "taken.json")
    (tmp_path / "file").write_text("")
    with pytest.raises(InputError, match="Cannot write"):
        write_pattern(square_pattern, tmp_path / "file" / "x.json")
