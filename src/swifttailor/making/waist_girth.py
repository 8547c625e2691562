"""How long what goes around the waist must be."""

from __future__ import annotations

from swifttailor.body.wearer import body_of
from swifttailor.errors import InputError
from swifttailor.making.finished_measures import finished_measures
from swifttailor.pattern import Pattern

_CLOTH_UNDER_CM = 12.0
"""At most so much more than the body has the cloth that a belt draws in."""
_USUAL_CM = 85.0


def waist_girth(pattern: Pattern) -> float:
    """Around the waist of the garment, or of its wearer in it where the garment is wider, cm."""
    try:
        body = body_of(pattern.drafted_for).measurements.as_dict()
    except InputError:  # a wearer whom nobody resembles: `wearer_findings` says so
        return _USUAL_CM
    drawn_in = float(body["waist"]) + _CLOTH_UNDER_CM
    measures = finished_measures(pattern)
    own = next((measures[name] for name in ("waist seam", "waist", "upper edge") if name in measures), None)
    return drawn_in if own is None else min(own, drawn_in)
