"""Rips: holes in the cloth with threads left across them, and edges that are frayed."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.pattern.drafts.figure import KNEE_PER_CROTCH
from swifttailor.pattern.trims.chalk import Chalk
from swifttailor.pattern.trims.free_edges import hem_edges, leg_ends
from swifttailor.pattern.trims.front_view import FrontView
from swifttailor.pattern.trims.shapes import Frill, Patch, Trim

Rip = tuple[float, float, float, float]
"""Height from the knee, or from the hem as a part of what is above it; its place across the panel as a part
of that; width and height, cm."""

_FRAYED = 2.2
"""How far threads hang from a frayed edge, cm."""
_KNEE: Rip = (0.0, 0.5, 13.0, 4.6)
_LEGS: dict[str, tuple[Rip, ...]] = {
    "l": ((18.0, 0.52, 12.0, 2.8), (0.0, 0.5, 13.0, 4.6), (-15.0, 0.56, 8.0, 2.2)),
    "r": ((24.0, 0.58, 9.0, 2.2), (12.0, 0.45, 11.5, 2.8), (-1.0, 0.5, 13.0, 4.2)),
}
"""Where ripped trousers are torn, by leg: not alike, as nothing that is worn through is."""
_SHORT: dict[str, tuple[Rip, ...]] = {
    "l": ((0.34, 0.5, 9.0, 2.6), (0.7, 0.42, 7.0, 2.0)),
    "r": ((0.55, 0.5, 9.0, 2.6),),
}
"""The same of what ends above the knee."""
_SHORT_ABOVE = 10.0
"""There they lie between the hem and so far above the crotch, cm."""
_SKIRT: tuple[Rip, ...] = ((0.22, 0.68, 11.0, 2.8), (0.4, 0.36, 12.0, 3.0), (0.62, 0.62, 9.0, 2.4))
_TORSO: dict[str, tuple[Rip, ...]] = {
    "left": ((0.16, 0.5, 9.0, 2.4), (0.42, 0.6, 7.0, 2.2)),
    "right": ((0.28, 0.45, 8.0, 2.2),),
}
_SIDES = {"rips": "lr", "knee rips": "lr", "left knee rip": "l", "right knee rip": "r"}
_WIDEST, _NARROWEST = 0.62, 4.0
"""A rip's width at most as a part of its panel's, and at least, cm."""
_ABOVE_HEM = 2.0
_BLUNT = 0.12
"""Half its height where it ends, cm."""
_APART, _THREAD = 0.75, 0.11
"""Distance of the threads across a rip and half their width, cm."""


def rips(chalk: Chalk, name: str) -> list[Trim]:
    """Holes in the fronts of both legs, at their knees alone, or in a skirt or top."""
    if any(f"pant_f_{side}" in chalk.views for side in "lr"):
        found: list[Trim] = []
        for side in _SIDES[name]:
            own = _on_leg(chalk, name, f"pant_f_{side}", side)
            if not own:
                return []
            found += own
        return found
    if name != "rips":
        return []
    if "skirt_front" in chalk.views:
        return _torn(chalk, name, "skirt_front", _SKIRT)
    return [
        piece
        for side, own in _TORSO.items()
        if f"{side}_ftorso" in chalk.views
        for piece in _torn(chalk, name, f"{side}_ftorso", own)
    ]


def frayed_hem(chalk: Chalk, name: str) -> list[Trim]:
    """Short threads along the hem, or the ends of both legs."""
    pattern = chalk.pattern
    legs = (*leg_ends(pattern, "l")[0], *leg_ends(pattern, "r")[0])
    edges = tuple(dict.fromkeys(legs)) or hem_edges(pattern)
    if not edges:
        return []
    length = sum(pattern.edge_length(ref) for ref in edges)
    return [Frill(name, edges, _FRAYED * chalk.size, length, "threads")]


def threads_across(rip: Patch) -> list[Patch]:
    """The threads that are left in a rip, and those along its two sides.

    Args:
        rip: A hole, from its lower to its upper side.
    """
    middle = len(rip.first) // 2
    height = float(np.linalg.norm(rip.second[middle] - rip.first[middle]))
    count = max(int(height / _APART), 2)
    shares = np.linspace(0.0, 1.0, count + 1)
    return [_thread(rip, float(share), height) for share in shares]


def _thread(rip: Patch, share: float, height: float) -> Patch:
    half = min(_THREAD / height, 0.5)
    low, high = max(share - half, 0.0), min(share + half, 1.0)
    across = rip.second - rip.first
    return Patch(
        rip.trim, rip.panel, rip.first + low * across, rip.first + high * across, "thread", is_cut=False
    )


def _on_leg(chalk: Chalk, name: str, panel: str, side: str) -> list[Trim]:
    view = chalk.views.get(panel)
    if view is None:
        return []
    knee = KNEE_PER_CROTCH * chalk.crotch
    is_long = view.low < knee - (_KNEE[3] / 2 + _ABOVE_HEM) * chalk.size
    if name != "rips":
        return _hole(chalk, name, view, knee, _KNEE) if is_long else []
    if not is_long:
        return _torn(chalk, name, panel, _SHORT[side], top=chalk.crotch + _SHORT_ABOVE * chalk.size)
    pieces: list[Trim] = []
    for rip in _LEGS[side]:
        y = knee + rip[0] * chalk.size
        if view.low + (rip[3] / 2 + _ABOVE_HEM) * chalk.size < y:
            pieces += _hole(chalk, name, view, y, rip)
    return pieces


def _torn(chalk: Chalk, name: str, panel: str, places: Sequence[Rip], top: float | None = None) -> list[Trim]:
    """Holes between a panel's hem and its top, or a height, cm."""
    view = chalk.views[panel]
    high = view.high if top is None else min(max(top, view.low + 8.0 * chalk.size), view.high)
    pieces: list[Trim] = []
    for rip in places:
        low = view.low + (_ABOVE_HEM + rip[3] / 2) * chalk.size
        pieces += _hole(chalk, name, view, low + rip[0] * max(high - low, 0.0), rip)
    return pieces


def _hole(chalk: Chalk, name: str, view: FrontView, y: float, rip: Rip) -> list[Trim]:
    """One hole, wider than high and pointed at both ends; nothing where the panel has no room for it."""
    span = view.span(y)
    if span is None:
        return []
    (low, high), (_, place, width, height) = span, rip
    # Across from the middle of the body outwards; of a skirt's front from right to left.
    at = low + place * (high - low) if low + high >= 0 or low * high < 0 else high - place * (high - low)
    width = min(width * chalk.size, _WIDEST * (high - low))
    if width < _NARROWEST * chalk.size:
        return []
    along = np.linspace(-0.5, 0.5, 9)
    bulge = np.maximum(0.5 * height * chalk.size * (1.0 - (2.0 * along) ** 2), _BLUNT)
    sides: list[Floats] = [np.stack([at + width * along, y + sign * bulge], axis=1) for sign in (-1.0, 1.0)]
    lines = [[(float(a), float(b)) for a, b in side] for side in sides]
    return chalk.ruled(name, view.panel.name, lines[0], lines[1], "hole", is_cut=False)
