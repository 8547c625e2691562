"""Style3D's pattern JSON, as GarmageNet's stitching network writes it."""

from __future__ import annotations

import json
import math
from collections.abc import Sequence
from pathlib import Path
from random import Random
from typing import Any

from fuzzing.mutation.byte_mutations import mutate_bytes
from fuzzing.mutation.json_mutations import mutate_json, written
from fuzzing.target import Feed, File, Target


def _panel(number: int, corners: int, points: int) -> dict[str, Any]:
    """A regular polygon whose sides bend a little, mm."""
    around = [2 * math.pi * k / corners for k in range(corners + 1)]
    edges = []
    for k in range(corners):
        shares = [i / (points - 1) for i in range(points)]
        angles = [around[k] * (1 - s) + around[k + 1] * s for s in shares]
        radii = [300 + 40 * math.sin(math.pi * s) for s in shares]
        controls = [[r * math.cos(a), r * math.sin(a), 0] for a, r in zip(angles, radii, strict=True)]
        edges.append({"bezierPoints": [[0, 0, 0]] * 2, "controlPoints": controls, "id": f"e{number}_{k}"})
    outline = {"type": 3, "circleType": 0, "edges": edges, "vertices": [e["controlPoints"][0] for e in edges]}
    return {"center": [10.0, 1500.0], "seqEdges": [outline], "id": f"p{number}", "label": f"{number:02d}"}


def _stitch(edge: int, share: float) -> list[dict[str, Any]]:
    def at(panel: int, parameter: float) -> dict[str, Any]:
        number = min(int(parameter), 3)
        return {"clothPieceId": f"p{panel}", "edgeId": f"e{panel}_{number}", "param": parameter - number}

    return [
        {"start": at(0, edge + 0.0), "end": at(0, edge + share), "isCounterClockWise": False},
        {"start": at(1, edge + share), "end": at(1, edge + 0.1), "isCounterClockWise": True},
    ]


def seeds() -> Sequence[File]:
    """Two panels sewn along whole edges, parts of edges and over corners."""
    made = []
    for corners, points, stitches in ((4, 2, ((0, 1.0), (2, 1.0))), (4, 6, ((0, 1.5), (2, 0.6))), (5, 9, ())):
        panels = [_panel(k, corners, points) for k in range(2)]
        made.append({"panels": panels, "stitches": [_stitch(*stitch) for stitch in stitches]})
    return [File(json.dumps(value).encode(), ".json") for value in made]


def mutate(file: File, random: Random) -> bytes:
    """Damage to the JSON or to the bytes."""
    if random.random() < 0.1:
        return mutate_bytes(file.data, random)
    return written(mutate_json(json.loads(file.data), random), random)


def _load() -> Feed:
    from swifttailor.data.released.stretches import cut_at_stitches
    from swifttailor.data.released.style3d_pattern import parse_style3d
    from swifttailor.pattern import Panel, Pattern, repair_pattern, to_specification
    from swifttailor.pattern.json_values import read_json_file

    def feed(path: Path) -> None:
        drawn = parse_style3d(read_json_file(path))
        outlines, stitches, _ = cut_at_stitches(drawn)
        named = zip(drawn.outlines, outlines, strict=True)
        panels = tuple(Panel(outline.name, cut.vertices, cut.edges) for outline, cut in named)
        repair = repair_pattern(Pattern(panels, tuple(stitches)), keep_places=True)
        json.dumps(to_specification(repair.pattern), allow_nan=False)

    return feed


TARGETS = (Target("style3d", "Style3D's patterns, of GarmageNet", seeds, mutate, _load, 20, in_ci=200),)
