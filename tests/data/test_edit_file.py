"""Files of edits: GarmentCode's lines and pairs written here are read by one function."""

from __future__ import annotations

import gzip
import json

import pytest

from swifttailor.data.edits.edit_file import pair_line, read_edits
from swifttailor.data.edits.pairs import geometric_pairs, pairs_of
from swifttailor.data.pattern_source import parsed_pattern
from swifttailor.describing import measure_facts
from swifttailor.errors import InputError
from swifttailor.pattern import to_specification
from swifttailor.pattern.drafts import draft


def edit_line(id, base, pattern):
    return {"id": id, "base": base, "pattern": to_specification(pattern)}


def test_lines_with_a_base_come_in_their_order(tmp_path):
    wanted = {"e1": ("skirt", draft("fitted-skirt", length=70)), "e2": ("top", draft("t-shirt"))}
    path = tmp_path / "edits.jsonl.gz"
    with gzip.open(path, "wt") as stream:
        for id, (base, pattern) in wanted.items():
            stream.write(json.dumps({**edit_line(id, base, pattern), "edits": [{"path": "a.b"}]}) + "\n")
    found = list(read_edits(path))
    assert [(v.pattern.id, v.base) for v in found] == [("e1", "skirt"), ("e2", "top")]
    for version in found:
        assert parsed_pattern(version.pattern).canonical() == wanted[version.pattern.id][1].canonical()


def test_a_pair_and_the_same_the_other_way_are_one_version(tmp_path):
    base = draft("hoodie")
    pairs = geometric_pairs(base, 3, count=3)
    lines = [pair_line(f"h/{p.source}", "h", p) for p in pairs]
    path = tmp_path / "pairs.jsonl"
    path.write_bytes(b"".join(lines))
    found = list(read_edits(path))
    assert len(lines) == 2 * len(found) == 6 and {v.base for v in found} == {"h"}
    there = [p for p in pairs if not p.source.endswith("reversed")]
    for version, pair in zip(found, there, strict=True):
        assert version.pattern.id == f"h/{pair.source}"
        again = parsed_pattern(version.pattern)
        assert measure_facts(again) == measure_facts(pair.edited) != measure_facts(base)
    # Where there are words for the way back only, its first pattern is the edited version.
    path.write_bytes(lines[1])
    (back,) = read_edits(path)
    assert back.base == "h" and parsed_pattern(back.pattern) == parsed_pattern(found[0].pattern)


def test_a_line_of_a_pair_says_what_the_pair_is():
    pair = pairs_of(draft("fitted-skirt"), draft("fitted-skirt", length=90), 1, source="design")[0]
    line = pair_line("ünique", "skirt", pair)
    value = json.loads(line)
    assert line.endswith(b"\n") and line.count(b"\n") == 1
    assert list(value) == ["id", "base", "source", "instruction", "changes", "pattern", "edited"]
    assert (value["id"], value["base"], value["source"]) == ("ünique", "skirt", "design")
    assert value["instruction"] == pair.instruction.text
    assert value["changes"] == [c.to_json() for c in pair.instruction.changes]
    assert value["pattern"] == json.loads(json.dumps(to_specification(pair.base)))


@pytest.mark.parametrize("base", [None, 7, ""])
def test_lines_that_cannot_be_used_say_why(base, tmp_path):
    path = tmp_path / "edits.jsonl"
    good = edit_line("good", "skirt", draft("fitted-skirt"))
    path.write_text("\n".join([json.dumps(good | {"id": "bad", "base": base}), "no json", json.dumps(good)]))
    bad, broken, last = read_edits(path)
    assert (bad.base, bad.pattern.id) == ("", "bad") and repr(base) in bad.pattern.error
    assert isinstance(parsed_pattern(bad.pattern), InputError)
    assert broken.base == "" and "line 2" in broken.pattern.error
    assert last.base == "skirt" and not last.pattern.error


def test_a_folder_is_no_file_of_edits(tmp_path):
    with pytest.raises(InputError, match=r"no file of edits.*\.jsonl"):
        next(read_edits(tmp_path))
    with pytest.raises(InputError, match="There is no file"):
        next(read_edits(tmp_path / "none.jsonl"))
