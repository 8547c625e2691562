"""What goes around: belts and cords at the waist, turned-up leg ends."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from swifttailor.pattern.trims.chalk import Chalk
from swifttailor.pattern.trims.decorations import bow_at_waist
from swifttailor.pattern.trims.shapes import Belt, Bow, Trim

_SLIPS = 9.0
"""How far from the waist of the pattern that of the sewn garment may be, cm."""


def belt(chalk: Chalk, name: str) -> list[Trim]:
    """Around the waist, in the waistband of skirts and trousers."""
    has_torso = "left_ftorso" in chalk.views
    band = chalk.views.get("wb_front")
    if not has_torso and band is None:
        return []
    skirted = "skirt_front" in chalk.views or "pant_f_l" in chalk.views
    least = -1.0 if skirted else 10.0 * chalk.size  # on what ends above it a belt would hang in the air
    # Of crossed fronts one alone reaches below the waist.
    low = min([view.low for panel, view in chalk.views.items() if panel.endswith("_ftorso")], default=0.0)
    if has_torso and low > chalk.waist - least:
        return []
    width = 3.5 * chalk.size if not has_torso else 4.5 * chalk.size
    return [Belt(name, chalk.waist, width, _SLIPS * chalk.size if has_torso else 0.0)]


_SASH = 5.5
"""Width of a sash, cm."""


def sash(chalk: Chalk, name: str) -> list[Trim]:
    """A ribbon around the waist, tied in a bow behind; nothing where there is no back to tie it on."""
    around = [each for each in belt(chalk, name) if isinstance(each, Belt)]
    bow = bow_at_waist(chalk, name, ("left_btorso", "wb_back"), above=1.0, width=18.0, tail=26.0)
    if not around or not bow:
        return []
    return [*[replace(each, width=_SASH * chalk.size) for each in around], *bow]


_KNOT, _KNOT_ENDS, _KNOT_AT = 10.5, 28.0, 0.45
"""Width of a knot, length of the ends that hang from it, cm, and where it is, as a part of half the front."""


def hip_knot(chalk: Chalk, name: str) -> list[Trim]:
    """On the wearer's left, at the waistband of a skirt: cloth that is wound around is tied there."""
    view = chalk.views.get("wb_front")
    if view is None or any("torso" in panel.name for panel in chalk.pattern.panels):
        return []
    x = _KNOT_AT * float(view.outline[:, 0].max())
    column = view.column(x)
    if column is None or not view.holds([(x, (column[0] + column[1]) / 2)]):
        return []
    u, v = view.local([(x, (column[0] + column[1]) / 2)])[0].tolist()
    return [Bow(name, "wb_front", (u, v), _KNOT * chalk.size, _KNOT_ENDS * chalk.size)]


_CORD, _LONG_TORSO = 1.3, 33.0
"""Width of a cord around the waist, and how far below it what has one ends at least, cm."""


def drawstring(chalk: Chalk, name: str) -> list[Trim]:
    """Two ends of a cord from the middle of the waist; of coats in one piece the cord around it as well."""
    s, pieces = chalk.size, []
    torso = chalk.views.get("left_ftorso")
    if torso is not None and "skirt_front" not in chalk.views and "pant_f_l" not in chalk.views:
        around = belt(chalk, name) if torso.low < chalk.waist - _LONG_TORSO * s else []
        return [replace(one, width=_CORD * s) for one in around if isinstance(one, Belt)]
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


_TURNED_UP = 4.5
"""Height of turned-up leg ends, cm."""


def turn_ups(chalk: Chalk, name: str) -> list[Trim]:
    """A band of cloth around the end of each leg."""
    pieces: list[Trim] = []
    for panel in ("pant_f_l", "pant_b_l", "pant_f_r", "pant_b_r"):
        view = chalk.views.get(panel)
        if view is None:
            return []
        height = _TURNED_UP * chalk.size
        rows = [view.span(view.low + share * height) for share in (0.04, 0.35, 0.7, 1.0)]
        found = [row for row in rows if row is not None]
        if len(found) < len(rows):
            return []
        heights = view.low + height * np.array([0.04, 0.35, 0.7, 1.0])
        edges = [
            [(row[side] + inward * 0.05, float(y)) for row, y in zip(found, heights, strict=True)]
            for side, inward in ((0, 1), (1, -1))
        ]
        pieces += chalk.ruled(name, panel, edges[0], edges[1], to_the_edge=True)
    return pieces
