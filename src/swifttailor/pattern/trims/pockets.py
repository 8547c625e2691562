"""Pockets, where a tailor would chalk them."""

from __future__ import annotations

import numpy as np

from swifttailor.pattern.trims.chalk import Chalk, Point
from swifttailor.pattern.trims.front_view import FrontView
from swifttailor.pattern.trims.shapes import Trim

_SHORT_TORSO = 12.0
"""Fronts that end less far below the waist have no pockets at the hips, cm."""
_DOUBLE_ROWS, _BESIDE_ROWS, _LEAST_WELT = "double-breasted buttons", 11.0, 8.0
"""Beside two rows of buttons welts begin so far from the middle, and are so wide at least, cm."""


def chest_pocket(chalk: Chalk, name: str) -> list[Trim]:
    """On the left breast, or one with a flap on each."""
    both = name == "chest pockets"
    first = (9.0 if both else 9.5) * chalk.size
    for lower in (0.0, 1.0, 2.0, 3.0):
        for inner in (0.0, 0.5, 1.0, 1.5, 2.0):
            pieces = _on_breasts(chalk, name, first - inner * chalk.size, (20.5 + lower) * chalk.size, both)
            if pieces:
                return pieces
    return []


def _on_breasts(chalk: Chalk, name: str, x: float, below: float, both: bool) -> list[Trim]:
    """The same, so far from the middle and so far below the highest point of the front, cm."""
    pieces: list[Trim] = []
    for panel, sign in (("left_ftorso", 1), ("right_ftorso", -1))[: 2 if both else 1]:
        view = chalk.views.get(panel)
        if view is None:
            return []
        top, width = view.high - below, 11.0 * chalk.size
        height = min(12.5 * chalk.size, top - view.low - 3)
        if height < 6 * chalk.size:
            return []
        found = chalk.pocket(name, panel, (sign * x, top), width, height, point=1.5 * chalk.size)
        flap = chalk.flap(name, panel, (sign * x, top), width + 0.6, 5.0 * chalk.size) if both else []
        if not found or (both and not flap):
            return []
        pieces += [*found, *flap]
    return pieces


_SKIRT, _WIDE, _OF_WIDE = "skirt_front", 28.0, 0.4
"""Half of the upper edge of a skirt's front that is wider than a body, cm, and at which part of it pockets
lie."""


def patch_pockets(chalk: Chalk, name: str) -> list[Trim]:
    """At the hips, or lower where the waist is; one on each side."""
    s = chalk.size
    pieces: list[Trim] = []
    skirt = chalk.views.get("skirt_front")
    legs = chalk.views.get("pant_f_l")
    over = chalk.views.get("right_ftorso")
    for side, sign in (("left", 1), ("right", -1)):
        torso = chalk.views.get(f"{side}_ftorso")
        lap = 0.0
        if skirt is not None:
            panel, top = "skirt_front", min(skirt.high, chalk.waist) - 8 * s
        elif legs is not None:
            panel, top = f"pant_f_{side[0]}", legs.high - 7 * s
        elif torso is not None and torso.low < chalk.waist - _SHORT_TORSO * s:
            panel = f"{side}_ftorso"
            top = min(chalk.waist - 4 * s, max(torso.low + 18 * s, chalk.waist - 12 * s))
            edge = None if over is None else over.span(top - 15 * s)
            lap = 0.0 if edge is None else max(edge[1], 0.0)  # of a front that lies over the other one
        else:
            return []
        view = chalk.views.get(panel)
        span = None if view is None else view.span(top - 7 * s)
        if view is None or span is None:
            return []
        width, height = 14 * s, min(15.5 * s, top - view.low - 4)
        outer = max(sign * span[0], sign * span[1])
        # Gathers draw what lies beside the middle of a wide skirt together.
        wide = abs(_upper_corner(view, sign)[0]) if panel == _SKIRT else 0.0
        beside = _OF_WIDE * wide if wide > _WIDE * s else 12.0 * s
        x = sign * min(max(beside, lap + width / 2 + 1.0), outer - width / 2 - 1.2)
        if height < 8 * s or sign * x - width / 2 < 0.8:
            return []
        found = chalk.pocket(name, panel, (x, top), width, height)
        if not found:
            return []
        pieces += found
    return pieces


