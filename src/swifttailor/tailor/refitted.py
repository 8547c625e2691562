"""A pattern of an answer, refitted to the body that wears it."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from swifttailor.body import Body
from swifttailor.errors import SwiftTailorError
from swifttailor.pattern import Pattern
from swifttailor.tailor.answer import Answer
from swifttailor.tailor.room_for_necks import with_room_for_the_neck

if TYPE_CHECKING:
    from swifttailor.tailor.drafted import DraftCandidate

_LARGE, _SHORT_CM = 1.3, 30.0
"""Times the bust of the default body; sleeves, shoulder tip to end."""
_LARGER = 1.18
"""The same of bodies for which tops that hang from the shoulders are drafted: refitted, their necks stand off
and long sleeves reach over the hands and crumple."""
_OPTIONS_CUT = {"hem": "length", "bodice": "length", "sleeves": "sleeve_length"}
_CUT = re.compile(r"(?P<what>hem|bodice|sleeves) (?P<by>[\d.]+) cm (?P<how>longer|shorter)")
"""What may have been cut of these, and the options of their drafts that do the same."""
_TOPS = frozenset({"t-shirt", "shirt", "polo-shirt", "sweatshirt", "hoodie", "cardigan", "turtleneck"})


def refitted(answer: Answer, body: Body) -> Answer:
    """An answer with its pattern refitted to a body; as it is where it was drafted for that body.

    Sleeves that are cut in one with the body would grow as the trunk does and point past the arms, short
    ones of very large bodies would grow by a third and fold under on the shoulders, and necks of tops would
    stand off: where nothing else was cut, such a pattern is drafted anew.

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


def _is_told_in_figures(answer: Answer) -> bool:
    """Whether a measure is asked for in cm, which a pattern keeps as it was cut."""
    from swifttailor.describing.differences import Gain

    wishes = () if answer.wanted is None else answer.wanted.wishes
    return any(isinstance(w.change, Gain) and w.change.claim.name.endswith("_cm") for w in wishes)


def _as_cut(begun: DraftCandidate, cuts: Sequence[str]) -> DraftCandidate | None:
    """A draft with the length that its pattern was cut to; None where something else was cut."""
    from swifttailor.pattern.drafts import find_draft

    usual = {field.name: field.default for field in find_draft(begun.name).options}
    options = {**dict(begun.draft.options)}
    for cut in cuts:
        found = _CUT.fullmatch(cut)
        if found is None:
            return None
        name = _OPTIONS_CUT[found["what"]]
        by = float(found["by"]) * (1.0 if found["how"] == "longer" else -1.0)
        options[name] = float(options.get(name, usual[name])) + by
    return replace(begun, draft=replace(begun.draft, options=tuple(options.items())))


def _drafted_anew(answer: Answer, body: Body) -> Pattern | None:
    """The draft of an answer, made for a body; None where it is to be refitted."""
    begun = answer.drafted
    if begun is None:
        return None
    larger = body.measurements.bust >= _LARGER * Body.default().measurements.bust
    top = larger and begun.name in _TOPS
    if top and answer.cuts and not _is_told_in_figures(answer):
        begun = _as_cut(begun, answer.cuts)
    elif answer.cuts or not (top or begun.has_wings or _outgrows_short_sleeves(answer.pattern, body)):
        return None
    if begun is None:
        return None
    made = begun.made_for(body.measurements)
    if [panel.name for panel in made.panels] != [panel.name for panel in answer.pattern.panels]:
        return None
    return replace(answer.pattern, panels=made.panels, stitches=made.stitches, drafted_for=body.made_for)
