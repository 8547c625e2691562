"""Stripes down the outside of legs, sleeves and sides: ribbons over seams, as of track suits."""

from __future__ import annotations

import re

import numpy as np

from swifttailor.pattern.pattern import EdgeRef, Pattern
from swifttailor.pattern.trims.chalk import Chalk
from swifttailor.pattern.trims.shapes import Frill, Trim

_HALF = 1.3
"""How wide a stripe is on either side of its seam, cm."""
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
    pattern = chalk.pattern
    found: list[tuple[EdgeRef, EdgeRef]] = []
    for arm in ("left", "right"):
        seams = [pair for pair in _seams(pattern, _SLEEVE) if pair[0].panel.startswith(arm)]
        high = max([_middle(pattern, pair[0])[1] for pair in seams], default=0.0)
        found += [pair for pair in seams if _middle(pattern, pair[0])[1] > high - 2.0]
    return _stripes(chalk, name, found)


def _stripes(chalk: Chalk, name: str, seams: list[tuple[EdgeRef, EdgeRef]]) -> list[Trim]:
    """Half a stripe on the front of each seam and half on its back."""
    found: list[Trim] = []
    for half in zip(*seams, strict=True):
        length = sum(chalk.pattern.edge_length(ref) for ref in half)
        found.append(Frill(name, half, _HALF * chalk.size, length, "flat"))
    return found


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