def welt_pockets(chalk: Chalk, name: str) -> list[Trim]:
    """A narrow strip over an opening at each hip of a jacket, or at the waist of what is shorter."""
    s = chalk.size
    pieces: list[Trim] = []
    for side, sign in (("left", 1), ("right", -1)):
        view = chalk.views.get(f"{side}_ftorso")
        top = chalk.waist - 7 * s
        if view is None:
            return []
        column = view.column(sign * 11 * s)
        lowest = view.low if column is None else column[0]
        top = max(top, lowest + 6 * s)
        span = view.span(top)
        highest = chalk.waist + 6 * s if "left_sleeve_f" not in chalk.views else chalk.waist - 2 * s
        if span is None or top > highest:
            return []
        edge = max(sign * span[0], sign * span[1])
        outer, width = min(12.5 * s, edge - 7.5 * s), 13 * s
        if _DOUBLE_ROWS in chalk.pattern.trims:  # beside the rows of buttons, not below them
            room = min(edge - (_BESIDE_ROWS + 1.0) * s, 13 * s)
            if room >= _LEAST_WELT * s:
                outer, width = (edge - 1.0 * s + _BESIDE_ROWS * s) / 2, room
        found = chalk.pocket(name, f"{side}_ftorso", (sign * outer, top), width, 2.2 * s)
        if not found:
            return []
        pieces += found[:1]
    return pieces


_KANGAROO_BELOW_WAIST = 27.0
"""What hangs lower than so far below the waist has its kangaroo pocket there, cm."""


def kangaroo(chalk: Chalk, name: str) -> list[Trim]:
    """Across both fronts above the hem, or at the hips of what is longer, open towards the sides."""
    s, pieces = chalk.size, []
    for side, sign in (("left", 1), ("right", -1)):
        view = chalk.views.get(f"{side}_ftorso")
        if view is None:
            return []
        lowest = max(view.low, chalk.waist - _KANGAROO_BELOW_WAIST * s)
        span = view.span(lowest + 6)
        if span is None:
            return []
        reach = min(15.0 * s, max(abs(span[0]), abs(span[1])) - 3)
        column, beside = view.column(sign * 0.5), view.column(sign * reach)
        if column is None or beside is None:
            return []
        bottom, sides = max(column[0] + 1.0, lowest), max(beside[0] + 1.0, lowest)
        top = min(bottom + 19 * s, view.high - 20 * s)
        if top < max(bottom + 10 * s, sides + 13 * s):
            return []
        low, high = chalk.middle(sign, bottom), chalk.middle(sign, top)
        first = [(low, bottom), (sign * 0.55 * reach, (bottom + sides) / 2), (sign * reach, sides)]
        second = [(high, top), (sign * 0.6 * reach, top), (sign * reach, top - 12 * s)]
        found = chalk.ruled(name, f"{side}_ftorso", first, second)
        if not found:
            return []
        pieces += found
    return pieces


def bib_pocket(chalk: Chalk, name: str) -> list[Trim]:
    """In the middle of a bib, which is cut in halves."""
    pieces: list[Trim] = []
    for side, sign in (("left", 1), ("right", -1)):
        view = chalk.views.get(f"{side}_ftorso")
        column = None if view is None else view.column(sign * 1.0)
        if view is None or column is None:
            return []
        top, bottom = column[1] - 3.5 * chalk.size, column[1] - 16 * chalk.size
        half = 7.5 * chalk.size
        if bottom < view.low + 1.5:
            return []
        low, high = chalk.middle(sign, bottom), chalk.middle(sign, top)
        found = chalk.ruled(
            name,
            f"{side}_ftorso",
            [(low, bottom), (low + sign * half, bottom)],
            [(high, top), (high + sign * half, top)],
        )
        if not found:
            return []
        pieces += found
    return pieces


