"""What is bought beside the cloth: buttons, zips, a buckle, cord, interfacing."""

from __future__ import annotations

import math

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.making.pieces import CuttingPlan
from swifttailor.making.trim_words import ZIPS
from swifttailor.making.waist_girth import waist_girth
from swifttailor.pattern.trims import Belt, Button, Patch
from swifttailor.pattern.trims.front_view import FrontView

_ENDS_CM = 60.0
"""Of a cord, beyond the waist."""
_FLY_SHORTER_CM = 1.5
"""The zip of a fly ends above its topstitching."""


def notions(plan: CuttingPlan) -> list[str]:
    """Lines of a shopping list; none where nothing is put on the pattern."""
    lines = [f"{count} button{'s' * (count != 1)} of {mm} mm" for mm, count in sorted(buttons(plan).items())]
    lines += [f"{kind} of {math.floor(cm + 0.05)} cm (or the next shorter one)" for kind, cm in zips(plan)]
    for trim in plan.trims:
        if isinstance(trim, Belt) and trim.trim == "buckle belt":
            lines.append(f"buckle for a belt of {round(10 * trim.width)} mm")
    if any(trim.trim == "drawstring" for trim in plan.trims):
        length = 10 * math.ceil((waist_girth(plan.sewn.pattern) + _ENDS_CM) / 10)
        lines.append(f"cord of {length} cm, and 2 eyelets")
    if any(trim.trim == "elastic waist" for trim in plan.trims):
        length = 5 * math.ceil(waist_girth(plan.sewn.pattern) / 5)
        lines.append(f"elastic of {length} cm, a little narrower than the waistband")
    if any(trim.trim == "back elastic" for trim in plan.trims):
        length = 5 * math.ceil(0.375 * waist_girth(plan.sewn.pattern) / 5)
        lines.append(f"elastic of {length} cm, a little narrower than the waistband")
    stiff = [piece.name for piece in plan.pieces if "interfacing" in piece.cloth]
    if stiff:
        lines.append(f"interfacing for: {', '.join(stiff)}")
    return lines


def buttons(plan: CuttingPlan) -> dict[int, int]:
    """How many buttons by their diameter in mm."""
    found: dict[int, int] = {}
    for trim in plan.trims:
        if isinstance(trim, Button):
            mm = round(20 * trim.radius)
            found[mm] = found.get(mm, 0) + 1
    return found


def zips(plan: CuttingPlan) -> list[tuple[str, float]]:
    """The kind and length in cm of every zip."""
    found = []
    for name in plan.sewn.pattern.trims:
        own = [t for t in plan.trims if isinstance(t, Patch) and t.trim == name]
        if not own:
            continue
        if name == "fly":
            line = (own[0].first + own[0].second) / 2
            found.append(("zip", float(np.ptp(line[:, 1])) - _FLY_SHORTER_CM))
        elif name in ZIPS:
            teeth = [t for t in own if t.look == "metal"] or own
            panel = teeth[0].panel
            length = sum(_length(t.first) for t in teeth if t.panel == panel)
            opens = plan.closing is not None and plan.closing.trim == name
            found.append(("separating zip" if opens else "zip", length + (_band(plan) if opens else 0.0)))
    return found


def _length(points: Floats) -> float:
    return float(np.hypot(*np.diff(points, axis=0).T).sum())


def _band(plan: CuttingPlan) -> float:
    """Height of a band in front of which a zip goes on, cm."""
    band = next((panel for panel in plan.sewn.pattern.panels if panel.name == "wb_front"), None)
    column = None if band is None else FrontView(band).column(0.0)
    return 0.0 if column is None else column[1] - column[0]
