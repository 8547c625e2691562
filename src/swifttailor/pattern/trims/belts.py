"""Belts and cords around the waist, where a tailor would chalk them."""

from __future__ import annotations

from swifttailor.pattern.trims.chalk import Chalk
from swifttailor.pattern.trims.shapes import Belt, Trim


def belt(chalk: Chalk, name: str) -> list[Trim]:
    """Around the waist, in the waistband of skirts and trousers."""
    has_torso = "left_ftorso" in chalk.views
    band = chalk.views.get("wb_front")
    if not has_torso and band is None:
        return []
    if has_torso and chalk.views["left_ftorso"].low > chalk.waist + 1:
        return []
    width = 3.5 * chalk.size if not has_torso else 4.5 * chalk.size
    return [Belt(name, chalk.waist, width)]


def drawstring(chalk: Chalk, name: str) -> list[Trim]:
    """Two ends of a cord from the middle of the waist."""
    s, pieces = chalk.size, []
    for panel, sign in (("pant_f_l", 1), ("pant_f_r", -1)):
        view = chalk.views.get(panel) or chalk.views.get("skirt_front")
        if view is None:
            return []
        span = view.span(view.high - 3)
        if span is None:
            return []
        x = sign * max(min(sign * span[0], sign * span[1]), 0.0) + sign * 1.2
        top = chalk.top_at(view, x) - 0.2
        ends = [(x, top), (x + sign * 0.6, top - 7 * s), (x + sign * 1.6, top - 14 * s)]
        found = chalk.line(name, view.panel.name, ends, width=0.35)
        if not found:
            return []
        pieces += found
    return pieces
