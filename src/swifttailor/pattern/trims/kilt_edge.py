"""What a kilt's front is told by: the edge of the upper apron, its pin, and buckles at the waist."""

from __future__ import annotations

import numpy as np

from swifttailor.pattern.trims.chalk import Chalk
from swifttailor.pattern.trims.shapes import Trim

_FRONTS = ("skirt_front", "skirt_pleat_0_front")
_AT = 0.46
"""Where the edge lies on the wearer's right, as a part of half the width of the front."""
_EDGE, _FRINGE = 0.22, 1.2
"""Half the width of the edge as it is drawn, and how wide the fringe beside it is, cm."""
_PIN_HALF, _PIN_LONG, _PIN_ABOVE, _PIN_INSIDE = 0.45, 8.0, 9.0, 3.5
"""Of the pin: half its width, its length, how far above the hem and how far inside of the edge it is, cm."""
_BUCKLE, _STRAP, _BELOW_BAND = 1.5, 5.5, 3.5
"""Of a buckle: half its height, the length of its strap, and how far below the waistband the lower is, cm."""


def kilt_edge(chalk: Chalk, name: str) -> list[Trim]:
    """On a flat front, from the waist to the hem; nothing where the front is narrow or folded."""
    s, band = chalk.size, chalk.views.get("wb_front")
    view = next((chalk.views[panel] for panel in _FRONTS if panel in chalk.views), None)
    spans = [] if view is None else [view.span(view.high - 2.0), view.span(view.low + 2.0)]
    if view is None or band is None or not spans or any(span is None for span in spans):
        return []
    xs = [-_AT * min(-span[0], span[1]) for span in spans if span is not None]
    if max(xs) > -4.5 * s or view.high - view.low < 25.0 * s:
        return []
    high, low = chalk.top_at(view, xs[0]) - 0.5, view.low + 1.2
    column = view.column(xs[1])
    low = low if column is None else column[0] + 0.6
    line = [(float(x), float(y)) for x, y in np.linspace((xs[0], high), (xs[1], low), 16)]
    edge = chalk.line(name, view.panel.name, line, _EDGE)
    threads = chalk.line(name, view.panel.name, [(x - _FRINGE * s, y) for x, y in line], 0.12)
    if not edge:
        return []
    y = low + _PIN_ABOVE * s
    x = float(np.interp(y, (low, high), (xs[1], xs[0]))) + _PIN_INSIDE * s
    pin = chalk.ruled(
        name,
        view.panel.name,
        [(x - _PIN_HALF * s, y), (x + _PIN_HALF * s, y)],
        [(x - _PIN_HALF * s, y + _PIN_LONG * s), (x + _PIN_HALF * s, y + _PIN_LONG * s)],
        "metal",
        is_cut=False,
    )
    return [*edge, *threads, *pin, *_buckle(chalk, name, view.panel.name, (xs[0], high - _BELOW_BAND * s))]


def _buckle(chalk: Chalk, name: str, panel: str, at: tuple[float, float]) -> list[Trim]:
    """A strap with a frame of metal at its end, across the edge."""
    (x, y), s = at, chalk.size
    half = _BUCKLE * s
    ends = [(x - 1.5 * s, x + _STRAP * s, 0.6 * half, "cloth"), (x + 1.0 * s, x + 3.2 * s, half, "metal")]
    pieces: list[Trim] = []
    for left, right, tall, look in ends:
        pieces += chalk.ruled(
            name,
            panel,
            [(left, y - tall), (right, y - tall)],
            [(left, y + tall), (right, y + tall)],
            "metal" if look == "metal" else "cloth",
            is_cut=look == "cloth",
        )
    return pieces if len(pieces) == len(ends) else []
