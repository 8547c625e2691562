"""Patches over the knees of trousers."""

from __future__ import annotations

from swifttailor.pattern.drafts.figure import KNEE_PER_CROTCH
from swifttailor.pattern.trims.chalk import Chalk
from swifttailor.pattern.trims.shapes import Trim

_WIDTH, _HEIGHT = 17.0, 22.0
_WIDEST = 0.78
"""As a part of the leg's front."""
_ABOVE_HEM = 3.0
"""A patch ends so far above the end of its leg, cm."""


def knee_patches(chalk: Chalk, name: str) -> list[Trim]:
    """One on the front of each leg; nothing where legs end above the knee."""
    s, knee = chalk.size, KNEE_PER_CROTCH * chalk.crotch
    pieces: list[Trim] = []
    for panel in ("pant_f_l", "pant_f_r"):
        view = chalk.views.get(panel)
        span = None if view is None else view.span(knee)
        if view is None or span is None or view.low > knee - _HEIGHT * s / 2 - _ABOVE_HEM:
            return []
        width = min(_WIDTH * s, _WIDEST * (span[1] - span[0]))
        x, low, high = (span[0] + span[1]) / 2, knee - _HEIGHT * s / 2, knee + _HEIGHT * s / 2
        found = chalk.ruled(
            name,
            panel,
            [(x - width / 2, low), (x, low), (x + width / 2, low)],
            [(x - width / 2, high), (x, high), (x + width / 2, high)],
        )
        if not found:
            return []
        pieces += found
    return pieces
