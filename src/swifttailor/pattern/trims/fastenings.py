"""What closes a garment: buttons and zips, where a tailor would chalk them."""

from __future__ import annotations

import math
from collections.abc import Mapping

import numpy as np

from swifttailor.pattern.pattern import EdgeRef
from swifttailor.pattern.trims.belts import belt
from swifttailor.pattern.trims.chalk import Chalk
from swifttailor.pattern.trims.front_view import edge_at, front_edge
from swifttailor.pattern.trims.names import LIKE_EACH_OTHER
from swifttailor.pattern.trims.shapes import Belt, Look, Trim

_BUTTON, _COAT_BUTTON, _BIG_BUTTON = 0.6, 1.0, 2.0
"""Radii, cm."""
_SPACING, _COAT_SPACING, _BIG_SPACING = 8.5, 11.0, 11.0
_WITHOUT_BAND: Mapping[str, tuple[float, float]] = {
    "buttons": (_COAT_SPACING, _COAT_BUTTON),
    "big buttons": (_BIG_SPACING, _BIG_BUTTON),
}
"""How far apart buttons are, and their radius, cm, by the name of a row that has no band."""
_BIG = "big buttons"
_FROM_NECK, _FROM_HEM = 1.6, 2.5
_ROOM, _LEAST = 0.3, 0.15
"""Radius of a button over its distance from the next, at most, and of the smallest, cm."""
_SHORTEST = 6.0
"""A front that is joined less far has nothing that closes it, cm."""
_LONG_COAT, _BUTTONED = 44.0, 26.0
"""What reaches lower than so far below the waist is a coat, and is buttoned down to there, cm."""
_LOWER = 4.0
"""Strips beside the seam may end so far below its upper end, cm."""
_NEAR = 3.0
"""The seam is at most so far from the middle, cm."""
_BAND = 1.6
"""Half the width of a front band, cm."""
_DOUBLE_AT = 6.5
"""Distance of each of two rows of buttons from the middle, cm."""
_PAIRS_BELOW = 2
"""So many pairs lie below a belt at most."""
_FLAP_AT, _FLAP = 8.0, 15.0
"""Half the width of the flap of trousers, and how far it reaches down, cm."""
_POLO, _HALF_ZIP = 14.0, 24.0
"""How far down they reach from the neck, cm."""
_ABOVE_WAIST = ("polo placket", "waist placket")
"""Bands that end there at the latest."""
_ZIP = 0.55
"""Half the width of the teeth, cm."""

_Seam = tuple[EdgeRef, EdgeRef, float, float]


def _front(chalk: Chalk) -> _Seam | None:
    """The seam down the front, see `front_edge`; None where it is too short to be closed by anything."""
    seam = front_edge(chalk.pattern)
    if seam is None or seam[3] - seam[2] < _SHORTEST * chalk.size:
        return None
    return seam if all(ref.panel in chalk.views for ref in seam[:2]) else None


def _middle(chalk: Chalk, panel: str, sign: int, y: float) -> float:
    """The x of a front's edge in the middle at a height, which may be cut aslant."""
    x = chalk.outer(chalk.views[panel], y, -sign)
    return 0.0 if x is None else x


def _beside(chalk: Chalk, name: str, seam: _Seam, width: float, look: Look) -> list[Trim]:
    """A strip on each side of the seam, up to a little below where both have room for it."""
    right, left, low, high = seam
    ends = chalk.views[right.panel].outline
    ends = ends[(np.abs(ends[:, 0]) <= _NEAR) & (ends[:, 1] > low + 0.3) & (ends[:, 1] < high - 0.3), 1]
    for top in np.arange(high, high - _LOWER, -0.5):
        heights = np.linspace(low, top, max(int((top - low) / 2), 3))
        bends = ends[ends < top - 0.3]
        clear = np.abs(heights[1:-1, None] - bends).min(axis=1, initial=np.inf) > 0.3
        heights = np.unique(np.concatenate([heights[[0, -1]], heights[1:-1][clear], bends]))
        pieces = []
        for ref, sign in ((right, -1), (left, 1)):
            line = [(_middle(chalk, ref.panel, sign, y), y) for y in heights]
            beside = [(x + sign * width, y) for x, y in line]
            found = chalk.ruled(name, ref.panel, line, beside, look, is_cut=look == "cloth")
            if not found:
                break
            pieces += found
        else:
            return pieces
    return []


