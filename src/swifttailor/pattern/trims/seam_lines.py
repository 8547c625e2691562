"""Lines where a tailor joins pieces that are cut as one here: princess seams and yokes."""

from __future__ import annotations

import numpy as np

from swifttailor.pattern.trims.chalk import Chalk, Point
from swifttailor.pattern.trims.front_view import FrontView
from swifttailor.pattern.trims.shapes import Patch, Trim

_SIDES = (("left", 1.0), ("right", -1.0))
_SEAM = 0.2
"""Half the width of a seam as it is drawn, cm."""
_AT_WAIST, _AT_HEM = 0.42, 0.42
"""Where princess seams lie at the waist and at the hem, as parts of half the width."""
_BELOW_SHOULDER, _INSIDE = 10.0, 0.6
"""How far below the shoulders they begin in the armhole, and how far they stay from edges, cm."""
_STEP = 1.0
"""By how much higher a seam is tried to end where it finds no place, cm."""
_YOKE, _HIP_YOKE, _POINT = 9.5, 10.0, 3.0
"""How far below shoulders and waist yokes end, and by how much that of a hip is lower in the middle, cm."""
_HIPS = (
    ("skirt_front", "skirt_back"),
    ("pant_b_l", "pant_b_r"),
)


def princess_seams(chalk: Chalk, name: str) -> list[Trim]:
    """From the armholes over the bust to the waist, and on down a skirt to its hem, in front and behind."""
    pieces: list[Trim] = []
    for part in ("ftorso", "btorso"):
        half = [
            _over_bust(chalk, name, chalk.views[f"{side}_{part}"], sign)
            for side, sign in _SIDES
            if f"{side}_{part}" in chalk.views
        ]
        if len(half) != len(_SIDES) or not all(half):
            half = []
        pieces += [piece for one in half for piece in one]
    for panel in ("skirt_front", "skirt_back"):
        view = chalk.views.get(panel)
        if view is not None:
            both = [_down(chalk, name, view, sign) for _, sign in _SIDES]
            pieces += [piece for one in both for piece in one] if all(both) else []
    return pieces


def princess_panels(chalk: Chalk, name: str) -> list[Trim]:
    """The same of dresses that have no waist seam: on bodice and skirt, or nowhere."""
    pieces = princess_seams(chalk, name)
    upper = any("torso" in panel for panel in chalk.views)
    below = any(isinstance(piece, Patch) and piece.panel.startswith("skirt") for piece in pieces)
    return pieces if upper and below else []


def yoke(chalk: Chalk, name: str) -> list[Trim]:
    """A seam across chest and upper back; of skirts around the hips, of trousers behind."""
    if any(f"{side}_ftorso" in chalk.views for side, _ in _SIDES):
        return _across_shoulders(chalk, name)
    for panels in _HIPS:
        views = [chalk.views[panel] for panel in panels if panel in chalk.views]
        if len(views) == len(panels):
            pieces = [piece for view in views for piece in _around_hips(chalk, name, view)]
            return pieces if len(pieces) == len(views) else []
    return []


def back_yoke(chalk: Chalk, name: str) -> list[Trim]:
    """A seam across the upper back alone."""
    return _across_shoulders(chalk, name, ("btorso",))


def _over_bust(chalk: Chalk, name: str, view: FrontView, sign: float) -> list[Trim]:
    """From the armhole, or the upper edge of a strapless bodice, to the lower edge."""
    s, panel = chalk.size, view.panel.name
    low = view.low + _INSIDE
    width = _half(view, max(chalk.waist, low + 1.0), sign)
    if width is None:
        return []
    x = _AT_WAIST * width
    begin = chalk.shoulder - _BELOW_SHOULDER * s
    out = _half(view, begin, sign)
    bust = (begin + chalk.waist) / 2
    if out is None or out < x + 1.0 or view.high < begin + 4.0 * s:
        top = chalk.top_at(view, sign * x) - _INSIDE
        line: list[Point] = [(sign * x, float(y)) for y in np.linspace(top, low, 12)]
        return chalk.line(name, panel, line, _SEAM)
    t = np.linspace(0.0, 1.0, 14)
    start = np.array([out - _INSIDE, begin])
    curve = (
        (1 - t)[:, None] ** 2 * start
        + (2 * t * (1 - t))[:, None] * (x, begin - 1.0)
        + (t**2)[:, None] * (x, bust)
    )
    # What is taken in by a dart from the hem ends at its tip, which goes on as the seam does.
    for end in np.arange(low, bust - 2.0, _STEP):
        below = [(x, float(y)) for y in np.linspace(bust, end, 10)[1:]]
        points = [*[(float(a), float(b)) for a, b in curve], *below]
        found = chalk.line(name, panel, [(sign * a, b) for a, b in points], _SEAM)
        if found:
            return found
    return []


def _down(chalk: Chalk, name: str, view: FrontView, sign: float) -> list[Trim]:
    """From the waist to the hem of a skirt."""
    top, low = view.high - 1.5 * chalk.size, view.low + 1.5 * chalk.size
    first, last = _half(view, top, sign), _half(view, low + 2.0, sign)
    if first is None or last is None:
        return []
    ends = np.array([(_AT_WAIST * first, top), (_AT_HEM * last, low)])
    upper = chalk.top_at(view, sign * float(ends[0, 0])) - _INSIDE
    ends[0, 1] = upper
    lower = view.column(sign * float(ends[1, 0]))
    ends[1, 1] = low if lower is None else lower[0] + _INSIDE
    line = [(sign * float(x), float(y)) for x, y in np.linspace(ends[0], ends[1], 14)]
    return chalk.line(name, view.panel.name, line, _SEAM)


def _across_shoulders(chalk: Chalk, name: str, parts: tuple[str, ...] = ("ftorso", "btorso")) -> list[Trim]:
    y = chalk.shoulder - _YOKE * chalk.size
    pieces: list[Trim] = []
    for part in parts:
        for side, sign in _SIDES:
            view = chalk.views.get(f"{side}_{part}")
            span = None if view is None else view.span(y)
            if view is None or span is None:
                return []
            inner, outer = sorted((sign * span[0], sign * span[1]))
            line = [(sign * float(x), y) for x in np.linspace(inner + 0.1, outer - _INSIDE, 8)]
            found = chalk.line(name, view.panel.name, line, _SEAM)
            if not found:
                return []
            pieces += found
    return pieces


def _around_hips(chalk: Chalk, name: str, view: FrontView) -> list[Trim]:
    """A line below the waist, lower in the middle of the body; level on the way around a skirt."""
    s = chalk.size
    y = view.high - _HIP_YOKE * s
    span = view.span(y)
    if span is None or view.high - view.low < 2.0 * _HIP_YOKE * s:
        return []
    low, high = span[0] + _INSIDE, span[1] - _INSIDE
    xs = np.linspace(low, high, 16)
    dip = _POINT * s * (1.0 - np.abs(xs) / max(abs(low), abs(high)))
    line = [(float(x), float(y - d)) for x, d in zip(xs, dip, strict=True)]
    return chalk.line(name, view.panel.name, line, _SEAM)


def _half(view: FrontView, y: float, sign: float) -> float | None:
    """How far a half reaches from the middle at a height, cm."""
    span = view.span(y)
    return None if span is None else abs(span[1] if sign > 0 else span[0])
