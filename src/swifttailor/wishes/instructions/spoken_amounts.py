"""Amounts of changes: by how much, to how much, and one more or one fewer of what is counted."""

from __future__ import annotations

import re
from collections.abc import Sequence

from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Change, Gain, Step
from swifttailor.describing.dimensions import QUANTITIES
from swifttailor.wishes.instructions.change_parts import is_unsaid
from swifttailor.wishes.instructions.spoken_clauses import SpokenClause
from swifttailor.wishes.text.mentions import Mention

_TO = re.compile(r"(?<!\w)(?:to|auf|à|a|at|becomes?)\s*(?:about|around|roughly|exactly)?\s*$")
_MADE_OF = re.compile(
    r"(?<!\w)(?:make (?:it|them|that)|(?:should|must|to) be)"
    r"(?: (?:about|around|roughly|exactly|only|like|just))*\s*$"
)
_ENOUGH = re.compile(
    r",? (?:(?:would|will|should|might|is|be|do)(?!\w) ?)*"
    r"(?:plenty|enough|fine|ideal|perfect|lovely|better|nice|right)(?!\w)"
)
"""Behind where a measure is to end: "too wide; 3 cm would be plenty"."""
_DIFFERENT = re.compile(r"\s*(?:\w+er|more|less|up|down|in|out|off|fewer)(?!\w)")
"""Behind a number: it is by how much, not to how much."""
_SMALLEST_CM = 10.0
"""A bare number from here on is a measure in cm."""
_COUNTED = {
    "tiers": "tiers?|rows?|layers?|stufen?|étages?|volantes?",
    "godets": "godets?",
    "gores": "gores?|panels?|bahn|bahnen",
}
_N = r"(?P<n>an?|one|two|three|four|five|six|\d|eine?|zwei|drei|une?|deux|trois|una?|dos|tres)"
_MORE, _FEWER = r"(?:more|extra|additional|mehr|de plus|más)", r"(?:fewer|less|weniger|de moins|menos)"
_LOST = r"(?:lose|remove|drop|ditch|take (?:off|out|away)|cut off|without|minus)"
_COUNT_CHANGES = tuple(
    (sign, re.compile(rf"(?<!\w){words}(?!\w)"))
    for sign, words in (
        (1, rf"(?:another|add)(?: {_N})?(?: {_MORE})? (?P<what>\w+)"),
        (1, rf"with(?: {_N})? {_MORE} (?P<what>\w+)"),
        (1, r"(?:extra|additional) (?P<what>\w+)"),
        (1, rf"{_N} {_MORE} (?P<what>\w+)"),
        (1, rf"{_N} (?P<what>\w+) {_MORE}"),
        (-1, rf"{_N} {_FEWER} (?P<what>\w+)"),
        (-1, rf"{_N} (?P<what>\w+) {_FEWER}"),
        (-1, rf"{_LOST} (?:the |its )?(?:(?:bottom|lowest|last|top) )?(?:{_N} )?(?P<what>\w+)"),
    )
)
SIGNED = re.compile(r"(?:[+\-\u2212]|(?<!\w)(?:plus|minus))\s*$")
"""Before a number without a unit, which is in cm then: "sleeve +4"."""
_MORE_BEFORE = re.compile(r"(?:(?<!\w)(?:plus|extra|add|adding|another|gain)(?: about)?\s*|\+\s*)$")
_MORE_BEHIND = re.compile(r"\s*(?:more|extra|plus)(?!\w)(?!\s+\w*(?:er|long|wide|deep)(?!\w))")
_CHANGE_BEFORE = re.compile(
    r"(?<!\w)(?:down|up|in|out|by|longer|shorter|wider|narrower|deeper|higher|lower|raise|drop|lengthen|shorten)\s$"
)
_CHANGE_BEHIND = re.compile(
    r" (?:down|up|in|out|longer|shorter|wider|narrower|deeper|higher|lower)"
    r"\s*(?=$|[.,;!?)]|please(?!\w)|and(?!\w))"
)
_CHANGED_BEFORE = re.compile(
    r"(?<!\w)(?:raise|lower|drop|lift|lengthen|shorten|deepen|widen|narrow|let out|let down|take in|take up)"
    r"(?: (?:the|my|her|his|its|both))?(?! size)(?: [^\W\d]+){1,2} $"
)
"""Before a number at the end of a clause, which is in cm: "raise the hem 8"."""
_NOTHING_BEHIND = re.compile(r"\s*(?:$|[.,;!?)]|please|each|and|then)")
_A_BIT = re.compile(
    r"(?<!\w)(?:a (?:(?:little|tiny|wee) )?(?:bit|little|touch|tad|smidge|smidgen|fraction|hint)"
    r"|slightly|somewhat"
    r"|(?:ein )?(?:bisschen|wenig)|etwas|un (?:petit )?peu|un poco|un po['’]?|een beetje|um pouco)(?!\w)"
    r"(?! (?:too|zu|trop|más|more than)(?!\w))"
)
"""Said of how much: not of what is a bit too much already."""
_CAREFUL_CM = 6.0
"""A step of no stated size where something beyond it is refused: "shorter, but not mini"."""
_NUMBERS = {
    word: float(number)
    for number, words in (
        (2, "two zwei deux dos"),
        (3, "three drei trois tres"),
        (4, "four"),
        (5, "five"),
        (6, "six"),
    )
    for word in words.split()
}
_SHARES = (
    (0.5, r"half as|by half|(?:in|by) half|halve|half the|halb so|moitié"),
    (1.0, r"twice as|twice the|double|doppelt so|deux fois plus"),
    (1 / 3, r"(?:by )?(?:a|one) third"),
    (0.25, r"(?:by )?(?:a|one) quarter"),
)
_PERCENT = re.compile(r"(\d{1,3}) ?(?:%|per ?cent|prozent)")