def buttons(chalk: Chalk, name: str) -> list[Trim]:
    """One row down the middle, with a band under it or without."""
    seam = _front(chalk)
    if seam is None:
        return [] if name in _ABOVE_WAIST else _buttons_of_skirt(chalk, name, chalk.pattern.button_count)
    right, left, low, high = seam
    coat = name in _WITHOUT_BAND
    spacing, radius = _WITHOUT_BAND.get(name, (_SPACING, _BUTTON))
    spacing, radius = spacing * chalk.size, radius * chalk.size
    if name == "polo placket":
        low = max(low, high - _POLO * chalk.size)
    if name == "waist placket":
        low = max(low, chalk.waist)
    bottom, top = low + _FROM_HEM, high - _FROM_NECK
    if coat:
        bottom = max(bottom, _last_of_coat(chalk))
    if name == "waist placket" and top <= bottom:  # a front that is open down to the waist
        return []
    on_skirt = 0.0 if name in _ABOVE_WAIST else _skirt_length(chalk)
    heights, radius = _row(bottom, top, spacing, radius, _shared(chalk, top - bottom, on_skirt))
    row = [chalk.button(name, right.panel, (_middle(chalk, right.panel, -1, y), y), radius) for y in heights]
    if not all(row):
        return []
    band = [] if coat else _beside(chalk, name, (right, left, low + 0.3, high - 0.3), _BAND, "cloth")
    beside = chalk.pattern.button_count - len(heights) if chalk.pattern.button_count else 0
    skirted = on_skirt and (beside or not chalk.pattern.button_count)
    below = _buttons_of_skirt(chalk, name, beside) if skirted else []
    return [*band, *(button for one in row for button in one), *below]


def _last_of_coat(chalk: Chalk) -> float:
    """How low a coat is buttoned, cm; minus infinity for what is no longer than a jacket."""
    low = min([view.low for panel, view in chalk.views.items() if panel.endswith("_ftorso")], default=0.0)
    long = low < chalk.waist - _LONG_COAT * chalk.size
    return chalk.waist - _BUTTONED * chalk.size if long else -math.inf


def _row(bottom: float, top: float, spacing: float, radius: float, count: int) -> tuple[list[float], float]:
    """Heights of a row of buttons, cm, and their radius: that of such as have room beside each other.

    Args:
        bottom: Height of the lowest, cm.
        top: Of the uppermost, cm; a single one is there.
        spacing: About how far apart they are where their number is not stated, cm.
        radius: Of theirs where they have room, cm.
        count: How many; 0 for as many as the length needs.
    """
    many = count or max(round((top - bottom) / spacing), 1) + 1
    if many == 1:
        return [top], radius
    heights = np.linspace(bottom, top, many)
    return heights.tolist(), min(radius, max(_ROOM * abs(float(heights[1] - heights[0])), _LEAST))


def _shared(chalk: Chalk, torso: float, skirt: float) -> int:
    """How many of the buttons that a pattern states lie on its torso, the others on its skirt."""
    count = chalk.pattern.button_count
    return count and max(round(count * torso / (torso + skirt)), 1)


def _skirt_middle(chalk: Chalk) -> tuple[float, float] | None:
    """Where the middle of a skirt in one piece begins and ends, cm; None where it has no such front."""
    view = chalk.views.get("skirt_front")
    span = None if view is None else view.span(view.low + 1)
    if view is None or span is None or not span[0] < -2 < 2 < span[1]:
        return None
    return view.column(0.0)


def _skirt_length(chalk: Chalk) -> float:
    middle = _skirt_middle(chalk)
    return 0.0 if middle is None else max(middle[1] - middle[0], 0.0)


def _buttons_of_skirt(chalk: Chalk, name: str, count: int = 0) -> list[Trim]:
    """Down the middle of a skirt in one piece: shirt dresses, skirts that are buttoned."""
    spacing, radius = _WITHOUT_BAND[name] if name == _BIG else (_SPACING, _BUTTON)
    middle = _skirt_middle(chalk)
    if middle is None:
        return []
    view, (low, high) = chalk.views["skirt_front"], middle
    heights = np.arange(high - 4, low + 7, -spacing * chalk.size)
    if count:
        heights = np.linspace(low + 7, high - 4, count)[::-1] if count > 1 else np.array([high - 4])
    row = [chalk.button(name, view.panel.name, (0.0, float(y)), radius * chalk.size) for y in heights]
    if not row or not all(row):
        return []
    ends = np.linspace(low + 0.3, high - 0.3, max(int((high - low) / 2), 2))
    bands = [
        chalk.ruled(name, view.panel.name, [(0.0, y) for y in ends], [(sign * _BAND, y) for y in ends])
        for sign in (-1, 1)
    ]
    return [piece for part in (*(bands if all(bands) else ()), *row) for piece in part]


