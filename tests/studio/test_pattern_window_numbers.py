"""The numbers that the studio's client is tested against are those of this package.

The client's tests run without Python and read ``studio-ui/src/pattern/geometry/python-numbers.json``. After a
change that is wanted, run this test with ``UPDATE_CLIENT_NUMBERS=1``.
"""

from __future__ import annotations

import json
import os
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

from swifttailor.pattern import curve as curves
from swifttailor.pattern import read_specification
from swifttailor.pattern.curve import Arc, Cubic, Curve, Line, Quadratic
from swifttailor.pattern.panel import Panel
from swifttailor.pattern.svg.placing import place_panel, shelves
from swifttailor.pattern.tidying.symmetry import OTHER_SIDE, distance, reflected

NUMBERS = Path(__file__).parents[2] / "studio-ui" / "src" / "pattern" / "geometry" / "python-numbers.json"
CUT, SHARE = 0.37, 0.3
OF_EACH_KIND = 3
"""Edges of each kind and pattern."""
FONT_MM = 12.0


def _shape(curve: Curve) -> dict[str, Any] | None:
    if isinstance(curve, Line):
        return None
    if isinstance(curve, Arc):
        return {"type": "circle", "params": [curve.radius, int(curve.large), int(curve.right)]}
    if isinstance(curve, Quadratic):
        return {"type": "quadratic", "params": [list(curve.control)]}
    assert isinstance(curve, Cubic)
    return {"type": "cubic", "params": [list(curve.control_1), list(curve.control_2)]}


def _edge(panel: Panel, number: int) -> dict[str, Any]:
    curve, chord = panel.edges[number].curve, panel.chord(number)
    at_share = float(curves.parameters_by_length(curve, chord, [SHARE])[0])
    first, second, point = curves.split(curve, chord, CUT)
    return {
        "panel": panel.name,
        "edge": number,
        "length": panel.edge_length(number),
        "at_share": at_share,
        "points": curves.evaluate(curve, chord, [0.25, 0.5, 0.9]).tolist(),
        "derivative": curves.derivative(curve, chord, [0.25])[0].tolist(),
        "box": curves.bounding_box(curve, chord).tolist(),
        "halves": [_shape(first), _shape(second)],
        "cut": point.tolist(),
    }


def _layout(panels: tuple[Panel, ...]) -> dict[str, Any]:
    placed = [place_panel(k, p, FONT_MM) for k, p in enumerate(panels)]
    corners, sheet = shelves(np.array([p.size for p in placed]), 30.0)
    return {
        "corners": corners.tolist(),
        "sheet": sheet.tolist(),
        "panels": [
            {
                "name": p.panel.name,
                "mirrored": p.mirrored,
                "low": p.low.tolist(),
                "size": p.size.tolist(),
                "caption": [p.caption.x, p.caption.y, p.caption.size],
            }
            for p in placed
        ],
    }


def numbers_of_package(real_samples) -> list[dict[str, Any]]:
    found = []
    for sample in real_samples("repository", every=1):
        pattern = read_specification(sample["pattern"], name=sample["id"]).pattern
        left = dict.fromkeys((Line, Quadratic, Cubic, Arc), OF_EACH_KIND)
        edges = []
        for panel in pattern.panels:
            for number, edge in enumerate(panel.edges):
                if left[type(edge.curve)]:
                    left[type(edge.curve)] -= 1
                    edges.append(_edge(panel, number))
        panels = {
            p.name: {
                "area": p.signed_area(),
                "box": p.bounding_box().tolist(),
                "world": p.to_world(p.vertices[:2]).tolist(),
            }
            for p in pattern.panels
        }
        names = [p.name for p in pattern.panels if OTHER_SIDE.get(p.name) in panels]
        apart = {n: distance(pattern.panel(n), reflected(pattern.panel(OTHER_SIDE[n]), n)) for n in names}
        found.append(
            {
                "id": sample["id"],
                "edges": edges,
                "panels": panels,
                "apart": apart,
                "layout": _layout(pattern.panels),
            }
        )
    return found


def test_the_clients_numbers_are_the_packages(real_samples):
    numbers = numbers_of_package(real_samples)
    assert len(numbers) == 20 and sum(len(n["edges"]) for n in numbers) > 100
    if os.environ.get("UPDATE_CLIENT_NUMBERS"):
        NUMBERS.write_text(json.dumps(_short(numbers), separators=(",", ":")) + "\n")
    differences = list(_differences(json.loads(NUMBERS.read_text()), numbers, "numbers"))
    assert not differences, differences[:5]


def _short(value: Any) -> Any:
    """Numbers to 1e-10."""
    if isinstance(value, float):
        return round(value, 10) + 0.0
    if isinstance(value, list):
        return [_short(v) for v in value]
    return {k: _short(v) for k, v in value.items()} if isinstance(value, dict) else value


def _differences(kept: Any, now: Any, where: str) -> Iterator[str]:
    """Places where values differ; numbers by more than 1e-7, since processors differ in the last digits."""
    if isinstance(now, dict) and isinstance(kept, dict) and kept.keys() == now.keys():
        for key in now:
            yield from _differences(kept[key], now[key], f"{where}.{key}")
    elif isinstance(now, list) and isinstance(kept, list) and len(kept) == len(now):
        for k, (a, b) in enumerate(zip(kept, now, strict=True)):
            yield from _differences(a, b, f"{where}[{k}]")
    elif isinstance(now, int | float) and isinstance(kept, int | float):
        if abs(kept - now) > 1e-7:
            yield f"{where}: {kept} was kept, {now} is computed"
    elif kept != now:
        yield f"{where}: {kept!r} was kept, {now!r} is computed"
