"""Girths that are to end at a number, as changes by the difference: "strap width down to half an inch"."""

from __future__ import annotations

import re

from swifttailor.describing.differences import Step
from swifttailor.describing.dimensions import QUANTITIES
from swifttailor.describing.facts import GarmentFacts
from swifttailor.wishes.instructions.change_parts import changes_of
from swifttailor.wishes.instructions.change_words import find_parts
from swifttailor.wishes.text.mentions import find_mentions

_TO = re.compile(
    r"(?<!\w)(?P<part>[^\W\d]+(?: [^\W\d]+)?)(?: (?:width|girth|wide|circumference))?"
    r"(?: (?:down|up|in|out|narrowed|widened|cut|taken|reduced|increased|should be|to be))*"
    r" (?:to|at|of|=) (?:about |only |just )?$"
)
_STRAPS = re.compile(
    r"(?<!\w)(?P<part>shoulder straps?|straps?)"
    r"(?:,? (?:about|of|at|only|just|width|wide|should be|to be|be|around|maybe|like|please|are|thin|narrow"
    r"|broad))*,? $"
)
_ALONE = re.compile(
    r"(?:^|[,.;:]\s*|(?<!\w)and )(?:the |my )?(?P<part>[^\W\d]+(?: [^\W\d]+)?)"
    r"(?: (?:width|girth|circumference|depth|round|around))?\s*[:=]?\s*$"
)
"""A part and a number are all that is said: "thigh 60 cm"."""
_ENDS = re.compile(r"\s*(?:$|[,.;!]|please(?!\w)|and(?!\w))")
_LEAST, _MOST = 0.4, 2.5
"""Shares of what it measures that a part may come to so."""
_BY = re.compile(r" ?(?:wider|narrower|thinner|longer|shorter|more|less|off|in|out|up|down)(?!\w)")
_THINNER = re.compile(r"(?<!\w)(?:thinner|narrower|slimmer|skinnier|smaller)(?!\w)")
_ACROSS = re.compile(r" (?:wide|across|broad|round|around)(?!\w)")
_NARROW_CM = 3.0
"""Straps of less are narrow ones, however narrow they can be cut."""


def with_targets(text: str, kind: str, facts: GarmentFacts) -> str:
    """An instruction in which girths that are to end at a number are to change by the difference.

    Args:
        text: In lower case: "strap width down to half an inch".
        kind: Of the garment.
        facts: Of the garment, which says how wide it is now.
    """
    for mention in reversed([m for m in find_mentions(text) if m.is_length]):
        said = _TO.search(text[: mention.start])
        if said is None and not _BY.match(text, mention.end):
            said = _STRAPS.search(text[: mention.start])
        alone = said is None and _ENDS.match(text, mention.end)
        if alone:
            said = _ALONE.search(text[: mention.start])
        parts = [p for p in find_parts(said[0]) if p.part != "all"] if said else []
        if said is None or not parts:
            continue
        part = parts[-1]
        steps = [c for c in changes_of(part.part, "width", 1, kind, 1.0) if isinstance(c, Step)]
        if not steps or QUANTITIES[steps[0].quantity].stated is not None:
            continue
        now = QUANTITIES[steps[0].quantity].of(facts)
        if now is None or abs(mention.value - now) < 0.1:
            continue
        if alone and not _LEAST * now <= mention.value <= _MOST * now:
            continue
        way = "wider" if mention.value > now else "narrower"
        plain = f"{part.word} {way} by {abs(mention.value - now):.1f} cm"
        if part.part == "straps" and mention.value < min(_NARROW_CM, now):
            plain = "narrow straps"
        if plain == "narrow straps":
            text = (
                _THINNER.sub(lambda found: " " * len(found[0]), text[: mention.start]) + text[mention.start :]
            )
        behind = _ACROSS.match(text, mention.end)
        text = text[: said.start() + part.start] + plain + text[behind.end() if behind else mention.end :]
    return text
