"""Patches over the elbows of long sleeves."""

from __future__ import annotations

import re

import numpy as np

from swifttailor.pattern.trims.chalk import Chalk
from swifttailor.pattern.trims.shapes import Patch, Trim
from swifttailor.pattern.trims.side_stripes import top_seams
from swifttailor.pattern.trims.sleeve_frames import into_cloth, seam_from_the_top

_BACK = re.compile(r"(left|right)_sleeve_b$")
_ELBOW, _HALF_HEIGHT, _HALF_WIDTH = 34.0, 8.5, 5.5
"""How far the elbow lies below the armhole, along the sleeve; half of a patch, cm."""
_LEAST, _WIDEST, _POINTS = 46.0, 0.4, 17
"""Shorter sleeves have no elbow to cover; half a patch as a part of the sleeve's back at most."""


def elbow_patches(chalk: Chalk, name: str) -> list[Trim]:
    """An oval on the back of each sleeve; nothing where sleeves are short or cut in one with the body."""
    import shapely

    s, pieces = chalk.size, []
    for pair in top_seams(chalk.pattern):
        ref = next((ref for ref in pair if _BACK.match(ref.panel)), None)
        if ref is None:
            return []
        panel = chalk.pattern.panel(ref.panel)
        seam = seam_from_the_top(panel, ref)
        way = seam[-1] - seam[0]
        length = float(np.linalg.norm(way))
        if length < _LEAST * s:
            return []
        along = way / length
        outline = panel.outline(0.05)
        across = into_cloth(along, seam, outline)
        at = seam[0] + _ELBOW * s * along
        cloth = shapely.Polygon(outline)
        crossed = cloth.intersection(shapely.LineString([at - 60 * across, at + 60 * across]))
        if crossed.is_empty:
            return []
        middle = np.array(crossed.centroid.coords[0])
        half = min(_HALF_WIDTH * s, _WIDEST * crossed.length)
        turn = np.linspace(0.0, np.pi, _POINTS)
        high = middle - np.cos(turn)[:, None] * _HALF_HEIGHT * s * along
        wide = np.maximum(np.sin(turn) ** 0.7, 0.02)[:, None] * half * across
        first, second = high - wide, high + wide
        if not cloth.covers(shapely.Polygon([*first, *second[::-1]])):
            return []
        pieces.append(Patch(name, ref.panel, first, second))
    return pieces
