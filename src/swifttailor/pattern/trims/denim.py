"""What denim is told by: stitches of another colour, loops for a belt, the seams of a denim jacket."""

from __future__ import annotations

import numpy as np

from swifttailor.pattern.pattern import EdgeRef, Pattern
from swifttailor.pattern.trims import pockets
from swifttailor.pattern.trims.chalk import Chalk
from swifttailor.pattern.trims.free_edges import hem_edges, leg_ends
from swifttailor.pattern.trims.front_view import over_darts
from swifttailor.pattern.trims.shapes import Patch, Trim
from swifttailor.pattern.trims.side_stripes import LEG, SIDE, outer_seams
from swifttailor.pattern.trims.stitched_lines import beside_edge, inside_patch

_BESIDE, _FROM_END, _POCKET = 0.7, 1.4, 0.7
"""How far stitches lie from a seam, from an end and from the border of a pocket, cm."""
_STITCHED_POCKETS = ("back pockets", "patch pockets", "chest pocket", "bib pocket")
_BANDS = ("wb_front", "wb_back")
_LOOP, _LOOPS, _OUT = 0.65, {"wb_front": (-0.5, 0.5), "wb_back": (-0.62, 0.0, 0.62)}, 0.25
"""Half the width of a loop, cm; where loops are, as parts of half the band's width; their room above."""
_SMALLEST = 0.6
"""Smaller loops are left out, cm²."""
_YOKE, _BACK_YOKE, _SEAM = 18.4, 13.0, 0.17
"""How far below the neck's highest point the yokes of a denim jacket end, and half a seam as drawn, cm."""
_FRONT_SEAMS = ((3.0, 4.0), (15.2, 9.5))
_BACK_SEAMS = ((11.0, 7.0),)
"""How far from the middle the seams below a yoke begin and end, cm."""
_BACKS = ("pant_b_l", "pant_b_r")
_YOKE_AT_SIDE, _YOKE_AT_MIDDLE, _UPWARD = 4.0, 8.5, 3.0
"""How far below the waist the yoke of jeans ends at the side and in the middle, cm; the outermost of the
upper corners of a leg is found by how much more height counts than width."""
_STITCHED = 0.17
"""Half the width of its stitches as they are drawn, cm."""
_SIDES = (("left", 1.0), ("right", -1.0))


def topstitching(chalk: Chalk, name: str) -> list[Trim]:
    """Stitches along side seams, hems, waistbands and pockets."""
    pattern = chalk.pattern
    legs = any(LEG.match(panel.name) for panel in pattern.panels)
    pieces: list[Trim] = []
    for front, back in outer_seams(pattern, LEG if legs else SIDE):
        pieces += [*beside_edge(chalk, name, front, _BESIDE), *beside_edge(chalk, name, back, _BESIDE)]
    ends = (*leg_ends(pattern, "l")[0], *leg_ends(pattern, "r")[0]) if legs else hem_edges(pattern)
    for ref in ends:
        pieces += beside_edge(chalk, name, ref, _FROM_END)
    for band in _BANDS:
        for ref in _level_edges(chalk, band):
            pieces += beside_edge(chalk, name, ref, 0.5)
    if not pieces:
        return []
    if has_yoke_behind(pattern):
        pieces += _yoke_behind(chalk, name)
    for pocket in _STITCHED_POCKETS:
        if pocket in pattern.trims:
            sewn = [p for p in _PLACES[pocket](chalk, pocket) if isinstance(p, Patch) and p.look == "cloth"]
            pieces += [line for patch in sewn for line in inside_patch(chalk, name, patch, _POCKET)]
    return pieces


def has_yoke_behind(pattern: Pattern) -> bool:
    """Whether a pattern is one of jeans or dungarees: denim legs on a waistband."""
    names = {panel.name for panel in pattern.panels}
    return "topstitching" in pattern.trims and names.issuperset((*_BACKS, *_BANDS))


