"""A pattern of an answer, refitted to the body that wears it."""

from __future__ import annotations

from dataclasses import replace

from swifttailor.body import Body
from swifttailor.tailor.answer import Answer


def refitted(answer: Answer, body: Body) -> Answer:
    """An answer with its pattern refitted to a body; as it is where it was drafted for that body.

    Raises:
        SwiftTailorError: Its pattern cannot be sewn, or the body cannot be measured.
    """
    from swifttailor.refitting.refitted import fit

    if body.made_for is not None and answer.pattern.drafted_for == body.made_for:
        return answer
    return replace(answer, pattern=fit(answer.pattern, body), prepared=None, fitted_to=body.name)
