"""Sewing patterns: for the reader alone, and for what works on a pattern that could be read."""

from __future__ import annotations

import gzip
import io
import json
import marshal
import zlib
from collections.abc import Sequence
from contextlib import redirect_stdout
from functools import cache
from pathlib import Path
from random import Random
from typing import Any

from fuzzing.mutation.byte_mutations import mutate_bytes
from fuzzing.mutation.json_mutations import mutate_json, written
from fuzzing.mutation.older_dialect import in_older_dialect
from fuzzing.mutation.panel_mutations import mutate_pattern
from fuzzing.target import Feed, File, Target
from swifttailor.errors import SwiftTailorError

_REAL = Path(__file__).parents[2] / "tests" / "garmentcode_patterns" / "patterns.jsonl.gz"
_DRAFTS = ("fitted-skirt", "t-shirt", "hoodie", "trousers")
_TINY_SEWER = Path(__file__).parents[2] / "tests" / "garment_sewer" / "tiny_sewer.onnx"
_BY_TEXT = 8
"""One in so many patterns also goes through the command, which prints for people."""
_EDGE_LENGTHS = (2.0, 5.0, 5.0, 8.0)
"""Of meshes, cm, drawn by lot: most of the time goes into fine ones, and coarse ones fail as well."""


def _tube() -> dict[str, Any]:
    """Two rectangles sewn at both sides: the smallest garment."""
    corners = [[-20, 0], [20, 0], [20, 60], [-20, 60]]
    edges = [{"endpoints": [k, (k + 1) % 4]} for k in range(4)]
    panels = {
        name: {"vertices": corners, "edges": edges, "translation": [0, 80, z], "rotation": [0, turn, 0]}
        for name, z, turn in (("front", 25, 0), ("back", -25, 180))
    }
    stitches = [[{"panel": "front", "edge": a}, {"panel": "back", "edge": b}] for a, b in ((1, 3), (3, 1))]
    properties = {"curvature_coords": "relative", "units_in_meter": 100, "normalize_panel_translation": False}
    return {"pattern": {"panels": panels, "stitches": stitches}, "properties": properties}


def seeds() -> Sequence[File]:
    """Small patterns, drafts and patterns of GarmentCode, some of them in the older dialect too."""
    from swifttailor.pattern import to_specification
    from swifttailor.pattern.drafts import draft

    drafts = [json.loads(json.dumps(to_specification(draft(name)))) for name in _DRAFTS]
    with gzip.open(_REAL) as lines:
        real = sorted((json.loads(line)["pattern"] for line in lines), key=lambda p: len(json.dumps(p)))
    small = [_tube(), _tube(), drafts[0], drafts[0], real[0], real[0], real[1], real[2]]
    values = [
        *small,
        *drafts,
        *(in_older_dialect(v) for v in (*small[1::2], *drafts, *real[3:6])),
        *real[3:10],
    ]
    return [File(json.dumps(v).encode(), ".json") for v in values]


@cache
def _packed(data: bytes) -> bytes:
    return marshal.dumps(json.loads(data))


def mutate(file: File, random: Random) -> bytes:
    """Damage to the geometry, to the JSON, to the bytes, or to several of these."""
    way = random.random()
    if way < 0.1:
        return mutate_bytes(file.data, random)
    value = marshal.loads(_packed(file.data))
    if way < 0.75:
        value = mutate_pattern(value, random)
    if way > 0.6:
        value = mutate_json(value, random)
    data = written(value, random)
    return mutate_bytes(data, random, 2) if random.random() < 0.03 else data


def _load_reader() -> Feed:
    from swifttailor.pattern import read_pattern_file, to_specification

    def feed(path: Path) -> None:
        reading = read_pattern_file(path)
        _require_json([finding.to_json() for finding in reading.findings])
        _require_json(to_specification(reading.pattern))

    return feed


def _load_check() -> Feed:
    from swifttailor.body import Body
    from swifttailor.body.probe import probe_body
    from swifttailor.pattern import check_pattern, read_pattern_file

    body = probe_body(Body.default())

    def feed(path: Path) -> None:
        if zlib.crc32(path.read_bytes()) % _BY_TEXT == 0:
            return _command("check", str(path))
        reading = read_pattern_file(path)
        findings = check_pattern(reading.pattern, reader_findings=reading.findings, body=body)
        _require_json([finding.to_json() for finding in findings])

    return feed


def _load_repair() -> Feed:
    from swifttailor.body import Body
    from swifttailor.body.probe import probe_body
    from swifttailor.pattern import read_pattern_file, repair_pattern, to_specification

    body = probe_body(Body.default())

    def feed(path: Path) -> None:
        if zlib.crc32(path.read_bytes()) % _BY_TEXT == 0:
            return _command(
                "check", str(path), "--overwrite", "--repair", str(path.with_name("repaired.json"))
            )
        reading = read_pattern_file(path)
        repair = repair_pattern(reading.pattern, reading.findings, body=body)
        _require_json([found.to_json() for found in (*repair.remaining, *repair.changes)])
        _require_same(repair.pattern, _require_json(to_specification(repair.pattern)))

    return feed


def _load_sew() -> Feed:
    import numpy as np

    from swifttailor.tailor import Tailor

    tailor = Tailor.load(garment_sewer=_TINY_SEWER)

    def feed(path: Path) -> None:
        drawn = zlib.crc32(path.read_bytes())
        made = tailor.sew(path, repair=drawn % 2 == 0, edge_length=_EDGE_LENGTHS[drawn // 2 % 4])
        if not np.isfinite(made.garment.vertices).all():
            raise AssertionError("the garment has vertices that are not finite")

    return feed


def _require_json(value: Any) -> Any:
    """The value as it is read back from JSON; NaN and Infinity are no JSON."""
    return json.loads(json.dumps(value, allow_nan=False))


def _require_same(pattern: Any, specification: Any) -> None:
    from swifttailor.pattern import read_specification

    try:
        read = read_specification(specification).pattern
    except SwiftTailorError as error:
        raise AssertionError(f"the repaired pattern cannot be read back: {error}") from error
    if read != pattern:
        raise AssertionError("the repaired pattern is read back as another one")


def _command(*arguments: str) -> None:
    """Runs ``swifttailor`` without printing."""
    from swifttailor.cli.main import run

    with redirect_stdout(io.StringIO()):
        code = run([*arguments, "--debug"])
    if code not in (0, 1):
        raise AssertionError(f"swifttailor {arguments[0]} ends with {code}, and no error")


TARGETS = (
    Target("pattern", "sewing patterns: the reader", seeds, mutate, _load_reader, in_ci=2000),
    Target("check", "sewing patterns: swifttailor check", seeds, mutate, _load_check, 10, in_ci=300),
    Target("repair", "sewing patterns: check --repair", seeds, mutate, _load_repair, 20, in_ci=200),
    Target("sew", "sewing patterns: swifttailor sew", seeds, mutate, _load_sew, 30, 1500, in_ci=30),
)
