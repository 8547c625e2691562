"""A pattern of an answer, refitted to the body that wears it."""

from __future__ import annotations

from dataclasses import replace

from swifttailor.body import Body
from swifttailor.errors import SwiftTailorError
from swifttailor.pattern import Pattern
from swifttailor.tailor.answer import Answer
from swifttailor.tailor.room_for_necks import with_room_for_the_neck

_LARGE, _SHORT_CM = 1.3, 30.0
"""Times the bust of the default body; sleeves, shoulder tip to end."""
_WIDE_HIPS = 1.15
"""Times the hips of the default body."""
_LEGGED = frozenset(
    {"trousers", "pull-on-trousers", "jumpsuit", "wrap-jumpsuit", "strappy-jumpsuit", "strapless-jumpsuit"}
    | {"halter-jumpsuit"}
)
"""Drafts whose hems hardly grow where they are refitted: calves of large bodies catch narrow ones as they
fall, and wide ones are no longer wide."""


def refitted(answer: Answer, body: Body) -> Answer:
    """An answer with its pattern refitted to a body; as it is where it was drafted for that body.

    Sleeves that are cut in one with the body would grow as the trunk does and point past the arms, short
    ones of very large bodies would grow by a third and fold under on the shoulders, and the hems of narrow
    and wide legs would hardly grow: where nothing else was cut, such a pattern is drafted anew.

    Raises:
        SwiftTailorError: Its pattern cannot be sewn, or the body cannot be measured.
    """
    from swifttailor.refitting.refitted import fit

    if body.made_for is not None and answer.pattern.drafted_for == body.made_for:
        return answer
    pattern = _drafted_anew(answer, body)
    if pattern is None:
        roomy = with_room_for_the_neck(answer.pattern, body)
        pattern = _levelled(fit(roomy, body), answer.pattern)
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


def _drafted_anew(answer: Answer, body: Body) -> Pattern | None:
    """The draft of an answer, made for a body; None where it is to be refitted."""
    begun = answer.drafted
    if begun is None or answer.cuts:
        return None
    large = body.measurements.hips > _WIDE_HIPS * Body.default().measurements.hips
    if large and begun.name in _LEGGED and begun.narrows_or_is_wide:
        made = begun.as_long_on(body.measurements)
    elif begun.has_wings or _outgrows_short_sleeves(answer.pattern, body):
        made = begun.made_for(body.measurements)
    else:
        return None
    if [panel.name for panel in made.panels] != [panel.name for panel in answer.pattern.panels]:
        return None
    return replace(answer.pattern, panels=made.panels, stitches=made.stitches, drafted_for=body.made_for)
