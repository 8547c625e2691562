"""What is put on for its looks: frills and fringe along edges, bows, lacing, a cord at the neck."""

from __future__ import annotations

import itertools
from collections.abc import Sequence

import numpy as np

from swifttailor.pattern.pattern import EdgeRef
from swifttailor.pattern.trims.blouse_front import BLOUSE, BLOUSE_DEPTH
from swifttailor.pattern.trims.chalk import Chalk
from swifttailor.pattern.trims.free_edges import (
    armhole_edges,
    armhole_seams,
    hem_edges,
    leg_ends,
    neck_edges,
    sleeve_ends,
)
from swifttailor.pattern.trims.front_view import front_edge
from swifttailor.pattern.trims.shapes import Bow, Frill, StripKind, Trim

_NECK_FRILL, _SLEEVE_FRILL, _HEM_FRILL, _FRINGE = 4.0, 5.0, 8.0, 10.0
"""How far each goes beyond its edge, cm."""
_FRONT_FRILL, _FRILLED_LEAST = 4.5, 15.0
"""Depth of frills down the front, and the shortest seam that has them, cm."""
_SHOULDER_FRILL = 6.0
"""The same of a frill over the shoulder, cm."""
_SCALLOPS = 3.2
"""How far scallops hang below the hem, cm."""
_TURNED_BACK = 4.0
"""Height of turned-up ends of sleeves, cm."""
_EDGINGS = {"edging": 1.3, "piping": 0.9, "bands": 5.0, "narrow bands": 2.2, "lace trim": 3.5}
_NECK_LACE, _RIB, _HEM_RIB = 4.0, 2.0, 3.0
"""How wide edgings, lace around necks and ribbed bands are, cm."""
_BORDER = 7.5
"""How wide the border of another colour along a hem is, cm."""
_BOW, _BOW_TAIL = 15.0, 17.0
_NECK_BOW, _NECK_TAIL = 18.0, 24.0
"""Those of pussy bows, which are tied of long soft ends, cm."""
_BELOW_SHOULDER, _SHOULDER_BOW, _SHOULDER_TAIL = 3.0, 11.0, 8.0
"""Bows on shoulders: how far below their highest point, how wide, and how long their ends are, cm."""
_BELOW_NECK = 1.0
"""A bow's knot and the ends of a cord begin so far below the neck, cm."""
_LACED_APART, _LACES_RISE, _LACE = 3.2, 3.6, 0.22
"""Distance of the eyelets from the middle, of one pair from the next, and half the width of the lace, cm."""
_LACED_LEAST, _LACED_MOST = 10.0, 28.0
_CORD, _KNOT_BESIDE = 15.0, 0.6
"""Length of a cord's ends, and how far beside the middle those of a bow begin, cm."""
_HANGING = ((((3.0, 0.3), (3.1, 0.5 * _CORD), (3.6, _CORD)), 0.35),)
_LOOP = (
    ((0.5, 1.3), (1.5, 0.7), (2.8, 0.7), (3.9, 1.3), (4.4, 2.1)),
    ((4.4, 2.3), (3.8, 2.9), (2.7, 2.8), (1.5, 2.3), (0.6, 1.7)),
)
_END = ((0.5, 1.9), (1.1, 0.5 * _CORD), (2.4, 0.85 * _CORD))
_TIED = (*((arc, 0.2) for arc in _LOOP), (_END, 0.22))
"""Ways of a cord on one side, aside and below the neckline, and half the widths they are drawn with, cm."""


def neck_rib(chalk: Chalk, name: str) -> list[Trim]:
    """A flat band around a neck that has no collar."""
    edges = neck_edges(chalk.pattern)
    if any("collar" in ref.panel for ref in edges):
        return []
    return _along(chalk, name, edges, _RIB, "flat")


def armhole_ribs(chalk: Chalk, name: str) -> list[Trim]:
    """A flat band around each armhole without a sleeve."""
    return _along(chalk, name, armhole_edges(chalk.pattern), 0.8 * _RIB, "flat")


def hem_rib(chalk: Chalk, name: str) -> list[Trim]:
    """A flat band along the hem, as the one below the bust of a sports bra."""
    return _along(chalk, name, hem_edges(chalk.pattern), _HEM_RIB, "flat")


def hem_border(chalk: Chalk, name: str) -> list[Trim]:
    """A wide flat band along the hem, as of festive skirts."""
    return _along(chalk, name, hem_edges(chalk.pattern), _BORDER, "flat")