_FINE, _ON_SKIRT = 0.28, 0.5
"""Half the width of an opening, and of one in a skirt, whose folds hide finer ones, cm."""
_FROM_MIDDLE, _OPENING = 0.55, 16.0
"""Where openings in a skirt begin at the waist, as a part of the way to the side seam, at most; and how far
down that they end, cm."""


def slant_pockets(chalk: Chalk, name: str) -> list[Trim]:
    """Openings from the waist to the side seams."""
    pieces: list[Trim] = []
    skirt = "skirt_front" if "pant_f_l" not in chalk.views else ""
    for panel, sign in ((skirt or "pant_f_l", 1), (skirt or "pant_f_r", -1)):
        view = chalk.views.get(panel)
        if view is None:
            return []
        top = float(view.outline[:, 1].max()) if not skirt else min(view.high, chalk.waist)
        waist_end = chalk.outer(view, top - 1.0, sign)
        low_end = chalk.outer(view, top - 16 * chalk.size, sign)
        if waist_end is None or low_end is None or (skirt and not chalk.is_even(view, top - 1.0)):
            return []
        begin = waist_end - sign * 6.5 * chalk.size
        ends = [(begin, (low_end - sign * 0.5, top - 16 * chalk.size), _FINE)]
        if skirt:  # of a flared one that is hidden at the side: it begins where it is seen from the front
            corner = _upper_corner(view, sign)
            begin = sign * min(abs(begin), _FROM_MIDDLE * abs(corner[0]))
            ends.insert(0, (begin, _down_the_side(chalk, view, sign, corner) or ends[0][1], _ON_SKIRT))
        found: list[Trim] = []
        for begin, last, width in ends:
            first = (begin, chalk.top_at(view, begin) - 0.5)
            middle = ((first[0] + last[0]) / 2 - sign * 0.5, (first[1] + last[1]) / 2 - 0.5)
            found = found or chalk.line(name, panel, [first, middle, last], width=width)
        if not found:
            return []
        pieces += found
    return pieces


def _upper_corner(view: FrontView, sign: int) -> Point:
    """The upper end of a side seam of a skirt's front."""
    at = int(np.argmax(np.where(sign * view.outline[:, 0] > 0.0, view.outline[:, 1], -np.inf)))
    return (float(view.outline[at, 0]), float(view.outline[at, 1]))


def _down_the_side(chalk: Chalk, view: FrontView, sign: int, corner: Point) -> Point | None:
    """Where the opening of a pocket ends beside the side seam of a skirt, whose upper end is `corner`."""
    for down in np.arange(3.0, _OPENING, 0.5):
        x = chalk.outer(view, corner[1] - down, sign)
        if x is not None and np.hypot(x - corner[0], down) >= _OPENING * chalk.size:
            return (x - sign * 0.6, float(corner[1] - down))
    return None


def side_pockets(chalk: Chalk, name: str) -> list[Trim]:
    """Openings in both side seams, below the waist."""
    return chalk.beside_side_seam(name, 6.0, 15.0, both=True)


def back_welts(chalk: Chalk, name: str) -> list[Trim]:
    """A narrow strip over an opening on each side of the seat, as of chinos and suits."""
    for aside in (0.0, 0.5, -0.5, 1.0, -1.0, 1.5, -1.5, 2.0, -2.0):
        pieces = _on_seat(chalk, name, aside, welt=True)
        if pieces:
            return pieces
    return []


def back_pockets(chalk: Chalk, name: str) -> list[Trim]:
    """One on each side of the seat."""
    for aside in (0.0, 0.5, -0.5, 1.0, -1.0, 1.5, -1.5, 2.0, -2.0):
        pieces = _on_seat(chalk, name, aside)
        if pieces:
            return pieces
    return []


