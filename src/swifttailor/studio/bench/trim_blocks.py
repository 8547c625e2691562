"""Pockets, buttons and the like of a garment: as parts of its mesh file, and as marks on its panels."""

from __future__ import annotations

from typing import Any

import numpy as np

from swifttailor.arrays import Array
from swifttailor.errors import SwiftTailorError
from swifttailor.garment.garment import Garment
from swifttailor.garment.trim_parts import trim_parts
from swifttailor.pattern import Pattern
from swifttailor.pattern.trims import Belt, Bow, Button, Frill, Layer, Stirrup, Trim, place_trims

_KNOT = 9.0
"""A bow's width over the radius of the mark of its knot."""


def trim_blocks(garment: Garment) -> tuple[list[dict[str, Any]], dict[str, Array]]:
    """What a mesh file says of a garment's trims, and the blocks that they lie in, one after the other.

    Returns:
        For each part its name, look and numbers of vertices, triangles and lines. By block: (n, 3) positions,
        cm; (n, 2) panel-local cm; (n,) indices of panels; (t, 3) and (k, 2) vertices, counted within their
        part. Nothing of a garment without trims.
    """
    parts = trim_parts(garment)
    if not parts:
        return [], {}
    infos = [
        {
            "name": part.name,
            "look": part.look,
            "on_panel": part.flat is not None,
            "vertices": len(part.vertices),
            "triangles": len(part.faces),
            "lines": len(part.lines),
            **({"color": part.color} if part.is_own_color else {}),
        }
        for part in parts
    ]
    flats = [np.zeros((len(part.vertices), 2)) if part.flat is None else part.flat for part in parts]
    panels = [np.zeros(len(part.vertices), int) if part.panel is None else part.panel for part in parts]
    blocks = {
        "trim_positions": np.concatenate([part.vertices for part in parts]),
        "trim_uv": np.concatenate(flats),
        "trim_panel": np.concatenate(panels),
        "trim_triangles": np.concatenate([part.faces for part in parts]),
        "trim_lines": np.concatenate([part.lines for part in parts]),
    }
    return infos, blocks


def trim_marks(pattern: Pattern) -> list[dict[str, Any]]:
    """Where the trims of a pattern lie on its panels: `models.documents.TrimMark`.

    Belts and frills lie on no panel. A pattern that cannot be measured, as while a point of it is dragged,
    has no marks.
    """
    if not pattern.trims:
        return []
    try:
        return [mark for piece in place_trims(pattern) for mark in _mark(piece)]
    except (SwiftTailorError, ArithmeticError, ValueError):
        return []


def _mark(piece: Trim) -> list[dict[str, Any]]:
    if isinstance(piece, Belt | Frill | Layer | Stirrup):
        return []
    common = {"trim": piece.trim, "panel": piece.panel}
    if isinstance(piece, Button):
        return [common | {"kind": "button", "points": _rounded([piece.at]), "radius": round(piece.radius, 2)}]
    if isinstance(piece, Bow):
        knot = round(piece.width / _KNOT, 2)
        return [common | {"kind": "button", "points": _rounded([piece.at]), "radius": knot}]
    if piece.is_cut:
        return [common | {"kind": "outline", "points": _rounded(piece.outline), "radius": 0.0}]
    kind = "zip" if piece.look == "metal" else "line"
    return [common | {"kind": kind, "points": _rounded((piece.first + piece.second) / 2), "radius": 0.0}]


def _rounded(points: Any) -> list[tuple[float, float]]:
    """(n, 2) panel-local cm to a tenth of a millimetre, as JSON."""
    return [(round(float(x), 2), round(float(y), 2)) for x, y in points]
