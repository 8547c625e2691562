"""Slits for the arms: upright openings in the fronts of capes, each with a narrow welt."""

from __future__ import annotations

from swifttailor.pattern.trims.chalk import Chalk
from swifttailor.pattern.trims.shapes import Trim

_LENGTH, _WELT = 24.0, 2.2
"""Length of a slit, and how wide the strip along its inner side is, cm."""
_ASIDE, _ABOVE_WAIST = 17.0, 15.0
"""How far from the middle a slit lies, and how far above the waist it begins, cm: where the elbows are."""
_INWARD = 1.5
"""So much nearer to the middle it is tried where a front is narrow, cm."""


def arm_slits(chalk: Chalk, name: str) -> list[Trim]:
    """One in each front, at the height of the elbows; on garments without sleeves alone."""
    if any("sleeve" in panel.name for panel in chalk.pattern.panels):
        return []
    s = chalk.size
    pieces: list[Trim] = []
    for side, sign in (("left", 1), ("right", -1)):
        panel = f"{side}_ftorso"
        if panel not in chalk.views:
            return []
        found: list[Trim] = []
        for step in range(5):
            x, top = sign * (_ASIDE - _INWARD * step) * s, chalk.waist + _ABOVE_WAIST * s
            ends = [(x, top), (x, top - _LENGTH * s)]
            inner = [(at - sign * _WELT * s, y) for at, y in ends]
            welt = chalk.ruled(name, panel, ends, inner)
            opening = chalk.line(name, panel, ends)
            if welt and opening:
                found = [*welt, *opening]
                break
        if not found:
            return []
        pieces += found
    return pieces
