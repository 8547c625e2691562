"""Writer of GarmentCode's pattern JSON."""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING, Any

from swifttailor.atomic_files import write_text
from swifttailor.pattern.curve import Arc, Curve, Line, Quadratic
from swifttailor.pattern.panel import Panel

if TYPE_CHECKING:
    from swifttailor.pattern.pattern import EdgeRef, Pattern


def to_specification(pattern: Pattern) -> dict[str, Any]:
    """The pattern as GarmentCode's JSON object: cm, chord-relative curvature, loops in order.

    `read_specification` gives back exactly the same pattern: numbers are written with all their digits.
    """
    return {
        "pattern": {
            "panels": {p.name: _panel(p) for p in pattern.panels},
            "stitches": [
                [_side(s.first), _side(s.second), *(["right_wrong"] if s.right_wrong else [])]
                for s in pattern.stitches
            ],
            "panel_order": [p.name for p in pattern.panels],
        },
        "parameters": {},
        "parameter_order": [],
        "properties": {
            "curvature_coords": "relative",
            "normalize_panel_translation": False,
            "normalized_edge_loops": True,
            "units_in_meter": 100,
            **({} if pattern.drafted_for is None else {"drafted_for": pattern.drafted_for.to_json()}),
            **({"cloth_stretch": pattern.cloth_stretch} if pattern.cloth_stretch else {}),
            **({"trims": list(pattern.trims)} if pattern.trims else {}),
            **({"button_count": pattern.button_count} if pattern.button_count else {}),
        },
    }


def write_pattern(pattern: Pattern, path: Path | str, *, overwrite: bool = False) -> Path:
    """Writes the pattern to a JSON file (see `to_specification`) and returns the path.

    Raises:
        InputError: It cannot be written, or there is another file of that name and not `overwrite`.
    """
    text = json.dumps(to_specification(pattern), indent=2, allow_nan=False) + "\n"
    return write_text(path, text, overwrite=overwrite)


def _panel(panel: Panel) -> dict[str, Any]:
    count = len(panel.edges)
    written: dict[str, Any] = {
        "translation": list(panel.placement.translation),
        "rotation": list(panel.placement.rotation),
        "vertices": panel.vertices.tolist(),
        "edges": [],
    }
    for k, edge in enumerate(panel.edges):
        entry: dict[str, Any] = {"endpoints": [k, (k + 1) % count]}
        if edge.label:
            entry["label"] = edge.label
        if not isinstance(edge.curve, Line):
            entry["curvature"] = _curvature(edge.curve)
        written["edges"].append(entry)
    if panel.label:
        written["label"] = panel.label
    return written


def _curvature(curve: Curve) -> dict[str, Any]:
    if isinstance(curve, Arc):
        return {"type": "circle", "params": [curve.radius, int(curve.large), int(curve.right)]}
    if isinstance(curve, Quadratic):
        return {"type": "quadratic", "params": [list(curve.control)]}
    assert not isinstance(curve, Line)
    return {"type": "cubic", "params": [list(curve.control_1), list(curve.control_2)]}


def _side(ref: EdgeRef) -> dict[str, Any]:
    return {"panel": ref.panel, "edge": ref.edge}
