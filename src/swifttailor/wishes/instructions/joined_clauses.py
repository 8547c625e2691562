"""Clauses of an instruction that go together: "a bit shorter, like 4 cm", "the waist pinches, let it out"."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace

from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Change, Gain, Step, subject_of
from swifttailor.wishes.instructions.change_parts import changes_of, is_unsaid, subjects_of
from swifttailor.wishes.instructions.change_words import ChangeWord, PartWord, find_changes
from swifttailor.wishes.instructions.spoken_amounts import is_target, joined_amount, to_target
from swifttailor.wishes.instructions.spoken_clauses import SpokenClause
from swifttailor.wishes.text.mentions import Mention

JOINED = re.compile(r"(?<!\w)(?:and|but|und|aber|et|mais|y|pero|e|ed|en|maar|ma|però|mas)\s+$")
"""Before a clause that goes on about what the one before it spoke of: "shorter sleeves and a bit wider"."""
_OF_LENGTH = re.compile(
    r"(?<!\w)(?:long\w*|short\w*|length\w*|hem\w*|up|down|wider|narrower|looser|tighter|bigger|smaller|deeper|higher|lower)(?!\w)"
)

_GIRTHS = frozenset(
    {"waistband width", "chest", "thigh", "top width", "shoulders", "sleeve width", "sleeve end"}
)
"""What is let out and taken in."""


def is_amount_of(said: str, clause: SpokenClause, before: SpokenClause) -> bool:
    """Whether a clause says by how much what stands before it: "too snug at the bust, I need 5 cm more"."""
    waits = any(map(is_unsaid, before.changes))
    return waits and not _OF_LENGTH.search(said) and all(isinstance(c, Step) for c in clause.changes)


def is_so_again(grown: Sequence[ChangeWord], clause: SpokenClause, before: SpokenClause) -> bool:
    """Whether a clause says of "it" what the one before it says of a part: that it is too tight there."""
    was = {c.direction for c in before.changes if isinstance(c, Step) and is_unsaid(c)}
    now = {c.direction for c in clause.changes if isinstance(c, Step)}
    steps = len(was) == 1 and was == now and all(isinstance(c, Step) for c in clause.changes)
    girths = all(isinstance(c, Step) and c.quantity in _GIRTHS for c in before.changes)
    return steps and girths and all(word.what == "width" for word in grown)


def is_told_by_how_much(change: Change, told: Sequence[Change]) -> bool:
    """Whether the same is said with a number elsewhere: "always too short on me: 4 cm longer"."""
    return isinstance(change, Step) and any(
        isinstance(c, Step)
        and (c.quantity, c.direction) == (change.quantity, change.direction)
        and c.amount is not None
        for c in told
    )


def said_again(
    inside: Sequence[PartWord],
    grown: Sequence[ChangeWord],
    found: Sequence[SpokenClause],
    kind: str,
    own: float | None = None,
) -> tuple[Change, ...]:
    """What was asked of one part, asked of those that are named behind it: "tighter cuffs and waistband".

    Args:
        inside: The parts.
        grown: What was said of the one before them.
        found: What was asked of it.
        kind: Of the garment.
        own: By how many cm, where they have a number of their own.
    """
    before = [c.amount for c in found[-1].changes if isinstance(c, Step)] if found else []
    if not before:
        return ()
    amount = own or (before[0] if len(set(before)) == 1 else None)
    parts = dict.fromkeys(p.part for p in inside if p.part != "all")
    return tuple(
        [change for part in parts for w in grown for change in changes_of(part, w.what, w.sign, kind, amount)]
    )


def joined_together(
    text: str,
    found: Sequence[SpokenClause],
    mentions: Sequence[Mention],
    parts: Sequence[PartWord],
    kind: str,
) -> list[SpokenClause]:
    """Clauses that go together: "sleeves: minus 4 cm", "a bit shorter, like 4 cm", "bigger. No, bigger"."""
    joined: list[SpokenClause] = []
    for k, clause in enumerate(found):
        number = next((m for m in mentions if clause.start <= m.start < clause.end and m.is_length), None)
        length = None if number is None else number.value
        if not clause.changes and length is not None and joined:
            before = joined[-1]
            at = max((n for n, each in enumerate(joined) if each.changes), default=len(joined) - 1)
            if _has_slits(joined[at]) and not any(clause.start <= p.start < clause.end for p in parts):
                slits = Gain(Claim("slit_cm", round(length, 2)))
                joined[at] = replace(joined[at], changes=(*joined[at].changes, slits))
                joined.append(replace(clause, left_over=()))
                continue
            if any(map(is_unsaid, before.changes)):
                assert number is not None
                joined[-1] = with_amount(text, before, number)
                joined.append(replace(clause, left_over=()))
                continue
        named = " ".join(p.word for p in parts if clause.start <= p.start < clause.end)
        if not clause.changes and k + 1 < len(found) and " ".join(clause.left_over) == named:
            clause = _with_next(text, clause, found[k + 1], parts, kind)
        whole = text[clause.start : clause.end].split()
        repeated = [c for c in clause.changes if isinstance(c, Step) and c.quantity in ("chest", "length")]
        again = len(whole) == 1 and re.search(rf"(?<!\w){re.escape(whole[0])}(?!\w)", text[: clause.start])
        if joined and again and not named and repeated and len(clause.changes) == 1:
            earlier = [c for one in joined for c in one.changes if isinstance(c, Step)]
            if any(
                c.direction == repeated[0].direction and c.quantity != repeated[0].quantity for c in earlier
            ):
                clause = replace(clause, changes=())
        joined.append(clause)
    return joined


def with_amount(text: str, clause: SpokenClause, number: Mention) -> SpokenClause:
    """A clause with the number that stands behind it: by how much, or where its measures are to end."""
    if is_target(text, number):
        return replace(clause, changes=to_target(clause.changes, number))
    return joined_amount(clause, number.value)


def _has_slits(clause: SpokenClause) -> bool:
    return any(
        isinstance(c, Gain) and c.claim.name == "slit" and c.claim.value != "none" for c in clause.changes
    )


def _with_next(
    text: str, clause: SpokenClause, behind: SpokenClause, parts: Sequence[PartWord], kind: str
) -> SpokenClause:
    """Parts that share what the clause behind them asks for: "the sleeves and the hem shorter"."""
    own = [p for p in parts if clause.start <= p.start < clause.end and p.part != "all"]
    shared = JOINED.search(text, 0, behind.start) and any(
        behind.start <= p.start < behind.end and p.part not in ("all", *[q.part for q in own]) for p in parts
    )
    steps = [c for c in behind.changes if isinstance(c, Step)]
    if not (shared and steps and own):
        told = {subject_of(change) for change in behind.changes}
        answered = not own or any(told & subjects_of(part.part) for part in own)
        return replace(clause, left_over=()) if answered else clause
    grown = [c for c in find_changes(text) if behind.start <= c.start < behind.end]
    made = said_again(own, grown, [behind], kind)
    return replace(clause, changes=made, left_over=() if made else clause.left_over)
