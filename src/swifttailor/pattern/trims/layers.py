"""Layers over a skirt that hang from its waist, trains on the floor behind it, and skirts over swimsuits."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from swifttailor.pattern.trims.chalk import Chalk
from swifttailor.pattern.trims.front_view import FrontView
from swifttailor.pattern.trims.shapes import Layer, Trim

_ON_FLOOR = 26.0
"""Skirts that end higher above the floor have no train, cm."""
_SHORTEST = 26.0
"""Skirts that are shorter have no layer over them, cm."""
_BELOW_WAIST = 0.5
"""How far below the seam of the waist the upper edge of a layer lies, cm."""
_BELOW_SHOULDER = 4.0
"""A cape hangs from so far below the points of the shoulders, cm."""
_CLEAR_OF_FLOOR, _LEAST = 1.0, 10.0
"""How high a layer ends at least, and how long it is, cm."""
_OVER_LEGS = "outer skirt"
_SHOWN, _LEGLESS, _CALVES, _ABOVE_CALVES = 4.0, 36.0, 72.0, 46.0
"""How much of shorts is seen below a skirt over them, where legs end that are none, and where those end that
are no shorts; over these a skirt ends at the thigh, so far below the waist, cm."""
_SKIRTS = ("skirt", "wb_", "ftorso", "btorso", "godet")


@dataclass(frozen=True)
class _Cut:
    """How a layer is cut, of an adult."""

    flare: float = 0.0
    """How far its hem stands off that of the skirt, cm."""
    reach: float = 180.0
    """How far it goes to both sides of the middle of the back, degrees."""
    behind: float = 0.0
    """How far it lies on the floor behind, cm."""
    opacity: float = 1.0
    """Share of what lies beneath that it hides."""
    long: float = 0.0
    """How far it hangs, cm; 0: as far as the skirt."""
    from_shoulders: bool = False
    """Whether it hangs from there, and not from the waist."""
    puffs: int = 0
    """How many puffs it is gathered up into."""
    puff: float = 0.0
    """How far the uppermost of them stands out, cm."""
    hoops: int = 0
    """How many hoops hold it out."""


_CUTS: Mapping[str, _Cut] = {
    "train": _Cut(behind=52.0, reach=92.0),
    "long train": _Cut(behind=100.0, reach=92.0),
    "overskirt": _Cut(flare=9.0, reach=144.0),
    "tulle overskirt": _Cut(flare=14.0, reach=150.0, opacity=0.55),
    "tulle layers": _Cut(flare=13.0, opacity=0.7),
    "peplum": _Cut(flare=4.0, long=18.0),
    _OVER_LEGS: _Cut(flare=5.0, long=28.0),
    "back cape": _Cut(flare=6.0, reach=80.0, from_shoulders=True),
    "bustle": _Cut(flare=6.0, reach=88.0, long=52.0, puffs=3, puff=11.0),
    "hoops": _Cut(flare=20.0, hoops=4),
}
LAYERS = frozenset(_CUTS)
"""Names of `names.TRIMS` that hang over a skirt or lie behind it, of the same cloth."""


def layer(chalk: Chalk, name: str) -> list[Trim]:
    """Over the skirt from the waist to its hem; of a train behind alone, and on along the floor.

    A peplum ends over the hips, a cape hangs from the shoulders behind, and a skirt over shorts lets a
    little of them be seen.
    """
    found = _legs(chalk) if name == _OVER_LEGS else _skirt(chalk)
    if found is None:
        return []
    view, low = found
    cut, s = _CUTS[name], chalk.size
    height = chalk.waist - _BELOW_WAIST * s
    if name == _OVER_LEGS:
        bare = height - low < _LEGLESS * s
        long = height - low > _CALVES * s
        low = height - (cut.long if bare else _ABOVE_CALVES) * s if bare or long else low + _SHOWN * s
        return [Layer(name, view.panel.name, height, low, flare=cut.flare * s, reach=cut.reach)]
    if height - low < max(_SHORTEST, 0.0 if cut.puffs else cut.long) * s or (
        cut.behind > 0.0 and low > _ON_FLOOR * s
    ):
        return []
    if cut.from_shoulders:
        back = chalk.views.get("left_btorso")
        if back is None or back.high < chalk.shoulder - _BELOW_SHOULDER * s:
            return []
        view, height = back, chalk.shoulder - _BELOW_SHOULDER * s
    low = max(height - cut.long * s if cut.long else low, low if cut.puffs else _CLEAR_OF_FLOOR)
    if height - low < _LEAST * s:  # a child in a pattern that is cut for an adult
        return []
    return [
        Layer(
            name,
            view.panel.name,
            height,
            low,
            flare=cut.flare * s,
            reach=cut.reach,
            behind=cut.behind * s,
            opacity=cut.opacity,
            puffs=cut.puffs,
            puff=cut.puff * s,
            hoops=cut.hoops,
        )
    ]


def _skirt(chalk: Chalk) -> tuple[FrontView, float] | None:
    """The lowest panel of what hangs around the legs, behind where there are two; and its low end, cm."""
    names = [panel.name for panel in chalk.pattern.panels]
    if any(name.startswith("pant_") for name in names):
        return None
    hanging = [view for name, view in chalk.views.items() if any(part in name for part in _SKIRTS)]
    if not hanging:
        return None
    low = min(view.low for view in hanging)
    lowest = [view for view in hanging if view.low < low + 1.0]
    behind = [view for view in lowest if "back" in view.panel.name or "btorso" in view.panel.name]
    return (behind or lowest)[0], low


def _legs(chalk: Chalk) -> tuple[FrontView, float] | None:
    """A leg's back panel, and where legs end, cm; None of what has none, or ends below the calves."""
    views = {name: view for name, view in chalk.views.items() if name.startswith("pant_")}
    back = views.get("pant_b_l")
    return None if back is None else (back, min(view.low for view in views.values()))
