"""Trims in the files of patterns, and as names in a pattern."""

from __future__ import annotations

import json
import time
from dataclasses import replace

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from swifttailor.cli.check import Check
from swifttailor.cli.main import run
from swifttailor.errors import PatternError
from swifttailor.pattern import load_pattern, read_specification, to_specification
from swifttailor.pattern.drafts import draft
from swifttailor.pattern.trims import LIKE_EACH_OTHER, TRIMS, trims_read

JEANS = draft("jeans")
WRONG = [
    None, 7, True, "zip", {}, {"zip": True}, [7], [None], [["zip"]], ["zip", 1], ["zipper"], ["Zip"],
    ["zip "], [""], ["zip"] * 10_000, ["x" * 10_000_000], [[]] * 100_000, [{"name": "zip"}],
    float("nan"), 10**400,
]  # fmt: skip


@settings(max_examples=60, deadline=None)
@given(st.lists(st.sampled_from(list(TRIMS)), unique=True))
def test_written_and_read_again(names):
    pattern = replace(JEANS, trims=tuple(names))
    written = json.loads(json.dumps(to_specification(pattern)))
    assert ("trims" in written["properties"]) == bool(names)
    read = read_specification(written).pattern
    assert read.trims == tuple(names)
    assert read == JEANS  # they are no part of how it is cut


def test_saved_and_loaded(tmp_path):
    pattern = replace(JEANS, trims=("fly", "back pockets"))
    assert load_pattern(pattern.save(tmp_path / "p.json")).trims == ("fly", "back pockets")


def test_named_twice_is_named_once():
    assert trims_read(["zip", "fly", "zip"]) == ("zip", "fly")


def test_files_without_them_are_read_as_before():
    written = to_specification(JEANS)
    assert "trims" not in written["properties"]
    assert read_specification(written).pattern.trims == ()
    del written["properties"]
    assert read_specification(written).pattern.trims == ()


@pytest.mark.parametrize("raw", WRONG, ids=lambda raw: str(raw)[:20])
def test_anything_else_is_refused_at_once(raw):
    written = to_specification(JEANS)
    written["properties"]["trims"] = raw
    started = time.monotonic()
    with pytest.raises(PatternError, match=r"properties\.trims") as refused:
        read_specification(written)
    assert time.monotonic() - started < 2
    text = str(refused.value)
    assert f"ll {len(TRIMS)} are listed in docs/trims.md" in text
    assert len(text) < 300


@pytest.mark.parametrize(
    ("written", "meant"), [("zipper", "zip"), ("Tie Belt", "tie belt"), ("long-train", "long train")]
)
def test_names_like_a_misspelt_one_are_told(written, meant):
    with pytest.raises(PatternError, match=f"Names like it: .*{meant}"):
        trims_read([written])


json_values = st.recursive(
    st.none()
    | st.booleans()
    | st.integers()
    | st.floats()
    | st.text(max_size=8)
    | st.sampled_from(list(TRIMS)),
    lambda inner: st.lists(inner, max_size=4) | st.dictionaries(st.text(max_size=4), inner, max_size=3),
    max_leaves=8,
)


@settings(max_examples=300, deadline=None)
@given(json_values)
def test_anything_is_read_or_refused(raw):
    try:
        names = trims_read(raw)
    except PatternError:
        return
    assert isinstance(raw, list) and set(names) == set(raw) <= set(TRIMS)
    assert len(set(names)) == len(names)


@pytest.mark.parametrize("raw", ["zip", ["zipper"], [7]])
def test_check_refuses_them_too(raw, tmp_path, capsys):
    written = to_specification(JEANS)
    written["properties"]["trims"] = raw
    path = tmp_path / "p.json"
    path.write_text(json.dumps(written))
    assert run(["check", str(path)]) == 2
    said = " ".join("".join(capsys.readouterr()).split())
    assert "properties.trims" in said and "docs/trims.md" in said and "Traceback" not in said


def test_check_takes_right_ones(tmp_path, capsys):
    path = replace(JEANS, trims=tuple(TRIMS)).save(tmp_path / "p.json")
    assert Check(path).run() == 0
    assert "nothing to report" in capsys.readouterr().out


def test_names_are_what_people_say():
    assert all(name == name.strip().lower() and len(said) > 3 for name, said in TRIMS.items())
    for group in LIKE_EACH_OTHER:
        assert len(group) == len(set(group)) > 1 and set(group) <= set(TRIMS)
    assert len(set(map(frozenset, LIKE_EACH_OTHER))) == len(LIKE_EACH_OTHER)