def double_breasted(chalk: Chalk, name: str) -> list[Trim]:
    """Two rows, and the edge of the front that lies above the other one; of trousers those of a flap."""
    seam = _front(chalk)
    if seam is None:
        return _fall_front(chalk, name)
    right, left, low, high = seam
    at, top = _DOUBLE_AT * chalk.size, high - 2
    edge_top = chalk.height_within(chalk.views[left.panel], at + 2.5, top, low + 0.5)
    column = chalk.views[left.panel].column(at + 2.5)
    hem = low + 0.5 if column is None else min(low, column[0]) + 0.5
    heights = np.linspace(hem, edge_top, 12)
    edge = [(edge_at(chalk.pattern, left, max(y, low)) + at + 2.5, y) for y in heights]
    pieces = chalk.line(name, left.panel, edge)
    pairs = []
    spacing, radius = _COAT_SPACING * chalk.size, _COAT_BUTTON * chalk.size
    bottom = max(low + 3, _last_of_coat(chalk), min(_above_belt(chalk), top - _SHORTEST))
    many = math.ceil(chalk.pattern.button_count / 2) or max(round((top - bottom) / spacing), 1) + 1
    heights, radius = _row(bottom, top - 2, spacing, radius, many)
    for y in [*heights, *_below_belt(chalk, max(low + 3, _last_of_coat(chalk)), spacing, radius)]:
        pair = [
            chalk.button(
                name,
                ref.panel,
                (edge_at(chalk.pattern, ref, y) + sign * at, y),
                radius,
            )
            for ref, sign in ((right, -1), (left, 1))
        ]
        pairs += [pair] if all(pair) else []
    return [*pieces, *(button for pair in pairs for one in pair for button in one)] if pairs else []


def _fall_front(chalk: Chalk, name: str) -> list[Trim]:
    """The flap of sailors' trousers: its seams, and a row of buttons down either side."""
    pieces: list[Trim] = []
    size = chalk.size
    for panel, sign in (("pant_f_l", 1.0), ("pant_f_r", -1.0)):
        view = chalk.views.get(panel)
        span = None if view is None or "wb_front" not in chalk.views else view.span(view.high - 3)
        if view is None or span is None:
            return []
        at = (span[0] if sign > 0 else span[1]) + sign * _FLAP_AT * size
        top = chalk.top_at(view, at) - 0.5
        low = top - _FLAP * size
        pieces += chalk.line(name, panel, [(at, top), (at, low), (at - sign * (_FLAP_AT - 0.3) * size, low)])
        for share in (0.12, 0.4, 0.68):
            y = top - share * _FLAP * size
            pieces += chalk.button(name, panel, (at - sign * 1.8 * size, y), 0.8 * size)
    return pieces


def _above_belt(chalk: Chalk) -> float:
    """The lowest height at which a button is not hidden by a belt, cm; minus infinity without one."""
    return max((band.height + band.width / 2 + 1.5 for band in _belts(chalk)), default=-math.inf)


def _below_belt(chalk: Chalk, low: float, spacing: float, radius: float) -> list[float]:
    """Heights of pairs of buttons between a belt and the end of the closing; none where their number is told.

    Args:
        chalk: Of the pattern.
        low: Where the lowest may be, cm.
        spacing: About how far apart they are, cm.
        radius: Of a button, cm.
    """
    bands = _belts(chalk)
    if not bands or chalk.pattern.button_count:
        return []
    top = min(band.height - band.width / 2 for band in bands) - 3.0 - radius
    many = int((top - low) / spacing) + 1 if top > low else 0
    return [top - k * spacing for k in range(min(many, _PAIRS_BELOW))]


def _belts(chalk: Chalk) -> list[Belt]:
    worn = [
        piece for name in LIKE_EACH_OTHER[1][:2] if name in chalk.pattern.trims for piece in belt(chalk, name)
    ]
    return [piece for piece in worn if isinstance(piece, Belt)]


