"""Skirts of several tapered panels: gores."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import partial
from itertools import pairwise

import numpy as np

from swifttailor.pattern.drafts.around_body import around
from swifttailor.pattern.drafts.cutting_table import CuttingTable
from swifttailor.pattern.drafts.figure import Halves
from swifttailor.pattern.drafts.outline import Outline

_LEAST_CLOSE = 8.0
"""Gores that flare less far below the hips do so from there, cm."""
_NARROWS = 0.035
"""How much narrower one that is close to the knee becomes, cm per cm."""


@dataclass(frozen=True)
class Gores:
    """How the skirt is cut."""

    length: float
    """Upper edge to hem, cm."""
    count: int
    """All around; of an odd number one more is in front."""
    flare: float
    """Width of the hem over that of the hips, cm around."""
    close: float = 0.0
    """Upper edge to where it begins to flare, cm; 0: from the hips on."""

    @property
    def faces(self) -> tuple[int, int]:
        """How many are in front and behind."""
        return self.count - self.count // 2, self.count // 2


def lay_gored_skirt(
    table: CuttingTable, waist: Halves, shape: Gores, top_y: float, *, hips: Halves, to_hips: float
) -> None:
    """Lays the gores ``skirt_panel_0`` ... from the wearer's right to the left, in front and then behind.

    Edges: hem, right, top, left; `sew_gores_to_band` sews the upper ones.

    Args:
        table: Where they go.
        waist: Half widths of the upper edge, cm.
        shape: The cut.
        top_y: World height of the upper edge, cm.
        hips: Half widths that it has there, cm.
        to_hips: Upper edge to the hips, cm.
    """
    ahead, behind = shape.faces
    # All edges widen alike, so that those at the sides are equally long.
    wider = max((hips.front - waist.front) / ahead, (hips.back - waist.back) / behind)
    if shape.close > 0 and ahead == behind:  # close all around: the side seams move back a little
        wider = (hips.front - waist.front + hips.back - waist.back) / (ahead + behind)
    for back, half, count in ((False, waist.front, ahead), (True, waist.back, behind)):
        top = 2 * half / count
        hip = top + 2 * wider
        hem = hip + shape.flare / shape.count
        gore = partial(_gore, top, hip, hem, shape.length, to_hips)
        if shape.close > to_hips + _LEAST_CLOSE:
            gore = partial(_trumpet_gore, top, hip, hem, shape.length, to_hips, shape.close)
        names = _names(shape.count, back=back)
        for k, name in enumerate(names):
            place = around((k + 0.5) / count)
            at, along = (v * [1.0, -1.0] for v in place) if back else place
            table.lay(
                name,
                gore(),
                label="leg",
                at=(at[0], top_y, at[1]),
                rotation=(0.0, math.degrees(np.arctan2(-along[1], along[0])), 0.0),
                back=back,
            )
        for one, other in pairwise(names):
            table.seam(f"{one}.right", f"{other}.left")
    front, rear = (_names(shape.count, back=back) for back in (False, True))
    table.seam(f"{front[0]}.left", f"{rear[0]}.left")
    table.seam(f"{front[-1]}.right", f"{rear[-1]}.right")


def sew_gores_to_band(table: CuttingTable, count: int) -> None:
    """Sews the gores to the lower edge of the waistband."""
    table.seam("wb_front.bottom", [f"{name}.top" for name in _names(count, back=False)])
    table.seam("wb_back.bottom", [f"{name}.top" for name in reversed(_names(count, back=True))])


def _names(count: int, *, back: bool) -> list[str]:
    """Of the gores of one face, from the wearer's right to the left."""
    ahead = count - count // 2
    return [f"skirt_panel_{k}" for k in (range(ahead, count) if back else range(ahead))]


def _trumpet_gore(top: float, hip: float, hem: float, length: float, to_hips: float, close: float) -> Outline:
    """One gore like `_gore` to the hips, that narrows a little down to `close` and flares below it."""
    knee = hip - min(_NARROWS * (close - to_hips), 0.2 * hip)
    below, out = length - close, (hem - knee) / 2
    side_y = -close - math.sqrt(max(below**2 - out**2, 1.0))
    outline = Outline(-hem / 2, side_y).quadratic("hem", (0.0, -2 * length - side_y), (hem / 2, side_y))
    outline.line("right", knee / 2, -close).line("right", hip / 2, -to_hips)
    low, high = (hip / 2, -0.6 * to_hips), (top / 2 + 0.225 * (hip - top), -0.3 * to_hips)
    outline.cubic("right", low, high, (top / 2, 0.0)).line("top", -top / 2, 0.0)
    outline.cubic("left", (-high[0], high[1]), (-low[0], low[1]), (-hip / 2, -to_hips))
    return outline.line("left", -knee / 2, -close).line("left", -hem / 2, side_y).closed()


def _gore(top: float, hip: float, hem: float, length: float, to_hips: float) -> Outline:
    """One gore, its upper edge around the origin: curved to the hips, straight to a hem that hangs level."""
    below = length - to_hips
    out = (hem - hip) / 2
    side_y = -to_hips - math.sqrt(max(below**2 - out**2, 1.0))
    outline = Outline(-hem / 2, side_y).quadratic("hem", (0.0, -2 * length - side_y), (hem / 2, side_y))
    outline.line("right", hip / 2, -to_hips)
    lean = 0.25 * out / max(below, 1.0) * to_hips
    low, high = (hip / 2 - lean, -0.6 * to_hips), (top / 2 + 0.225 * (hip - top), -0.3 * to_hips)
    outline.cubic("right", low, high, (top / 2, 0.0)).line("top", -top / 2, 0.0)
    outline.cubic("left", (-high[0], high[1]), (-low[0], low[1]), (-hip / 2, -to_hips))
    return outline.line("left", -hem / 2, side_y).closed()
