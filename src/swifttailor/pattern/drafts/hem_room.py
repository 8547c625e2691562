"""How much room tops have at their hems: woven ones need more over the seat than those of jersey."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class HemRoom:
    """What a loose torso leaves at its hem, cm around."""

    per_shaping: float
    """Width for each centimetre by which the sides are bent in."""
    wide: float
    """Room at the chest from which straight sides narrow to the hem: arms that are held out draw wide sides
    up and outward, and the hem would wing out like a bell."""
    most_taper: float
    """By how much at most."""
    narrows: bool = False
    """Whether bent sides, too, may end narrower than the chest."""


WOVEN = HemRoom(2.0, 18.0, 12.0)
JERSEY = HemRoom(1.0, 8.0, 15.0, narrows=True)
"""Of what is pulled on: all that the hem has over the hips stands off in front of the belly."""
SHIRTING, SHIRT_HIP_EASE = HemRoom(2.0, 5.0, 17.0), 3.5
"""Of shirts and blouses, and their least ease at the hem: their backs are held up by the blades, and all that
the hem has over the seat stands off behind it."""
JERSEY_HIP_EASE = 2.5
"""Least ease at the hem of such tops over the body there; with less, their backs ride up over the seat."""
