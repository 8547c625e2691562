"""Systems whose panels have numbers for names: what they cover, and where, is told by where they stand.

Of other patterns, names and seams tell where they are worn (`pattern.check.worn_place`). Numbers leave too
little of that, but a network that has learnt on one body places panels around that body.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from swifttailor.pattern import Pattern
from swifttailor.pattern.check import BodyLevels, Change
from swifttailor.pattern.names import BodyRegion, said_region
from swifttailor.pattern.panel import Panel

_BODY = BodyLevels()
_BESIDE_CM, _CLEAR_CM = 18.0, 8.0
"""Middle and inner end of a sleeve are further from the middle of the body; half a bodice reaches it."""
_ABOVE_WAIST_CM = 8.0
"""What reaches further up than this covers the trunk; waistbands and skirts do not."""


@dataclass(frozen=True)
class KnownPlace:
    """A body that patterns are placed around."""

    raised: float
    """How far its patterns have to be raised to stand where they are worn here, cm."""
    arms_level: bool
    """Whether it holds its arms out to the sides, at the height of the shoulders."""

    def settle(self, pattern: Pattern) -> tuple[Pattern, tuple[Change, ...]]:
        """The pattern on the body here, its panels labelled as GarmentCode does, and what was changed."""
        changes: list[Change] = []
        if self.raised:
            text = f"moved the whole pattern {self.raised:.0f} cm up, to where it is worn"
            changes.append(Change("misplaced-panel", text))
        panels = []
        for panel in pattern.panels:
            shift = np.array([0.0, self.raised, 0.0])
            panel = _labelled(replace(panel, placement=panel.placement.moved(np.eye(3), shift)))
            if self.arms_level and panel.label == "arm":
                panel = _arm_down(panel)
                text = f"turned the panel by {_BODY.arm_angle:.0f} degrees, down to the arm"
                changes.append(Change("high-sleeve", text, panel.name))
            panels.append(panel)
        return replace(pattern, panels=tuple(panels)), tuple(changes)


def _labelled(panel: Panel) -> Panel:
    if said_region(panel.name, panel.label) is not None:
        return panel
    space = panel.to_world(panel.outline(1.0))
    beside, height = np.abs(space[:, 0]), float(space[:, 1].mean())
    region: BodyRegion = "body"
    if beside.mean() > _BESIDE_CM and beside.min() > _CLEAR_CM and height > _BODY.hips:
        region = "arm"
    elif float(space[:, 1].max()) < _BODY.waist + _ABOVE_WAIST_CM:
        region = "leg"
    return replace(panel, label=region)


def _arm_down(panel: Panel) -> Panel:
    side = 1.0 if panel.to_world(panel.vertices)[:, 0].mean() > 0 else -1.0
    angle = np.deg2rad(-side * _BODY.arm_angle)
    c, s = np.cos(angle), np.sin(angle)
    turn = np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
    pivot = np.array([side * _BODY.shoulder_x, _BODY.shoulder, 0.0])
    return replace(panel, placement=panel.placement.moved(turn, pivot - turn @ pivot))
