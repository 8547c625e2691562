"""What a made pattern measures against what its text says, whatever was made of the text on the way.

Readers may drop or mishear a word, and cutting may move what nobody spoke of. The finished pattern is
measured, so both can be told without knowing where it went wrong.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Change, Gain, Step, subject_of
from swifttailor.describing.facts import GarmentFacts
from swifttailor.recutting.to_the_figure import figures_missed
from swifttailor.recutting.unasked import KEPT_CM, spoken_parts, unasked
from swifttailor.wishes.instructions.change_words import find_parts
from swifttailor.wishes.text.mentions import find_mentions
from swifttailor.wording.lexicon import WordMark, exclude

if TYPE_CHECKING:
    from swifttailor.tailor.answer import Answer

_WAIST = "waist_seam"
"""The claim that is kept where a waist is told to stay."""
_OF_THE_CUT = frozenset({"fits", "lengths", "styles", "parts"})
"""Categories of words that speak of the cut; occasions and names of garments leave it open."""
_FOR_HIPS = frozenset({"skirt hem", "thigh"})
"""What is cut for hips that are to be wider or closer."""
_APART = frozenset({"kind", "sides"})
"""Claims that are about all of a garment, and told elsewhere."""


def said_and_not_so(answer: Answer) -> tuple[tuple[str, Change], ...]:
    """Words of a description that say something of the cut, by definition or of a detail, and are not so.

    Of an instruction, the figures that are missed by more than a centimetre.

    Words that contradict each other, what is told to be missing anyhow, and what is so in another way that
    was read surely ("super short": mini) are left out.
    """
    from swifttailor.tailor.reading import facts_of

    wanted = answer.wanted
    if wanted is None or wanted.heard.words is None:
        return ()
    if wanted.order.edit is not None:
        return _figures_not_so(answer)
    words = wanted.heard.words
    facts = facts_of(answer.pattern)
    if facts is None:
        return ()
    told = {*answer.verdict.open, *[wish.change for wish in answer.not_done], *wanted.shown}
    opposed = [mark for pair in words.contradictions for mark in (pair.first, pair.second)]
    gains = [wish.change for wish in wanted.wishes if isinstance(wish.change, Gain)]
    so = {gain.claim.name for gain in gains if gain.holds(facts, facts)}
    numbers = [mention.end for mention in find_mentions(wanted.heard.as_read)]
    slits = () if facts.skirt is None else facts.skirt.slits
    over_leg = [Claim("slit", slit.over) for slit in slits if slit.over]  # where it is seen (`slits_seen`)
    said: dict[tuple[int, str], list[Gain]] = {}
    for each in words.implications:
        firm = each.said or each.certainty == "certain"
        if (
            not firm
            or each.claim.name in _APART
            or each.claim in over_leg
            or each.mark in opposed
            or (each.certainty != "certain" and any(exclude(each.claim, gain.claim) for gain in gains))
            or not _is_of_the_cut(each.mark)
        ):
            continue
        if each.claim.name not in so and not any(0 <= each.mark.start - end <= 2 for end in numbers):
            said.setdefault((each.mark.start, each.mark.word), []).append(Gain(each.claim))
    found = []
    for (_, word), gains in said.items():
        if word in wanted.heard.unread or told.intersection(gains):
            continue
        if not any(gain.holds(facts, facts) for gain in gains):
            found.append((word, gains[0]))
    return tuple(found)


def _figures_not_so(answer: Answer) -> tuple[tuple[str, Change], ...]:
    """Numbers of an instruction that a measure is near and not at."""
    wanted = answer.wanted
    assert wanted is not None
    before, after = _before_and_after(answer)
    if before is None or after is None:
        return ()
    waiting = [wish.change for wish in wanted.wishes if wish.change not in answer.verdict.open]
    found: list[tuple[str, Change]] = []
    for change in figures_missed(waiting, before, after):
        figure = change.claim.value if isinstance(change, Gain) else change.amount
        said = next(
            (m for m in find_mentions(wanted.heard.text) if abs(m.value - float(figure or 0)) < 0.1), None
        )
        if said is not None:
            found.append((wanted.heard.text[said.start : said.end], change))
    return (*found, *_hips_not_so(wanted.heard.text, waiting, before, after))


def _hips_not_so(
    text: str, changes: Sequence[Change], before: GarmentFacts, after: GarmentFacts
) -> tuple[tuple[str, Change], ...]:
    """Hips that are spoken of and stay as they are, where what is cut for them is another measure."""
    named = next((part for part in find_parts(text.lower()) if part.part == "hips"), None)
    steps = [c for c in changes if isinstance(c, Step) and c.quantity in _FOR_HIPS]
    was, now = ((f.skirt or f.trousers) for f in (before, after))
    if named is None or not steps or was is None or now is None:
        return ()
    moved = (now.hips - was.hips) * steps[0].direction
    return () if moved >= KEPT_CM else ((named.word, steps[0]),)


def _is_of_the_cut(mark: WordMark) -> bool:
    return bool(mark.entries) and mark.entries[0].category in _OF_THE_CUT


def changed_unasked(answer: Answer) -> tuple[Change, ...]:
    """What an edit changed in parts that no wish speaks of."""
    wanted = answer.wanted
    if wanted is None or wanted.order.edit is None or answer.is_given:
        return ()
    before, after = _before_and_after(answer)
    if before is None or after is None:
        return ()
    spoken = [wish.change for wish in (*wanted.wishes, *wanted.likely)]
    return unasked(spoken_parts(spoken), before, after, wanted.heard.kept)


def moved_waist(answer: Answer) -> float | None:
    """By how many cm a waist that is to stay has become wider, below 0 narrower.

    None where it stays or may change.
    """
    wanted = answer.wanted
    if wanted is None or wanted.order.edit is None or answer.is_given or _WAIST not in wanted.heard.kept:
        return None
    if any(subject_of(wish.change) == _WAIST for wish in wanted.wishes):
        return None
    before, after = _before_and_after(answer)
    was, now = (None if facts is None else _waist(facts) for facts in (before, after))
    return None if was is None or now is None or abs(now - was) <= KEPT_CM else now - was


def _before_and_after(answer: Answer) -> tuple[GarmentFacts | None, GarmentFacts | None]:
    from swifttailor.tailor.reading import facts_of

    assert answer.wanted is not None and answer.wanted.order.edit is not None
    return facts_of(answer.wanted.order.edit), facts_of(answer.pattern)


def _waist(facts: GarmentFacts) -> float | None:
    band, torso = facts.waistband, facts.torso
    if band is not None and not band.at_hem:
        return band.lower
    return None if torso is None else torso.waist
