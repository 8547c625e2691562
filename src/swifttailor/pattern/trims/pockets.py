"""Pockets, where a tailor would chalk them."""

from __future__ import annotations

from swifttailor.pattern.trims.chalk import Chalk
from swifttailor.pattern.trims.shapes import Trim

_SHORT_TORSO = 12.0
"""Fronts that end less far below the waist have no pockets at the hips, cm."""


def chest_pocket(chalk: Chalk, name: str) -> list[Trim]:
    """On the left breast, or one with a flap on each."""
    both = name == "chest pockets"
    pieces: list[Trim] = []
    for panel in ("left_ftorso", "right_ftorso")[: 2 if both else 1]:
        view = chalk.views.get(panel)
        if view is None:
            return []
        sign = 1 if panel.startswith("left") else -1
        top, width, height = view.high - 20.5 * chalk.size, 11.0 * chalk.size, 12.5 * chalk.size
        height = min(height, top - view.low - 3)
        if height < 6 * chalk.size:
            return []
        x = sign * (9.0 if both else 9.5) * chalk.size
        pieces += chalk.pocket(name, panel, (x, top), width, height, point=1.5 * chalk.size)
        if both:
            pieces += chalk.flap(name, panel, (x, top), width + 0.6, 5.0 * chalk.size)
    return pieces


def patch_pockets(chalk: Chalk, name: str) -> list[Trim]:
    """At the hips, or lower where the waist is; one on each side."""
    s = chalk.size
    pieces: list[Trim] = []
    skirt = chalk.views.get("skirt_front")
    legs = chalk.views.get("pant_f_l")
    for side, sign in (("left", 1), ("right", -1)):
        torso = chalk.views.get(f"{side}_ftorso")
        if skirt is not None:
            panel, top = "skirt_front", min(skirt.high, chalk.waist) - 8 * s
        elif legs is not None:
            panel, top = f"pant_f_{side[0]}", legs.high - 7 * s
        elif torso is not None and torso.low < chalk.waist - _SHORT_TORSO * s:
            panel = f"{side}_ftorso"
            top = min(chalk.waist - 4 * s, max(torso.low + 18 * s, chalk.waist - 12 * s))
        else:
            return []
        view = chalk.views.get(panel)
        span = None if view is None else view.span(top - 7 * s)
        if view is None or span is None:
            return []
        width, height = 14 * s, min(15.5 * s, top - view.low - 4)
        outer = max(sign * span[0], sign * span[1])
        x = sign * min(12.0 * s, outer - width / 2 - 1.2)
        if height < 8 * s or sign * x - width / 2 < 0.8:
            return []
        found = chalk.pocket(name, panel, (x, top), width, height)
        if not found:
            return []
        pieces += found
    return pieces


def kangaroo(chalk: Chalk, name: str) -> list[Trim]:
    """Across both fronts above the hem, open towards the sides."""
    s, pieces = chalk.size, []
    for side, sign in (("left", 1), ("right", -1)):
        view = chalk.views.get(f"{side}_ftorso")
        if view is None:
            return []
        span = view.span(view.low + 6)
        if span is None:
            return []
        reach = min(15.0 * s, max(abs(span[0]), abs(span[1])) - 3)
        column, beside = view.column(sign * 0.5), view.column(sign * reach)
        if column is None or beside is None:
            return []
        bottom, sides = column[0] + 1.0, beside[0] + 1.0
        top = min(bottom + 19 * s, view.high - 20 * s)
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
        if waist_end is None or low_end is None:
            return []
        first = (
            waist_end - sign * 6.5 * chalk.size,
            chalk.top_at(view, waist_end - sign * 6.5 * chalk.size) - 0.5,
        )
        last = (low_end - sign * 0.5, top - 16 * chalk.size)
        middle = ((first[0] + last[0]) / 2 - sign * 0.5, (first[1] + last[1]) / 2 - 0.5)
        pieces += chalk.line(name, panel, [first, middle, last], width=0.28)
    return pieces


def side_pockets(chalk: Chalk, name: str) -> list[Trim]:
    """Openings in both side seams, below the waist."""
    return chalk.beside_side_seam(name, 6.0, 15.0, both=True)


def back_pockets(chalk: Chalk, name: str) -> list[Trim]:
    """One on each side of the seat."""
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
        found = chalk.pocket(name, panel, (x, view.high - 8.5 * s), width, height, point=2 * s)
        if not found:
            return []
        pieces += found
    return pieces


def cargo_pockets(chalk: Chalk, name: str) -> list[Trim]:
    """On the outside of both thighs."""
    s, pieces = chalk.size, []
    for panel, sign in (("pant_f_l", 1), ("pant_f_r", -1)):
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
        pieces += found
        pieces += chalk.flap(name, panel, (x, top), width + 0.8, 5.5 * s)
    return pieces
