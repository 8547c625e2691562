"""A pattern of an answer, refitted to the body that wears it."""

from __future__ import annotations

from dataclasses import replace

from swifttailor.body import Body
from swifttailor.errors import SwiftTailorError
from swifttailor.pattern import Pattern
from swifttailor.tailor.answer import Answer
from swifttailor.tailor.large_drafts import drafted_for_large
from swifttailor.tailor.large_legs import legs_for_large
from swifttailor.tailor.redrafted import redrafted
from swifttailor.tailor.room_for_necks import with_room_for_the_neck

_LARGE, _SHORT_CM = 1.3, 30.0
"""Times the bust of the default body; sleeves, shoulder tip to end."""
_COARSE_CM = 4.0
"""Edges of the mesh that tells whether there is one, cm."""


def refitted(answer: Answer, body: Body) -> Answer:
    """An answer with its pattern refitted to a body; as it is where it was drafted for that body.

    Sleeves that are cut in one with the body would grow as the trunk does and point past the arms, and short
    ones of very large bodies would grow by a third and fold under on the shoulders: where nothing else was
    cut, such a pattern is drafted anew. So are tops and legs for large bodies (`large_drafts`, `large_legs`),
    and what cannot be meshed when it is refitted, since a dart closes; lengths that are asked for are cut
    again afterwards (`lengths_kept`).

    Raises:
        SwiftTailorError: Its pattern cannot be sewn, or the body cannot be measured.
    """
    from swifttailor.refitting.refitted import fit

    if body.made_for is not None and answer.pattern.drafted_for == body.made_for:
        return answer
    pattern = drafted_for_large(answer, body) or legs_for_large(answer, body)
    if pattern is None and _is_better_anew(answer, body):
        pattern = _drafted_anew(answer, body)
    if pattern is None:
        roomy = with_room_for_the_neck(answer.pattern, body)
        grown = fit(roomy, body)
        # Small crossings are repaired when it is sewn, and fall better than what is drafted anew.
        anew = None if _can_be_meshed(grown) else _drafted_anew(answer, body)
        pattern = anew or _levelled(grown, answer.pattern)
    return replace(answer, pattern=pattern, prepared=None, fitted_to=body.name)


def _levelled(pattern: Pattern, before: Pattern) -> Pattern:
    """A refitted pattern with a level hem, where it had one: circles grow more in width than in length."""
    from swifttailor.recutting.level_hems import has_level_hem, level_hem

    try:
        return level_hem(pattern, below_waist=True)[0] if has_level_hem(before) else pattern
    except SwiftTailorError:
        return pattern


def _outgrows_short_sleeves(pattern: Pattern, body: Body) -> bool:
    """Whether a pattern has short sleeves set into armholes, and the body is very much larger than it."""
    from swifttailor.describing.measuring import measure_facts

    if body.measurements.bust < _LARGE * Body.default().measurements.bust:
        return False
    facts = measure_facts(pattern)
    sleeves = [one for one in (facts.left_sleeve, facts.right_sleeve) if one is not None]
    return len(sleeves) == 2 and all(one.length <= _SHORT_CM for one in sleeves)


def _can_be_meshed(pattern: Pattern) -> bool:
    """Whether it can: not where both legs of a dart lie on each other."""
    from swifttailor.panel_mesh import mesh_pattern

    try:
        mesh_pattern(pattern, _COARSE_CM)
    except SwiftTailorError:
        return False
    return True


def _is_better_anew(answer: Answer, body: Body) -> bool:
    """Whether what was drafted, and cut no further, grows otherwise than it is to."""
    begun = answer.drafted
    if begun is None or answer.cuts:
        return False
    return begun.has_wings or _outgrows_short_sleeves(answer.pattern, body)


def _drafted_anew(answer: Answer, body: Body) -> Pattern | None:
    """The draft of an answer, made for a body; None where there is none with the same panels."""
    begun = answer.drafted
    return None if begun is None else redrafted(answer.pattern, begun.made_for(body.measurements), body)
