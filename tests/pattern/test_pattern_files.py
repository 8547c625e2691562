"""Folders of patterns: what counts as one of them."""

from __future__ import annotations

from swifttailor.cli.size_files import patterns_of_sizes
from swifttailor.pattern import write_pattern
from swifttailor.pattern.drafts import draft
from swifttailor.pattern.pattern_list import count_patterns, pattern_files, read_patterns


def test_what_a_killed_program_left_half_written_is_no_pattern(tmp_path):
    for name in ("b", "a"):
        write_pattern(draft("fitted-skirt"), tmp_path / f"{name}.json")
    (tmp_path / ".a-k3j2h1.json").write_text('{"pattern": {"panels": {"sk')  # see atomic_files
    assert [path.name for path in pattern_files(tmp_path)] == ["a.json", "b.json"]
    assert count_patterns(tmp_path) == 2
    assert [entry.id for entry in read_patterns(tmp_path)] == ["a", "b"]
    assert [path.name for path in patterns_of_sizes(tmp_path)] == ["a.json", "b.json"]
