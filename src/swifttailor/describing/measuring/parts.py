"""Which part of the garment each panel is: by its name where that says it, else by label and place."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Literal

import numpy as np

from swifttailor.pattern import Panel, Pattern, body_region
from swifttailor.pattern.drafts.figure import Figure
from swifttailor.pattern.panel_parts import Part, named_part

Side = Literal["left", "right", "middle"]
Face = Literal["front", "back"]


ARM_PARTS = frozenset({Part.SLEEVE, Part.CUFF})
LEG_PARTS = frozenset({Part.TROUSER, Part.LEG_CUFF})
SKIRT_PARTS = frozenset({Part.SKIRT, Part.GODET})
LOWER_PARTS = LEG_PARTS | SKIRT_PARTS
UPPER_PARTS = ARM_PARTS | {Part.TORSO, Part.HOOD, Part.COLLAR}

_LEFT = re.compile(r"(^|_)(left|l)(_|$)", re.IGNORECASE)
_RIGHT = re.compile(r"(^|_)(right|r)(_|$)", re.IGNORECASE)
_MIDDLE_CM = 2.0
WELL_ABOVE_WAIST_CM = 5.0
"""What begins higher than this above the waist is an upper garment."""


@dataclass(frozen=True)
class PlacedPart:
    """A panel's part and on which side of the body it lies."""

    panel: Panel
    part: Part
    side: Side
    """The wearer's."""
    face: Face


@dataclass(frozen=True)
class Openings:
    """What the borders of a garment say about panels whose names say nothing."""

    two_legs: bool
    """The lower end has two openings side by side."""
    upper: bool
    """There are armholes or sleeves, or the garment begins well above the waist."""
    around: frozenset[str]
    """Panels that border an armhole or the upper opening."""


def find_parts(pattern: Pattern, figure: Figure, openings: Openings) -> dict[str, PlacedPart]:
    """Finds the part of every panel of a pattern placed around a body."""
    return {
        p.name: PlacedPart(p, _part(p, figure, openings), _side(p), "back" if p.normal()[2] < 0 else "front")
        for p in pattern.panels
    }


def _part(panel: Panel, figure: Figure, openings: Openings) -> Part:
    named = named_part(panel.name)
    if named is not None:
        return named
    region = body_region(panel.name, panel.label)
    if region == "arm":
        return Part.SLEEVE
    height = panel.to_world(panel.outline(0.5))[:, 1]
    high = height.max() > figure.waist_y + WELL_ABOVE_WAIST_CM
    covers_chest = panel.name in openings.around or height.mean() > figure.waist_y
    if region == "body" and openings.upper and high and covers_chest:
        return Part.TORSO
    return Part.TROUSER if openings.two_legs else Part.SKIRT


def _side(panel: Panel) -> Side:
    """From the name where it says, else from where the middle of the panel is placed."""
    left, right = bool(_LEFT.search(panel.name)), bool(_RIGHT.search(panel.name))
    if left != right:
        return "left" if left else "right"
    x = float(np.mean(panel.to_world(panel.outline(0.5))[:, 0]))
    if abs(x) < _MIDDLE_CM:
        return "middle"
    return "left" if x > 0 else "right"
