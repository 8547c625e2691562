"""Necklines and armholes of what is refitted to children, whose necks and arms are wide beside their chests.

A garment grows and shrinks as the trunk does. A child of five has 0.6 of an adult's chest and 0.75 of the
width of the neck: a close neckline would stand up around it, and narrow shoulders would fold under.
"""

from __future__ import annotations

from swifttailor.body import Body
from swifttailor.describing.dimensions import QUANTITIES
from swifttailor.describing.measuring import measure_facts
from swifttailor.errors import SwiftTailorError
from swifttailor.pattern import Pattern
from swifttailor.recutting.set_dimension import set_dimension

_WIDER_BESIDE = 1.12
"""So much wider than that of the default body, beside the chest, is a neck that needs more room."""
_ROOM_CM, _DEPTH_CM, _DEEPER_CM = 1.0, 14.0, 2.0
"""Between neck and neckline on each side when it is worn, and depth before refitting; and by how much deeper
armholes are, cm."""


def with_room_for_the_neck(pattern: Pattern, body: Body) -> Pattern:
    """A pattern whose neckline goes around the neck of a body that it is to be refitted to.

    Args:
        pattern: Of the default body; what has sleeves, a collar or a hood stays as it is.
        body: Whom it will be made for.
    """
    own, usual = body.measurements, Body.default().measurements
    share = own.bust / usual.bust
    if own.neck_w < _WIDER_BESIDE * share * usual.neck_w:
        return pattern
    try:
        facts = measure_facts(pattern)
        worn = (facts.collar, facts.hood, facts.left_sleeve, facts.right_sleeve)
        if facts.front_neck is None or any(one is not None for one in worn):
            return pattern
        wide = (own.neck_w + 2 * _ROOM_CM) / share
        if 2 * facts.front_neck.width < wide:
            pattern = set_dimension(pattern, "neck width", round(wide, 1))[0]
        if facts.front_neck.depth < _DEPTH_CM:
            pattern = set_dimension(pattern, "neck depth", _DEPTH_CM)[0]
        armholes = QUANTITIES["armholes"].of(facts)
        if armholes is not None:
            pattern = set_dimension(pattern, "armholes", round(armholes + _DEEPER_CM, 1))[0]
    except SwiftTailorError:
        return pattern
    return pattern
