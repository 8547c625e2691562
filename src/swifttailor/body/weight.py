"""The girth that a weight implies: that of the likeliest body of a height which weighs as much."""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from swifttailor.body.body import Body
from swifttailor.body.made_to_measure import body_to_measure

KG_PER_LITRE = 1.01
"""Density of people, between breathing in and out."""
USUAL_HEIGHTS = {"women": 168.0, "men": 178.0}
"""Of the size charts, cm; for whom only a weight is said."""
_SLIMMEST, _STOUTEST = 0.34, 0.84
"""Waists that are sought, as shares of the height."""
_ROUNDS = 12


def kilograms(body: Body) -> float:
    """What a person of this shape weighs."""
    corners = body.vertices[body.faces]
    volume = np.einsum("ij,ij->i", corners[:, 0], np.cross(corners[:, 1], corners[:, 2])).sum() / 6.0
    return float(abs(volume)) / 1000.0 * KG_PER_LITRE


@lru_cache(maxsize=32)
def waist_of_weight(kg: float, height: float, figure: str | None) -> float:
    """The waist of the likeliest body of a height that has a weight, cm; the nearest that one can have.

    Args:
        kg: Weight.
        height: In cm.
        figure: ``women``, ``men`` or ``children``; adults near the default body when None.
    """
    low, high = _SLIMMEST * height, _STOUTEST * height
    for _ in range(_ROUNDS):
        waist = (low + high) / 2.0
        made = body_to_measure({"height": height, "waist": waist}, figure=figure, nearest=True)
        if kilograms(made.body) < kg:
            low = waist
        else:
            high = waist
        if high - low < 0.2:
            break
    return round((low + high) / 2.0, 1)
