"""Whatever is in the file, the reader gives a pattern or one of our errors, soon and without much memory."""

from __future__ import annotations

import copy
import json
import math
import time
import tracemalloc

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from pattern_strategies import patterns

from swifttailor.errors import InputError, PatternError, SwiftTailorError
from swifttailor.pattern import (
    Pattern,
    check_pattern,
    read_pattern_file,
    read_specification,
    repair_pattern,
    to_specification,
)
from swifttailor.pattern.json_values import MAX_FILE_BYTES, parse_json

FUZZED = settings(
    max_examples=100, deadline=None, suppress_health_check=[HealthCheck.too_slow, HealthCheck.data_too_large]
)
SECONDS, BYTES = 10.0, 1_000_000_000
SHARE = 32
"""Part of the largest file that is tried: time and memory grow in proportion, and tracing is slow."""

scalars = (
    st.none()
    | st.booleans()
    | st.integers()
    | st.integers(min_value=10**300, max_value=10**310)
    | st.floats()
    | st.text(max_size=8)
    | st.sampled_from(["right_wrong", "circle", "quadratic", "cubic", "absolute", -0.0, 1e-300, 1e300, 1e7])
)
json_values = st.recursive(
    scalars,
    lambda inner: (
        st.lists(inner, max_size=4)
        | st.dictionaries(
            st.sampled_from(
                "pattern panels stitches panel_order properties vertices edges endpoints curvature type "
                "params label translation rotation units_in_meter curvature_coords panel edge".split()
            )
            | st.text(max_size=5),
            inner,
            max_size=6,
        )
    ),
    max_leaves=25,
)


def read_or_refuse(specification):
    """Reads, and checks and repairs what could be read; any other exception fails the test."""
    started = time.process_time()
    try:
        reading = read_specification(specification)
    except SwiftTailorError as error:
        assert str(error) and len(str(error)) < 2000
        return None
    finally:
        assert time.process_time() - started < SECONDS
    assert isinstance(reading.pattern, Pattern) and reading.pattern.panels
    for finding in reading.findings:
        assert finding.code and finding.message and json.dumps(finding.to_json(), allow_nan=False)
    json.dumps(to_specification(reading.pattern), allow_nan=False)
    findings = check_pattern(reading.pattern, reader_findings=reading.findings)
    for finding in findings:
        assert json.dumps(finding.to_json(), allow_nan=False)
    mended = repair_pattern(reading.pattern, reading.findings)
    written = to_specification(mended.pattern)
    assert read_specification(json.loads(json.dumps(written, allow_nan=False))).pattern == mended.pattern
    assert time.process_time() - started < SECONDS
    return reading


@FUZZED
@given(json_values)
def test_any_json_value(value):
    read_or_refuse(value)


@FUZZED
@given(st.dictionaries(st.sampled_from(["panels", "stitches", "panel_order"]), json_values), json_values)
def test_any_values_inside_a_pattern(body, properties):
    read_or_refuse({"pattern": body, "properties": properties})


def _places(value, path=()):
    yield path
    items = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, inner in items:
        yield from _places(inner, (*path, key))


@FUZZED
@given(patterns(), st.data())
def test_mutated_patterns(pattern, data):
    written = json.loads(json.dumps(to_specification(pattern)))
    for _ in range(data.draw(st.integers(1, 4))):
        path = data.draw(st.sampled_from(list(_places(written))))
        if not path:
            continue
        holder = written
        for key in path[:-1]:
            holder = holder[key]
        change = data.draw(st.sampled_from(["delete", "replace", "duplicate", "number"]))
        if change == "delete":
            del holder[path[-1]]
        elif change == "replace":
            holder[path[-1]] = data.draw(json_values)
        elif change == "number":
            holder[path[-1]] = data.draw(st.sampled_from([0, 1, -1, 1e-9, 1e7, -1e7, 0.5, 3, 2.0]))
        elif isinstance(holder, list):
            holder.insert(path[-1], copy.deepcopy(holder[path[-1]]))
        else:
            holder[f"{path[-1]}_again"] = copy.deepcopy(holder[path[-1]])
    read_or_refuse(written)


@settings(max_examples=100, deadline=None)
@given(patterns(), st.data())
def test_files_cut_short_or_with_a_changed_byte(pattern, data):
    raw = json.dumps(to_specification(pattern)).encode()
    cut = data.draw(st.integers(0, len(raw) - 1))
    changed = raw[:cut] + bytes([data.draw(st.integers(0, 255))]) + raw[cut + 1 :]
    with pytest.raises(InputError):
        parse_json(raw[:cut], "cut.json")
    try:
        read_or_refuse(parse_json(changed, "changed.json"))
    except InputError as error:
        assert "changed.json" in str(error)