def _yoke_behind(chalk: Chalk, name: str) -> list[Trim]:
    """The seam of the yoke on both back legs, lower in the middle; nothing where a leg has no room for it."""
    pieces: list[Trim] = []
    for panel, sign in zip(_BACKS, (1, -1), strict=True):
        view = chalk.views.get(panel)
        if view is None:
            return []
        corner = view.outline[int(np.argmax(sign * view.outline[:, 0] + _UPWARD * view.outline[:, 1]))]
        outer = chalk.outer(view, float(corner[1]) - _YOKE_AT_SIDE * chalk.size, sign)
        middle = float(view.outline[:, 1].max()) - _YOKE_AT_MIDDLE * chalk.size
        inner = chalk.outer(view, middle, -sign)
        if outer is None or inner is None:
            return []
        ends = np.array(
            [(outer - sign * 0.5, corner[1] - _YOKE_AT_SIDE * chalk.size), (inner + sign * 0.5, middle)]
        )
        line = [(float(x), float(y)) for x, y in np.linspace(ends[0], ends[1], 24)]
        found = chalk.line(name, panel, over_darts(view, line), _STITCHED)
        if not found:
            return []
        pieces += found
    return pieces


def belt_loops(chalk: Chalk, name: str) -> list[Trim]:
    """Five loops on a waistband that nothing hangs from above."""
    if any("torso" in panel.name for panel in chalk.pattern.panels):
        return []
    pieces: list[Trim] = []
    for band in _BANDS:
        view = chalk.views.get(band)
        if view is None:
            return []
        wide = min(-view.outline[:, 0].min(), view.outline[:, 0].max())
        for share in _LOOPS[band]:
            x, half = float(share * wide), _LOOP * chalk.size
            column = view.column(x)
            if column is None or column[1] - column[0] < 2.0 * chalk.size:
                return []
            low, high = column[0] + _OUT, column[1] - _OUT
            if 2.0 * half * (high - low) < _SMALLEST:
                return []
            found = chalk.ruled(
                name, band, [(x - half, low), (x + half, low)], [(x - half, high), (x + half, high)]
            )
            if not found:
                return []
            pieces += found
    return pieces


def denim_seams(chalk: Chalk, name: str) -> list[Trim]:
    """The yoke of a denim jacket, and seams that run from it to the hem, closer together below."""
    s, pieces = chalk.size, []
    for part, below, seams in (("ftorso", _YOKE, _FRONT_SEAMS), ("btorso", _BACK_YOKE, _BACK_SEAMS)):
        for side, sign in _SIDES:
            view = chalk.views.get(f"{side}_{part}")
            y = 0.0 if view is None else view.high - below * s
            span = None if view is None else view.span(y)
            if view is None or span is None or y - view.low < 14.0 * s:
                return []
            inner, outer = sorted((sign * span[0], sign * span[1]))
            line = [(sign * float(x), y) for x in np.linspace(inner + 0.1, outer - 0.5, 8)]
            pieces += chalk.line(name, view.panel.name, line, _SEAM)
            for high, low in seams:
                begin = min(high * s, outer - 1.2)
                end = view.column(sign * min(low * s, begin))
                if end is None:
                    continue
                ends = np.array([(begin, y), (min(low * s, begin), end[0] + 0.5)])
                down = [(sign * float(a), float(b)) for a, b in np.linspace(ends[0], ends[1], 10)]
                pieces += chalk.line(name, view.panel.name, down, _SEAM)
    return pieces


def _level_edges(chalk: Chalk, band: str) -> list[EdgeRef]:
    """The long edges of a waistband, above and below."""
    if band not in chalk.views:
        return []
    panel = chalk.pattern.panel(band)
    found = []
    for k in range(len(panel.edges)):
        ends = np.abs(np.diff(panel.chord(k), axis=0))[0]
        if ends[0] > 3.0 * ends[1] and ends[0] > 4.0:
            found.append(EdgeRef(band, k))
    return found


_PLACES = {
    "back pockets": pockets.back_pockets,
    "patch pockets": pockets.patch_pockets,
    "chest pocket": pockets.chest_pocket,
    "bib pocket": pockets.bib_pocket,
}
"""How the pockets that have such stitches are marked."""
