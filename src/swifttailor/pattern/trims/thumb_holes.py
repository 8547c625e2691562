"""Holes for the thumbs at the ends of long sleeves or their cuffs."""

from __future__ import annotations

import re

import numpy as np

from swifttailor.pattern.trims.chalk import Chalk
from swifttailor.pattern.trims.shapes import Patch, Trim
from swifttailor.pattern.trims.side_stripes import top_seams
from swifttailor.pattern.trims.sleeve_frames import into_cloth, seam_from_the_top

_FRONT = re.compile(r"(left|right)_sleeve_f$")
_HALF, _WIDE, _ABOVE, _BESIDE = 2.1, 0.75, 4.2, 2.2
"""Half the height of a hole and half its width, its middle's distance from the end and from the seam, cm."""
_LEAST, _POINTS = 46.0, 13
"""Shorter sleeves do not reach the hands, cm."""
_BORDER = 0.45
"""How wide the stitches around a hole are, cm."""


def thumb_holes(chalk: Chalk, name: str) -> list[Trim]:
    """An upright hole with a border, in front of the seam on top of each sleeve."""
    import shapely

    s, pieces = chalk.size, []
    pairs = top_seams(chalk.pattern)
    for pair in pairs:
        ref = next((ref for ref in pair if _FRONT.match(ref.panel)), None)
        if ref is None:
            return []
        panel = chalk.pattern.panel(ref.panel)
        seam = seam_from_the_top(panel, ref)
        lengths = np.linalg.norm(np.diff(seam, axis=0), axis=1)
        if float(lengths.sum()) < _LEAST * s:
            return []
        along = seam[-1] - seam[-6]
        along = along / np.linalg.norm(along)
        outline = panel.outline(0.05)
        across = into_cloth(along, seam, outline)
        middle = seam[-1] - _ABOVE * s * along + _BESIDE * s * across
        turn = np.linspace(0.0, np.pi, _POINTS)
        cloth = shapely.Polygon(outline)
        for border, look in ((_BORDER, "cloth"), (0.0, "hole")):
            high = middle - np.cos(turn)[:, None] * (_HALF + border) * s * along
            wide = np.maximum(np.sin(turn) ** 0.7, 0.03)[:, None] * (_WIDE + border) * s * across
            first, second = high - wide, high + wide
            if not cloth.covers(shapely.Polygon([*first, *second[::-1]])):
                return []
            if look == "hole":
                pieces.append(Patch(name, ref.panel, first, second, "hole", is_cut=False))
            else:
                pieces += _ring(name, ref.panel, first, second, border * s)
    return pieces if len(pairs) == 2 else []


def _ring(name: str, panel: str, first: np.ndarray, second: np.ndarray, wide: float) -> list[Trim]:
    """Stitches along both sides of a hole."""
    found: list[Trim] = []
    for line, other in ((first, second), (second, first)):
        way = other - line
        way = way / np.maximum(np.linalg.norm(way, axis=1, keepdims=True), 1e-9)
        share = np.minimum(np.linalg.norm(other - line, axis=1, keepdims=True) / 2, wide)
        found.append(Patch(name, panel, line, line + share * way, "dark", is_cut=False))
    return found