def front_zip(chalk: Chalk, name: str) -> list[Trim]:
    """Down the seam in the middle."""
    seam = _front(chalk)
    if seam is None:
        return _zip_of_skirt(chalk, name) if name == "zip" else []
    right, left, low, high = seam
    if name == "half zip":
        low = max(low, high - _HALF_ZIP * chalk.size)
    pieces = _beside(chalk, name, (right, left, low + 0.2, high - 0.4), _ZIP, "metal")
    if not pieces:
        return []
    stitches = []
    for ref, sign in ((right, -1), (left, 1)):
        heights = np.linspace(low + 0.2, high - 2.4, max(int((high - low) / 2), 3)).tolist()
        line = [(_middle(chalk, ref.panel, sign, y) + sign * 1.6, y) for y in heights]
        stitches.append(chalk.line(name, ref.panel, line))
    below = _zip_of_legs(chalk, name) if name == "zip" else []
    return [*pieces, *(line for one in stitches for line in one if all(stitches)), *below]


def _zip_of_skirt(chalk: Chalk, name: str) -> list[Trim]:
    """Down the middle of a skirt in one piece, from the waist to the hem."""
    middle = _skirt_middle(chalk)
    if middle is None or "left_ftorso" in chalk.views or middle[1] - middle[0] < _SHORTEST:
        return []
    heights = np.linspace(middle[0] + 0.5, middle[1] - 0.4, 14)
    sides = [[(sign * _ZIP, float(y)) for y in heights] for sign in (-1, 1)]
    teeth = chalk.ruled(name, "skirt_front", *sides, "metal", is_cut=False)
    lines = [chalk.line(name, "skirt_front", [(sign * 1.8, float(y)) for y in heights]) for sign in (-1, 1)]
    return [*teeth, *(line for one in lines for line in one)] if teeth else []


_BELOW_WAIST = 14.0
"""How far a zip of a garment with legs goes on below its waist, cm."""


def _zip_of_legs(chalk: Chalk, name: str) -> list[Trim]:
    """On from the waist of a jumpsuit, down the seam between its legs."""
    found = []
    for panel, sign in (("pant_f_r", -1), ("pant_f_l", 1)):
        view = chalk.views.get(panel)
        if view is None:
            return []
        heights = np.linspace(view.high - 1.5, view.high - _BELOW_WAIST * chalk.size, 8)
        spans = [view.span(float(y)) for y in heights]
        inner = [min(sign * span[0], sign * span[1]) for span in spans if span is not None]
        if len(inner) < len(heights):
            return []
        seam = [(sign * (x + 0.05), float(y)) for x, y in zip(inner, heights, strict=True)]
        teeth = [(x + sign * _ZIP, y) for x, y in seam]
        found.append(chalk.ruled(name, panel, seam, teeth, "metal", is_cut=False, to_the_edge=True))
    return [piece for one in found for piece in one] if all(found) else []


def back_zip(chalk: Chalk, name: str) -> list[Trim]:
    """Down the seam in the middle of the back, or from the waist down it."""
    for panel in ("left_btorso", "skirt_back"):
        view = chalk.views.get(panel)
        column = None if view is None else view.column(0.3)
        if view is None or column is None:
            continue
        low = max(column[0] + 0.5, column[1] - (18 if panel == "skirt_back" else 50) * chalk.size)
        if column[1] - low < _SHORTEST:
            continue
        heights = np.linspace(low, column[1] - 0.4, 12)
        found = chalk.ruled(
            name, panel, [(0.0, y) for y in heights], [(_ZIP, y) for y in heights], "metal", is_cut=False
        )
        if found:
            return found
    return []


def side_zip(chalk: Chalk, name: str) -> list[Trim]:
    """In the left side seam, below the waist."""
    return chalk.beside_side_seam(name, 0.5, 18.0, both=False)


def fly(chalk: Chalk, name: str) -> list[Trim]:
    """The stitches of a fly on the left front, and the button above."""
    view, band = chalk.views.get("pant_f_l"), chalk.views.get("wb_front")
    if view is None or chalk.views.get("pant_f_r") is None:
        return []
    middle = view.span(view.high - 3)
    top = view.high if middle is None else chalk.top_at(view, middle[0] + 1.0)
    if middle is None:
        return []
    x, s = middle[0], chalk.size
    curve = [
        (x + 3.6 * s, top - 0.5),
        (x + 3.6 * s, top - 9 * s),
        (x + 3.2 * s, top - 12 * s),
        (x + 2 * s, top - 14 * s),
    ]
    curve.append((x + 0.6 * s, top - 15 * s))
    pieces = chalk.line(name, "pant_f_l", curve)
    if pieces and band is not None:
        pieces += chalk.button(name, "wb_front", (0.8, (band.low + band.high) / 2), 0.8 * s)
    return pieces