def is_more_by(text: str, numbers: Sequence[Mention]) -> bool:
    """Whether a length is to be added: "add 6 cm", "4 cm more"."""
    return any(
        (m.is_length or SIGNED.search(text[: m.start]))
        and (_MORE_BEFORE.search(text[: m.start]) or _MORE_BEHIND.match(text, m.end))
        for m in numbers
    )


def is_bare_cm(text: str, mention: Mention) -> bool:
    """Whether a number without a unit is by how many cm something changes: "back neck down 8"."""
    before, behind = text[: mention.start], text[mention.end :]
    if mention.is_length:
        return False
    return bool(
        ((_CHANGE_BEFORE.search(before) or _CHANGED_BEFORE.search(before)) and _NOTHING_BEHIND.match(behind))
        or _CHANGE_BEHIND.match(behind)
    )


def by_little(change: Change) -> Change:
    """A change of no said amount, kept small: "longer, but not too long"."""
    if isinstance(change, Step) and change.amount is None:
        return Step(change.quantity, change.direction, _CAREFUL_CM)
    return change


def by_a_bit(said: str, change: Change) -> Change:
    """A step of cm that is to be slight, by a little more than what is seen: "shorten it a bit".

    Args:
        said: The clause, in lower case.
        change: That it asks for.
    """
    if not isinstance(change, Step) or change.amount is not None or _A_BIT.search(said) is None:
        return change
    quantity = QUANTITIES[change.quantity]
    return Step(change.quantity, change.direction, round(1.5 * quantity.least)) if quantity.in_cm else change


def is_target(text: str, mention: Mention) -> bool:
    """Whether a number is where a measure is to end: "to 52 cm", "too high, make it 4 cm"."""
    before = text[: mention.start]
    if _TO.search(before) is not None:
        return True
    if mention.is_length and _ENOUGH.match(text, mention.end) is not None:
        return True
    made = mention.is_length and _MADE_OF.search(before) is not None
    return made and _DIFFERENT.match(text, mention.end) is None


def to_target(changes: Sequence[Change], mention: Mention) -> tuple[Change, ...]:
    """Steps that lead to a measure that is stated, as that measure.

    Args:
        changes: Of a clause whose number says where they lead.
        mention: The number.
    """
    found: list[Change] = []
    for change in changes:
        stated = QUANTITIES[change.quantity].stated if isinstance(change, Step) else None
        if stated is None or (not mention.is_length and mention.value < _SMALLEST_CM):
            found.append(change)
        else:
            found.append(Gain(Claim(stated.claim, round(mention.value, 2))))
    return tuple(found)


def more_of_them(said: str) -> tuple[Change, ...]:
    """Pieces that are to be added or taken off: "another tier", "two gores fewer".

    Args:
        said: A clause in lower case.
    """
    for sign, pattern in _COUNT_CHANGES:
        for found in pattern.finditer(said):
            for quantity, words in _COUNTED.items():
                if not re.fullmatch(words, found["what"]):
                    continue
                number = found.groupdict().get("n") or ""
                count = _NUMBERS.get(number, float(number) if number.isdigit() else 1.0)
                if number or not found["what"].endswith("s"):
                    return (Step(quantity, sign, count),)
    return ()


def counts(word: str) -> bool:
    """Whether a word is of what is counted: tiers, godets, gores."""
    return any(re.fullmatch(words, word) for words in _COUNTED.values())


def share_of(said: str) -> float | None:
    """By which part of itself a measure is to change: "half as high", "20 % wider"; None where none is said.

    Args:
        said: A clause in lower case.
    """
    percent = _PERCENT.search(said)
    if percent is not None:
        return float(percent[1]) / 100
    return next(
        (share for share, words in _SHARES if re.search(rf"(?<!\w)(?:{words})(?!\w)", said)),
        None,
    )


def joined_amount(clause: SpokenClause, length: float) -> SpokenClause:
    """A clause whose steps are by a length that stands behind it: "a bit shorter, like 4 cm"."""
    steps = [
        Step(c.quantity, c.direction, length) if isinstance(c, Step) and is_unsaid(c) else c
        for c in clause.changes
    ]
    return SpokenClause(clause.start, clause.end, tuple(steps), clause.left_over)
