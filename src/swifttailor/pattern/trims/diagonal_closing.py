"""The closing of a cheongsam: a piped edge from the neck to the armhole, held by knots."""

from __future__ import annotations

import numpy as np

from swifttailor.pattern.trims.chalk import Chalk
from swifttailor.pattern.trims.shapes import Trim

_FRONT = "right_ftorso"
_PIPING, _KNOT = 0.32, 0.75
"""Half the width of the piping and the radius of the knots, cm."""
_UNDERARM = 40.0
"""How far below the shoulder the underarm is at most, cm."""
_KNOTS = (1, 7, 12)
"""At which of its 14 points there are knots."""


def diagonal_closing(chalk: Chalk, name: str) -> list[Trim]:
    """A line from the middle of the neck to the wearer's right armhole, with knots."""
    view = chalk.views.get(_FRONT)
    if view is None:
        return []
    outline, s = view.outline, chalk.size
    upper = outline[outline[:, 1] > max((view.low + view.high) / 2 - 6.0 * s, view.high - _UNDERARM * s)]
    outermost = upper[upper[:, 0] < upper[:, 0].min() + 1.5]
    underarm = outermost[np.argmax(outermost[:, 1])]
    middle = outline[np.abs(outline[:, 0] - outline[:, 0].max()) < 1.0]
    start = np.array([middle[:, 0].max() - 0.6, middle[:, 1].max() - 0.9])
    end = underarm + np.array([1.4, -1.2]) * s
    t = np.linspace(0.0, 1.0, 14)[:, None]
    for bulge in (0.55, 0.35, 0.15, 0.0):
        bend = (start + end) / 2 + bulge * np.array([0.1 * (end - start)[0], 0.5 * (start - end)[1]])
        line = (1 - t) ** 2 * start + 2 * t * (1 - t) * bend + t**2 * end
        found = chalk.line(name, _FRONT, [(x, y) for x, y in line.tolist()], _PIPING * s)
        if found:
            for k in _KNOTS:
                found += chalk.button(name, _FRONT, (float(line[k, 0]), float(line[k, 1])), _KNOT * s)
            return found
    return []
