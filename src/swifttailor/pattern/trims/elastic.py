"""The folds that elastic draws a waist into, and the rows of stitches that hold it."""

from __future__ import annotations

import numpy as np

from swifttailor.pattern.pattern import EdgeRef
from swifttailor.pattern.trims.chalk import Chalk
from swifttailor.pattern.trims.front_view import FrontView
from swifttailor.pattern.trims.shapes import Trim

_BANDS = ("wb_front", "wb_back")
_LOWER = ("skirt_", "pant_")
"""What hangs from the waist."""
_ROWS = (0.5,)
"""Heights of the rows of stitches, as parts of the band's."""
_BESIDE = 0.7
"""Rows and folds keep so far from the ends of their panel, cm."""
_APART, _FOLD, _STITCH = 2.8, 0.06, 0.05
"""Distance of folds where they are gathered, half their width, and half that of a row, cm."""
_DEEP = (3.4, 2.2, 4.8, 2.6, 4.0, 2.4)
"""How far folds run down from the band, one after the other, cm."""
_GATHERED = 1.08
"""Cloth that is wider than the band by less lies smooth below it, as leggings do, and skirts never do."""


def waist_elastic(chalk: Chalk, name: str) -> list[Trim]:
    """Rows along a waistband, and folds in it and below it where cloth is gathered into it.

    Of dresses, folds above and below the waist where the skirt is gathered into it.
    """
    has_bands = all(band in chalk.views for band in _BANDS)
    if "left_ftorso" in chalk.views and not (has_bands and "skirt_front" in chalk.views):
        return _at_waist_seam(chalk, name)
    if not has_bands:
        return []
    pieces: list[Trim] = []
    for band in _BANDS:
        rows = _rows(chalk, name, chalk.views[band])
        if not rows:
            return []
        pieces += rows
        below = _sewn_below(chalk, band)
        fullness = sum(chalk.pattern.edge_length(ref) for ref in below) / _bottom(chalk, band)
        if fullness < _GATHERED and "left_ftorso" in chalk.views:
            return []
        if fullness < _GATHERED and "skirt_front" not in chalk.views:
            continue
        pieces += _folds_of_band(chalk, name, chalk.views[band])
        for panel in dict.fromkeys(ref.panel for ref in below):
            if panel in chalk.views:
                pieces += _folds_below(chalk, name, chalk.views[panel], _APART * fullness)
    return pieces


def back_elastic(chalk: Chalk, name: str) -> list[Trim]:
    """A row and folds along the back of a waistband, whose front stays smooth."""
    view = chalk.views.get("wb_back")
    if view is None or "wb_front" not in chalk.views:
        return []
    rows = _rows(chalk, name, view)
    return [*rows, *_folds_of_band(chalk, name, view)] if rows else []


def _at_waist_seam(chalk: Chalk, name: str) -> list[Trim]:
    """Folds on both sides of the seam that joins a gathered skirt to a bodice."""
    skirts: dict[str, float] = {}
    torsos: dict[str, float] = {}
    for stitch in chalk.pattern.stitches:
        first, second = sorted(stitch.sides, key=lambda ref: "torso" in ref.panel)
        if first.panel.startswith("skirt_") and "torso" in second.panel:
            for ref, lengths in ((first, skirts), (second, torsos)):
                lengths[ref.panel] = lengths.get(ref.panel, 0.0) + chalk.pattern.edge_length(ref)
    fullness = sum(skirts.values()) / max(sum(torsos.values()), 1.0)
    if fullness < _GATHERED:
        return []
    pieces: list[Trim] = []
    for panel in (one for one in skirts if one in chalk.views):
        pieces += _folds_below(chalk, name, chalk.views[panel], _APART * fullness)
    for panel in (one for one in torsos if one in chalk.views):
        pieces += _folds_above(chalk, name, chalk.views[panel])
    return pieces


def _folds_above(chalk: Chalk, name: str, view: FrontView) -> list[Trim]:
    near = view.outline[view.outline[:, 1] <= view.low + 3.0]
    low, high = float(near[:, 0].min()) + _BESIDE, float(near[:, 0].max()) - _BESIDE
    pieces: list[Trim] = []
    for k, x in enumerate(np.linspace(low, high, max(round((high - low) / (_APART * chalk.size)), 2))):
        column = view.column(float(x))
        if column is not None:
            deep = 0.8 * _DEEP[k % len(_DEEP)] * chalk.size
            ends = [(float(x), column[0] + 0.2), (float(x), column[0] + deep)]
            pieces += chalk.line(name, view.panel.name, ends, width=_FOLD)
    return pieces


def _rows(chalk: Chalk, name: str, view: FrontView) -> list[Trim]:
    xs = _places(view, 9)
    columns = [view.column(float(x)) for x in xs]
    pieces: list[Trim] = []
    for share in _ROWS:
        line = [
            (float(x), column[0] + share * (column[1] - column[0]))
            for x, column in zip(xs, columns, strict=True)
            if column is not None
        ]
        found = chalk.line(name, view.panel.name, line, width=_STITCH)
        if not found:
            return []
        pieces += found
    return pieces


def _folds_of_band(chalk: Chalk, name: str, view: FrontView) -> list[Trim]:
    pieces: list[Trim] = []
    for x in _places(view, max(round(_width(view) / (_APART * chalk.size)), 2)):
        column = view.column(float(x))
        if column is not None:
            ends = [(float(x), column[0] + 0.15), (float(x), column[1] - 0.15)]
            pieces += chalk.line(name, view.panel.name, ends, width=_FOLD)
    return pieces


def _folds_below(chalk: Chalk, name: str, view: FrontView, apart: float) -> list[Trim]:
    pieces: list[Trim] = []
    for k, x in enumerate(_places(view, max(round(_width(view) / (apart * chalk.size)), 2))):
        top = chalk.top_at(view, float(x)) - 0.2
        ends = [(float(x), top), (float(x), top - _DEEP[k % len(_DEEP)] * chalk.size)]
        pieces += chalk.line(name, view.panel.name, ends, width=_FOLD)
    return pieces


def _places(view: FrontView, count: int) -> np.ndarray:
    """Distances from the middle across the upper edge of a panel, evenly apart."""
    low, high = _ends(view)
    return np.linspace(low + _BESIDE, high - _BESIDE, count)


def _width(view: FrontView) -> float:
    low, high = _ends(view)
    return high - low


def _ends(view: FrontView) -> tuple[float, float]:
    """Smallest and greatest x near the upper edge of a panel: a band's ends, or where a waist begins."""
    near = view.outline[view.outline[:, 1] >= view.high - max(0.5 * min(view.high - view.low, 6.0), 1.0)]
    return float(near[:, 0].min()), float(near[:, 0].max())


def _sewn_below(chalk: Chalk, band: str) -> tuple[EdgeRef, ...]:
    """Edges of what hangs from a band."""
    found = []
    for stitch in chalk.pattern.stitches:
        first, second = stitch.sides
        for own, other in ((first, second), (second, first)):
            if own.panel == band and other.panel.startswith(_LOWER):
                found.append(other)
    return tuple(dict.fromkeys(found))


def _bottom(chalk: Chalk, band: str) -> float:
    """Length of the edges of a band that something hangs from, cm."""
    refs = {
        ref
        for stitch in chalk.pattern.stitches
        for ref in stitch.sides
        if ref.panel == band and any(side.panel.startswith(_LOWER) for side in stitch.sides)
    }
    return max(sum(chalk.pattern.edge_length(ref) for ref in refs), 1.0)
