"""The same pattern as the older files of the family write it."""

from __future__ import annotations

import copy
from typing import Any


def in_older_dialect(specification: dict[str, Any]) -> dict[str, Any]:
    """Absolute control points, one quadratic point as a bare list, no labels, no order, no names of kinds."""
    value = copy.deepcopy(specification)
    value["properties"] = {"curvature_coords": "absolute", "units_in_meter": 100}
    value["pattern"].pop("panel_order", None)
    for panel in value["pattern"]["panels"].values():
        panel.pop("label", None)
        for edge in panel["edges"]:
            edge.pop("label", None)
            curvature = edge.get("curvature")
            if not isinstance(curvature, dict) or curvature["type"] == "circle":
                continue
            start, end = (panel["vertices"][k] for k in edge["endpoints"])
            points = [_absolute(p, start, end) for p in curvature["params"]]
            edge["curvature"] = points[0] if len(points) == 1 else {"type": "cubic", "params": points}
    return value


def _absolute(point: list[float], start: list[float], end: list[float]) -> list[float]:
    x, y = end[0] - start[0], end[1] - start[1]
    return [start[0] + point[0] * x - point[1] * y, start[1] + point[0] * y + point[1] * x]