def _on_seat(chalk: Chalk, name: str, aside: float, *, welt: bool = False) -> list[Trim]:
    """The same, so far outward of the middle of each side, cm: corners do not lie in darts."""
    s, pieces = chalk.size, []
    for panel, sign in (("pant_b_l", 1), ("pant_b_r", -1)):
        view = chalk.views.get(panel)
        span = None if view is None else view.span(view.high - 14 * s)
        if view is None or span is None:
            return []
        width, height = 13 * s, 14 * s
        x = (
            sign * (min(abs(span[0]), abs(span[1])) + max(abs(span[0]), abs(span[1]))) / 2
            if span[0] * span[1] > 0
            else sign * 11 * s
        )
        at = (x + sign * aside, view.high - 8.5 * s)
        if welt:  # the piece alone, without the line of a hem
            found = chalk.pocket(name, panel, at, width, 1.4 * s)[:1]
        else:
            found = chalk.pocket(name, panel, at, width, height, point=2 * s)
        if not found:
            return []
        pieces += found
    return pieces


def cargo_pockets(chalk: Chalk, name: str) -> list[Trim]:
    """On the outside of both thighs, of legs or of a skirt without a bodice that is no wrap."""
    return _across_side_seams(chalk, name) or _on_fronts(chalk, name)


def _across_side_seams(chalk: Chalk, name: str) -> list[Trim]:
    """On legs half in front and half behind of each side seam, where there is room for them."""
    s, pieces = chalk.size, []
    for panel, sign in (("pant_f_l", 1), ("pant_b_l", 1), ("pant_f_r", -1), ("pant_b_r", -1)):
        view = chalk.views.get(panel)
        if view is None:
            return []
        height, width = 18 * s, 9 * s
        top = min(chalk.crotch - 7 * s, view.high - 24 * s)
        outer = [chalk.outer(view, top - share * height, sign) for share in (-0.06, 0.0, 0.5, 1.0)]
        if top - height < view.low + 4 or any(x is None for x in outer):
            return []
        x = sign * (min(abs(each) for each in outer if each is not None) - width / 2 - 0.5)
        found = chalk.pocket(name, panel, (x, top), width, height)
        flap = chalk.flap(name, panel, (x, top), width + 0.4, 5.5 * s) if found else []
        if not flap:
            return []
        pieces += [*found, *flap]
    return pieces


def _on_fronts(chalk: Chalk, name: str) -> list[Trim]:
    """On the fronts alone, as of shorts and skirts."""
    s, pieces = chalk.size, []
    skirt = chalk.views.get("skirt_front")
    legs = skirt is None or "left_ftorso" in chalk.views or not chalk.is_even(skirt, chalk.crotch)
    for panel, sign in (
        (("pant_f_l", 1), ("pant_f_r", -1)) if legs else (("skirt_front", 1), ("skirt_front", -1))
    ):
        view = chalk.views.get(panel)
        if view is None:
            return []
        height, width = 18 * s, 14 * s
        top = min(chalk.crotch - 7 * s, view.high - 24 * s)
        if top - height < view.low + 4:
            top = max(view.low + 4 + height, chalk.crotch + 2 * s)
            height = min(height, top - view.low - 3)
        outer = [chalk.outer(view, top - share * height, sign) for share in (-0.06, 0.0, 0.5, 1.0)]
        if any(x is None for x in outer) or height < 9 * s:
            return []
        x = sign * (min(abs(each) for each in outer if each is not None) - width / 2 - 1.0)
        found = chalk.pocket(name, panel, (x, top), width, height)
        if not found:
            return []
        flap = chalk.flap(name, panel, (x, top), width + 0.8, 5.5 * s)
        if not flap:
            return []
        pieces += [*found, *flap]
    return pieces


def thigh_pocket(chalk: Chalk, name: str) -> list[Trim]:
    """A flat one on the outside of the left thigh, for what is carried in leggings."""
    s, view = chalk.size, chalk.views.get("pant_f_l")
    if view is None:
        return []
    height = 16 * s
    top = max(min(chalk.crotch - 4 * s, view.high - 20 * s), view.low + 3 + height)
    width = 9.5 * s
    outer = [chalk.outer(view, top - share * height, 1) for share in (0.0, 0.5, 1.0)]
    if any(x is None for x in outer) or top > view.high - 10 * s:
        return []
    x = min(each for each in outer if each is not None) - width / 2 - 1.0
    return chalk.pocket(name, view.panel.name, (x, top), width, height)