@FUZZED
@given(st.binary(max_size=200))
def test_any_bytes(raw):
    try:
        read_or_refuse(parse_json(raw, "noise"))
    except InputError as error:
        assert "noise" in str(error)


BAD_FILES = {
    "empty": (b"", "not JSON"),
    "brackets": (b"[" * 100_000, "nested too deeply"),
    "braces": (b'{"a":' * 100_000, "nested too deeply"),
    "nan": (b'{"pattern": NaN}', "NaN"),
    "infinity": (b'{"pattern": [-Infinity]}', "Infinity"),
    "huge integer": (b'{"pattern": 1' + b"0" * 10_000 + b"}", "cannot be read"),
    "duplicate keys": (b'{"pattern": {"panels": {}, "panels": {}}}', "'panels' occurs twice"),
    "png": (b"\x89PNG\r\n\x1a\n\x00\x00\xff\xfe", "PNG picture"),
    "latin-1": ('{"é": 1}'.encode("latin-1"), "not UTF-8"),
    "utf-16": ('{"pattern": {}}'.encode("utf-16"), "not UTF-8"),
    "zeros": (b"\x00" * 1000, "not JSON"),
    "two values": (b"{} {}", "not JSON"),
    "infinite float": (b'{"pattern": {"panels": {"a": {"vertices": [[1e999, 0]], "edges": []}}}}', "finite"),
    "large integer": (
        b'{"pattern": {"panels": {"a": {"vertices": [[1' + b"0" * 400 + b', 0]], "edges": []}}}}',
        "larger than any garment",
    ),
    "lone surrogate": (b'{"pattern": {"panels": {"\\ud800": {}}}}', "printable"),
    "list": (b"[]", "an object was expected"),
    "text": (b'"pattern"', "an object was expected"),
    "no pattern": (b"{}", "no 'pattern'"),
    "no panels": (b'{"pattern": {}}', "no 'panels'"),
    "empty panels": (b'{"pattern": {"panels": {}}}', "at least one panel"),
}


@pytest.mark.parametrize("name", BAD_FILES)
def test_files_that_are_no_pattern(name, tmp_path):
    raw, message = BAD_FILES[name]
    path = tmp_path / "p.json"
    path.write_bytes(raw)
    with pytest.raises((InputError, PatternError), match=message) as caught:
        read_pattern_file(path)
    assert str(path) in str(caught.value)


def test_a_byte_order_mark_is_no_fault(tmp_path, square_pattern):
    path = tmp_path / "p.json"
    path.write_bytes(b"\xef\xbb\xbf" + json.dumps(to_specification(square_pattern)).encode())
    assert read_pattern_file(path).pattern == square_pattern


def test_paths_that_are_no_file(tmp_path):
    with pytest.raises(InputError, match="not a file"):
        read_pattern_file(tmp_path)
    with pytest.raises(InputError, match="No such file"):
        read_pattern_file(tmp_path / "missing.json")
    with pytest.raises(InputError, match="not a file name"):
        read_pattern_file("zero\x00byte.json")
    large = tmp_path / "large.json"
    with large.open("wb") as file:
        file.truncate(MAX_FILE_BYTES + 1)
    with pytest.raises(InputError, match="at most 32 MB"):
        read_pattern_file(large)


@pytest.mark.parametrize("filler", [b"[],", b"0,", b"{},", b'"",', b"1e5,"])
def test_full_size_files_of_rubbish_stay_within_time_and_memory(filler, tmp_path):
    size = MAX_FILE_BYTES // SHARE
    raw = b'{"pattern": {"panels": [' + filler * (size // len(filler) - 20) + b"0]}}"
    path = tmp_path / "p.json"
    path.write_bytes(raw)
    tracemalloc.start()
    started = time.process_time()
    with pytest.raises(SwiftTailorError):
        read_pattern_file(path)
    elapsed, peak = time.process_time() - started, tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    # Tracing slows it down some ten times, other processes on the same cores by half again.
    assert SHARE * elapsed < 16 * SECONDS and SHARE * peak < BYTES


def test_extreme_but_finite_shapes_are_read_checked_and_repaired_in_time():
    """2,000 curved edges with corners and control points as far out as numbers are accepted."""
    count = 2000
    far = [[1e7 * math.cos(7 * k), 1e7 * math.sin(11 * k)] for k in range(count)]
    edges = [
        {"endpoints": [k, (k + 1) % count], "curvature": {"type": "cubic", "params": [[1e6, 5], [-1e6, 3]]}}
        for k in range(count)
    ]
    started = time.process_time()
    read_or_refuse({"pattern": {"panels": {"a": {"vertices": far, "edges": edges}}}})
    assert time.process_time() - started < SECONDS