def neck_frill(chalk: Chalk, name: str) -> list[Trim]:
    """A gathered strip around the neck, or on top of the collar."""
    return _along(chalk, name, neck_edges(chalk.pattern), _NECK_FRILL)


def sleeve_frills(chalk: Chalk, name: str) -> list[Trim]:
    """A gathered strip at the end of each sleeve."""
    return _along(chalk, name, sleeve_ends(chalk.pattern), _SLEEVE_FRILL)


def shoulder_frills(chalk: Chalk, name: str) -> list[Trim]:
    """A gathered strip over each shoulder, along the armhole, with sleeves or without."""
    free = armhole_edges(chalk.pattern)
    return _along(chalk, name, free or armhole_seams(chalk.pattern), _SHOULDER_FRILL)


def sleeve_turn_ups(chalk: Chalk, name: str) -> list[Trim]:
    """A flat band around the end of each sleeve, as of sleeves that are rolled up and of French cuffs."""
    return _along(chalk, name, sleeve_ends(chalk.pattern), _TURNED_BACK, "flat")


def hem_frill(chalk: Chalk, name: str) -> list[Trim]:
    """A gathered strip or threads along the hem."""
    edges = hem_edges(chalk.pattern)
    if name == "hem fringe":
        return _along(chalk, name, edges, _FRINGE, "threads")
    return _along(chalk, name, edges, _HEM_FRILL)


def edging(chalk: Chalk, name: str) -> list[Trim]:
    """A strip along neck, hem and ends of sleeves or legs.

    No lace lies at ends of sleeves, and no bands along hems where there is a neck.
    """
    pattern = chalk.pattern
    neck, hem, sleeves = neck_edges(pattern), hem_edges(pattern), sleeve_ends(pattern)
    hem = () if "bands" in name and neck else hem
    edges = (*neck, *hem, *(() if name == "lace trim" else sleeves))
    if not edges:
        edges = (*leg_ends(pattern, "l")[0], *leg_ends(pattern, "r")[0])
    return _along(chalk, name, tuple(dict.fromkeys(edges)), _EDGINGS[name], "flat")


def neck_lace(chalk: Chalk, name: str) -> list[Trim]:
    """A strip of lace around the neck alone, or along the outer edge of a collar."""
    return _along(chalk, name, neck_edges(chalk.pattern), _NECK_LACE, "flat")


def scalloped_edge(chalk: Chalk, name: str) -> list[Trim]:
    """Arcs along the hem, or along the ends of both legs."""
    legs = (*leg_ends(chalk.pattern, "l")[0], *leg_ends(chalk.pattern, "r")[0])
    return _along(chalk, name, tuple(dict.fromkeys(legs)) or hem_edges(chalk.pattern), _SCALLOPS, "flat")


def front_frills(chalk: Chalk, name: str) -> list[Trim]:
    """A gathered strip down both sides of the middle of the front, as of ruffled blouses."""
    seam = front_edge(chalk.pattern)
    if seam is None or seam[3] - seam[2] < _FRILLED_LEAST * chalk.size:
        return []
    return [piece for edge in seam[:2] for piece in _along(chalk, name, (edge,), _FRONT_FRILL)]


def _along(
    chalk: Chalk, name: str, edges: tuple[EdgeRef, ...], depth: float, kind: StripKind = "gathered"
) -> list[Trim]:
    """A strip along edges, as deep as on an adult, cm; nothing where there are no edges."""
    if not edges:
        return []
    length = sum(chalk.pattern.edge_length(ref) for ref in edges)
    return [Frill(name, edges, depth * chalk.size, length, kind)]


def neck_bow(chalk: Chalk, name: str) -> list[Trim]:
    """Where the neck ends in front."""
    place = _below_the_neck(chalk)
    if place is None:
        return []
    panel, x, y = place
    if not chalk.views[panel].holds([(x, y - _BELOW_NECK)]):
        return []
    u, v = chalk.views[panel].local([(x, y - _BELOW_NECK)])[0].tolist()
    return [Bow(name, panel, (u, v), _NECK_BOW * chalk.size, _NECK_TAIL * chalk.size)]


def waist_bow(chalk: Chalk, name: str) -> list[Trim]:
    """In the middle of the waist in front, on a waistband, a bodice or a dress without a waist seam."""
    return bow_at_waist(chalk, name, ("wb_front", "left_ftorso"), above=3.0)


