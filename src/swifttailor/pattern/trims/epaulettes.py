"""Epaulettes: tabs along both shoulders, buttoned near the neck."""

from __future__ import annotations

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.pattern.trims.chalk import Chalk
from swifttailor.pattern.trims.front_view import FrontView
from swifttailor.pattern.trims.shapes import Trim

_HALF_WIDTH, _AT_NECK, _AT_ARMHOLE = 2.4, 0.2, 0.97
"""Half the width of a tab, cm; where it begins and ends along the shoulder, as parts of it from the neck."""
_INSIDE, _BUTTON, _POINT = 0.15, 0.55, 0.75
"""How far from the shoulder seam each half lies, the button's radius, cm; and the width of the end at the
neck, which is pointed, over the other."""
_SHORTEST = 6.0


def epaulettes(chalk: Chalk, name: str) -> list[Trim]:
    """A tab on each shoulder, one half of it in front of the seam and one behind."""
    pieces: list[Trim] = []
    for side in ("left", "right"):
        for part in ("ftorso", "btorso"):
            view = chalk.views.get(f"{side}_{part}")
            seam = None if view is None else _shoulder(chalk, view, f"{side}_{part}", side)
            if view is None or seam is None:
                return []
            neck, tip = seam
            along = tip - neck
            if float(np.linalg.norm(along)) < _SHORTEST * chalk.size:
                return []
            unit = along / np.linalg.norm(along)
            down = np.array([unit[1], -unit[0]]) if unit[0] > 0 else np.array([-unit[1], unit[0]])
            shares = np.linspace(_AT_NECK, _AT_ARMHOLE, 6)
            deep = np.full(6, _HALF_WIDTH * chalk.size)
            deep[0] *= 1.0 - _POINT
            base = neck + shares[:, None] * along
            upper, lower = base + _INSIDE * down, base + (_INSIDE + deep)[:, None] * down
            if not view.bridges(np.concatenate([upper, lower, (upper[:1] + lower[:1]) / 2])):
                return []
            first = [(float(x), float(y)) for x, y in upper]
            second = [(float(x), float(y)) for x, y in lower]
            found = chalk.ruled(name, view.panel.name, first, second, to_the_edge=True)
            pieces += found
            if part == "ftorso":
                x, y = (base[1] + 0.9 * chalk.size * down).tolist()
                pieces += chalk.button(name, view.panel.name, (x, y), _BUTTON * chalk.size)
    return pieces


def _shoulder(chalk: Chalk, view: FrontView, panel: str, side: str) -> tuple[Floats, Floats] | None:
    """The ends of the shoulder seam at neck and armhole; None where front and back do not meet there."""
    other = panel.replace("ftorso", "btorso") if "ftorso" in panel else panel.replace("btorso", "ftorso")
    ends = []
    for stitch in chalk.pattern.stitches:
        if {ref.panel for ref in stitch.sides} != {panel, other}:
            continue
        ref = next(ref for ref in stitch.sides if ref.panel == panel)
        seen = view.seen(view.panel.chord(ref.edge))
        if abs(seen[0, 0] - seen[1, 0]) > abs(seen[0, 1] - seen[1, 1]):  # side seams are steep
            ends += list(seen)
    if not ends:
        return None
    order = sorted(ends, key=lambda point: abs(float(point[0])))
    return order[0], order[-1]
