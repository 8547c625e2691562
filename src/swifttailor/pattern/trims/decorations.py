"""What is put on for its looks: frills and fringe along edges, bows, lacing, a cord at the neck, an apron."""

from __future__ import annotations

import itertools

import numpy as np

from swifttailor.pattern.pattern import EdgeRef
from swifttailor.pattern.trims.chalk import Chalk
from swifttailor.pattern.trims.free_edges import armhole_edges, hem_edges, neck_edges, sleeve_ends
from swifttailor.pattern.trims.front_view import front_edge
from swifttailor.pattern.trims.shapes import Bow, Frill, StripKind, Trim

_NECK_FRILL, _SLEEVE_FRILL, _HEM_FRILL, _FRINGE = 4.0, 5.0, 8.0, 12.0
"""How far each goes beyond its edge, cm."""
_EDGING, _LACE_TRIM, _RIB, _HEM_RIB = 1.3, 3.5, 2.0, 3.0
"""How wide edging, lace and ribbed bands are, cm."""
_BOW, _BOW_TAIL = 15.0, 17.0
_BELOW_NECK = 1.0
"""A bow's knot and the ends of a cord begin so far below the neck, cm."""
_LACED_APART, _LACES_RISE, _LACE = 3.2, 3.6, 0.22
"""Distance of the eyelets from the middle, of one pair from the next, and half the width of the lace, cm."""
_LACED_LEAST, _LACED_MOST = 10.0, 28.0
_CORD = 15.0
_APRON_BESIDE, _APRON_ABOVE_HEM, _APRON_LEAST = 0.5, 0.14, 20.0
"""An apron's half width as a part of the skirt's, how far above the hem it ends as a part of its length,
and the shortest skirt that has room for one, cm."""


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


def neck_frill(chalk: Chalk, name: str) -> list[Trim]:
    """A gathered strip around the neck, or on top of the collar."""
    return _along(chalk, name, neck_edges(chalk.pattern), _NECK_FRILL)


def sleeve_frills(chalk: Chalk, name: str) -> list[Trim]:
    """A gathered strip at the end of each sleeve."""
    return _along(chalk, name, sleeve_ends(chalk.pattern), _SLEEVE_FRILL)


def hem_frill(chalk: Chalk, name: str) -> list[Trim]:
    """A gathered strip or threads along the hem."""
    edges = hem_edges(chalk.pattern)
    if name == "hem fringe":
        return _along(chalk, name, edges, _FRINGE, "threads")
    return _along(chalk, name, edges, _HEM_FRILL)


def edging(chalk: Chalk, name: str) -> list[Trim]:
    """A narrow strip along neck, hem and ends of sleeves; lace is wider, and not around a collar."""
    of_lace, pattern = name == "lace trim", chalk.pattern
    edges = (*neck_edges(pattern), *hem_edges(pattern), *(() if of_lace else sleeve_ends(pattern)))
    return _along(chalk, name, tuple(dict.fromkeys(edges)), _LACE_TRIM if of_lace else _EDGING, "flat")


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
    return [Bow(name, panel, (u, v), _BOW * chalk.size, _BOW_TAIL * chalk.size)]


def waist_bow(chalk: Chalk, name: str) -> list[Trim]:
    """In the middle of the waist in front, on a waistband, a bodice or a dress without a waist seam."""
    for panel in ("wb_front", "left_ftorso"):
        view = chalk.views.get(panel)
        column = None if view is None else view.column(0.3)
        if view is None or column is None:
            continue
        y = (column[0] + column[1]) / 2 if panel == "wb_front" else max(chalk.waist, column[0]) + 1.0
        if (y < column[1] - 3.0 or panel == "wb_front") and view.holds([(0.3, y)]):
            u, v = view.local([(0.3, y)])[0].tolist()
            return [Bow(name, panel, (u, v), _BOW * chalk.size, _BOW_TAIL * chalk.size)]
    return []


def neck_cord(chalk: Chalk, name: str) -> list[Trim]:
    """Two ends that hang from the neck in front."""
    seam = front_edge(chalk.pattern)
    if seam is None:
        return []
    right, left, low, high = seam
    s, pieces = chalk.size, []
    for ref, sign in ((right, -1), (left, 1)):
        if ref.panel not in chalk.views:
            return []
        top = chalk.height_within(chalk.views[ref.panel], sign * 3.0 * s, high + 2.0, low)
        ends = [(sign * x * s, top - y * s) for x, y in ((3.0, 0.3), (3.1, 0.5 * _CORD), (3.6, _CORD))]
        found = chalk.line(name, ref.panel, ends, width=0.35)
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


def apron(chalk: Chalk, name: str) -> list[Trim]:
    """A piece over the front of the skirt, from the waist to above the hem."""
    view = chalk.views.get("skirt_front")
    column = None if view is None else view.column(0.0)
    if view is None or column is None or column[1] - column[0] < _APRON_LEAST * chalk.size:
        return []
    low, high = column
    heights = np.linspace(low + _APRON_ABOVE_HEM * (high - low), high - 0.3, 9)
    spans = [view.span(float(y)) for y in heights]
    if any(span is None for span in spans):
        return []
    halves = [_APRON_BESIDE * min(-span[0], span[1]) for span in spans if span is not None]
    if min(halves) < 4.0 * chalk.size:
        return []
    sides = [[(sign * x, float(y)) for x, y in zip(halves, heights, strict=True)] for sign in (-1, 1)]
    return chalk.ruled(name, view.panel.name, sides[0], sides[1])


def _below_the_neck(chalk: Chalk) -> tuple[str, float, float] | None:
    """The left front, x of the middle beside its edge, and the height of the neck there, cm."""
    seam = front_edge(chalk.pattern)
    if seam is None or seam[1].panel not in chalk.views:
        return None
    _, left, _, high = seam
    return left.panel, chalk.middle(1, high - _BELOW_NECK) + 0.05, high
