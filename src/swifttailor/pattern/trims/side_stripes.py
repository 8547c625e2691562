"""Stripes down the outside of legs, sleeves and sides: ribbons over seams, as of track suits."""

from __future__ import annotations

import re

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.pattern.panel import Panel
from swifttailor.pattern.pattern import EdgeRef, Pattern
from swifttailor.pattern.trims.chalk import Chalk
from swifttailor.pattern.trims.shapes import Frill, Patch, Trim

_HALF = 1.3
"""How wide a stripe is on either side of its seam, cm."""
_ONE_OF_THREE = 0.9
"""How wide each of three stripes is, and the gaps between them, cm."""
_POINTS, _SLACK, _LEAST = 41, 0.04, 0.8
"""Of a line beside a seam, how exactly it lies on its panel, and what part of it has to, cm."""
_SLEEVE = re.compile(r"(left|right)_sleeve_[fb]$")
LEG = re.compile(r"pant_[fb]_[lr]$")
SIDE = re.compile(r"skirt_(front|back)|(left|right)_[fb]torso$")
"""Panels of legs, and those that have side seams."""
_STEEP = 0.7
"""A seam that runs down does so by at least such a part of its length."""


def side_stripes(chalk: Chalk, name: str) -> list[Trim]:
    """Down the outside of both legs, or down both sides of a skirt, dress or top."""
    pattern = chalk.pattern
    if any(LEG.match(panel.name) for panel in pattern.panels):
        return _stripes(chalk, name, outer_seams(pattern, LEG))
    return _stripes(chalk, name, outer_seams(pattern, SIDE))


def sleeve_stripes(chalk: Chalk, name: str) -> list[Trim]:
    """Down the outside of both sleeves, along the seam that lies on top."""
    return _stripes(chalk, name, top_seams(chalk.pattern))


def three_side_stripes(chalk: Chalk, name: str) -> list[Trim]:
    """Three narrow ones where one would lie, with gaps as wide between them."""
    pattern = chalk.pattern
    legs = any(LEG.match(panel.name) for panel in pattern.panels)
    return _three(chalk, name, outer_seams(pattern, LEG if legs else SIDE))


def three_sleeve_stripes(chalk: Chalk, name: str) -> list[Trim]:
    """The same down the outside of both sleeves."""
    return _three(chalk, name, top_seams(chalk.pattern))


def top_seams(pattern: Pattern) -> list[tuple[EdgeRef, EdgeRef]]:
    """Seams of both sleeves that lie on top."""
    found: list[tuple[EdgeRef, EdgeRef]] = []
    for arm in ("left", "right"):
        seams = [pair for pair in _seams(pattern, _SLEEVE) if pair[0].panel.startswith(arm)]
        high = max([_middle(pattern, pair[0])[1] for pair in seams], default=0.0)
        found += [pair for pair in seams if _middle(pattern, pair[0])[1] > high - 2.0]
    return found


def _stripes(chalk: Chalk, name: str, seams: list[tuple[EdgeRef, EdgeRef]]) -> list[Trim]:
    """Half a stripe on the front of each seam and half on its back."""
    found: list[Trim] = []
    for half in zip(*seams, strict=True):
        length = sum(chalk.pattern.edge_length(ref) for ref in half)
        found.append(Frill(name, half, _HALF * chalk.size, length, "flat"))
    return found


def _three(chalk: Chalk, name: str, seams: list[tuple[EdgeRef, EdgeRef]]) -> list[Trim]:
    """Half of the middle one, and one other, on either side of each seam; nothing without room for all."""
    wide = _ONE_OF_THREE * chalk.size
    found: list[Trim] = []
    for ref in [ref for pair in seams for ref in pair]:
        panel = chalk.pattern.panel(ref.panel)
        seam = panel.sample_edge(ref.edge, _POINTS)
        for near, far in ((0.0, 0.5 * wide), (1.5 * wide, 2.5 * wide)):
            lines = _inside(panel, seam, near, far)
            if lines is None:
                return []
            found.append(Patch(name, ref.panel, *lines, is_cut=False))
    return found


def _inside(panel: Panel, seam: Floats, near: float, far: float) -> tuple[Floats, Floats] | None:
    """Two lines (n, 2) along a seam (m, 2), so far inside of its panel, cm; None where they leave it."""
    import shapely

    cloth = shapely.Polygon(panel.outline(0.01)).buffer(_SLACK)
    along = np.gradient(seam, axis=0)
    across = np.stack([-along[:, 1], along[:, 0]], axis=1)
    across /= np.linalg.norm(across, axis=1, keepdims=True)
    middle = shapely.Point(seam[len(seam) // 2] + 0.5 * across[len(seam) // 2])
    across = across if cloth.contains(middle) else -across
    lines = seam + near * across, seam + far * across
    held = [all(cloth.contains(shapely.Point(line[k])) for line in lines) for k in range(len(seam))]
    inside = np.flatnonzero(held)  # ends that slant cut the corners of a strip off
    if len(inside) < _LEAST * len(seam) or np.ptp(inside) != len(inside) - 1:
        return None
    first, second = lines[0][inside], lines[1][inside]
    is_plain = shapely.Polygon([*first, *second[::-1]]).is_valid  # tight bends fold a strip over itself
    return (first, second) if is_plain else None


def outer_seams(pattern: Pattern, panels: re.Pattern[str]) -> list[tuple[EdgeRef, EdgeRef]]:
    """Seams between front and back that lie farthest out on their side and run down."""
    found = []
    for pair in _seams(pattern, panels):
        points = _points(pattern, pair[0])
        panel = pattern.panel(pair[0].panel)
        across = np.abs(panel.to_world(panel.outline(0.5))[:, 0])
        drop = abs(float(points[-1, 1] - points[0, 1]))
        runs_down = drop > _STEEP * float(np.linalg.norm(np.diff(points, axis=0), axis=1).sum())
        inner, outer = float(across.min()), float(across.max())
        if runs_down and float(np.abs(points[:, 0]).mean()) > (inner + outer) / 2:
            found.append(pair)
    return found


def _seams(pattern: Pattern, panels: re.Pattern[str]) -> list[tuple[EdgeRef, EdgeRef]]:
    """Seams of a front with a back among some panels, the front's edge first."""
    found = []
    for stitch in pattern.stitches:
        one, other = sorted(stitch.sides, key=lambda ref: _is_back(ref.panel))
        both = panels.match(one.panel) and panels.match(other.panel)
        if both and _is_back(one.panel) != _is_back(other.panel):
            found.append((one, other))
    return found


def _is_back(panel: str) -> bool:
    return re.search(r"(^|_)(b|back|btorso)(_|$)", panel) is not None


def _points(pattern: Pattern, ref: EdgeRef) -> np.ndarray:
    panel = pattern.panel(ref.panel)
    return panel.to_world(panel.sample_edge(ref.edge, 9))


def _middle(pattern: Pattern, ref: EdgeRef) -> np.ndarray:
    return _points(pattern, ref).mean(axis=0)