def shoulder_bows(chalk: Chalk, name: str) -> list[Trim]:
    """One at the front end of each shoulder or strap."""
    bows: list[Trim] = []
    for panel in ("left_ftorso", "right_ftorso"):
        view = chalk.views.get(panel)
        y = 0.0 if view is None else view.high - _BELOW_SHOULDER * chalk.size
        span = None if view is None else view.span(y)
        if view is None or span is None or view.high < chalk.shoulder - chalk.size:
            return []  # strapless
        if not view.holds([((span[0] + span[1]) / 2, y)]):
            return []
        u, v = view.local([((span[0] + span[1]) / 2, y)])[0].tolist()
        bows.append(Bow(name, panel, (u, v), _SHOULDER_BOW * chalk.size, _SHOULDER_TAIL * chalk.size))
    return bows


def bow_at_waist(
    chalk: Chalk,
    name: str,
    panels: Sequence[str],
    *,
    above: float,
    width: float = _BOW,
    tail: float = _BOW_TAIL,
) -> list[Trim]:
    """A bow in the middle of the waist, on the first panel that has room for it.

    Args:
        chalk: Of the pattern.
        name: Of the trim.
        panels: Where it may be, waistbands (``wb_``) and others.
        above: How much of a panel that is no waistband has to be left above it, cm.
        width: Of the bow, cm.
        tail: How long its ends are, cm.
    """
    for panel in panels:
        view = chalk.views.get(panel)
        column = None if view is None else view.column(0.3)
        if view is None or column is None:
            continue
        on_band = panel.startswith("wb_")
        y = (column[0] + column[1]) / 2 if on_band else max(chalk.waist, column[0]) + 1.0
        if (on_band or y < column[1] - above) and view.holds([(0.3, y)]):
            u, v = view.local([(0.3, y)])[0].tolist()
            return [Bow(name, panel, (u, v), width * chalk.size, tail * chalk.size)]
    return []


def neck_cord(chalk: Chalk, name: str) -> list[Trim]:
    """Two ends that hang from the neck in front; from a hood side by side, else from a bow in the middle."""
    seam = front_edge(chalk.pattern)
    if seam is None:
        return []
    right, left, low, high = seam
    s, pieces = chalk.size, []
    hooded = any("hood" in panel.name for panel in chalk.pattern.panels)
    for ref, sign in ((right, -1), (left, 1)):
        if ref.panel not in chalk.views:
            return []
        at = 3.0 if hooded else _KNOT_BESIDE
        top = chalk.height_within(chalk.views[ref.panel], sign * at * s, high + 2.0, low)
        ways = _HANGING if hooded else _TIED
        for way, width in ways:
            ends = [(sign * x * s, top - y * s) for x, y in way]
            found = chalk.line(name, ref.panel, ends, width=width)
            if not found:
                return []
            pieces += found
    return pieces


def lacing(chalk: Chalk, name: str) -> list[Trim]:
    """A lace that crosses the middle of the front from eyelet to eyelet."""
    seam = front_edge(chalk.pattern)
    if seam is None or seam[3] - seam[2] < _LACED_LEAST * chalk.size:
        return []
    right, left, low, high = seam
    if right.panel not in chalk.views or left.panel not in chalk.views:
        return []
    if BLOUSE in chalk.pattern.trims:  # the bodice begins below it
        high -= BLOUSE_DEPTH * chalk.size
    low = max(low, high - _LACED_MOST * chalk.size)
    count = max(round((high - low - 3.0) / (_LACES_RISE * chalk.size)), 2)
    heights = np.linspace(high - 1.5, low + 1.5, count + 1)
    pieces: list[Trim] = []
    for ref, sign in ((right, -1), (left, 1)):
        across = sign * _LACED_APART * chalk.size
        for upper, lower in itertools.pairwise(heights):
            middle = (upper + lower) / 2
            for y in (upper, lower):
                x = chalk.middle(sign, float(middle))
                ends = [(across, float(y)), (x + sign * 0.3, float(middle))]
                pieces += chalk.line(name, ref.panel, ends, width=_LACE)
    return pieces


def _below_the_neck(chalk: Chalk) -> tuple[str, float, float] | None:
    """The left front, x of the middle beside its edge, and the height of the neck there, cm."""
    seam = front_edge(chalk.pattern)
    if seam is None or seam[1].panel not in chalk.views:
        return None
    _, left, _, high = seam
    return left.panel, chalk.middle(1, high - _BELOW_NECK) + 0.05, high
