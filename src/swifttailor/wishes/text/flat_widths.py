"""Widths that are told of clothes laid flat, which are half of what goes around: "21 cm across the hem"."""

from __future__ import annotations

import re
from collections.abc import Mapping

_FLAT = re.compile(
    r"(?<!\w)(?:across|flat|half|pit to pit|p2p|armpit to armpit|underarm to underarm|side to side"
    r"|seam to seam|liegend|halbe?|à plat|en plano|in piano|plat)(?!\w)"
)
_WIDE = re.compile(r"(?<!\w)(?:wide|width|breit|de large|de ancho|breed|largo)(?!\w)")
_ROUND = re.compile(
    r"(?<!\w)(?:round|around|circumference|all the way|total|rundum|umfang|\w+umfang|tour|sweep|giro)(?!\w)"
)
_WIDTHS: Mapping[str, tuple[float, float, float]] = {
    "leg_width_cm": (26.0, 34.0, 46.0),
    "hem_cm": (72.0, 80.0, 130.0),
    "chest_cm": (66.0, 72.0, 92.0),
}
"""Up to which numbers, cm, nobody means all around; nor who calls it wide; nor who says that it lies flat.

No foot goes through the first, no hips, no shoulders.
"""


def all_around(claim: str, value: float, clause: str) -> float:
    """A width as it is all around, cm.

    Args:
        claim: That it is of.
        value: As it is told, cm.
        clause: What is said of it, in lower case.
    """
    if claim not in _WIDTHS:
        return value
    least, wide, flat = _WIDTHS[claim]
    most = flat if _FLAT.search(clause) else wide if _WIDE.search(clause) else least
    is_flat = value < most and (most == flat or not _ROUND.search(clause))
    return round(2.0 * value, 2) if is_flat else value
