"""What the lexicon and the network say of a text, as one list of wishes."""

from __future__ import annotations

from collections.abc import Iterable

from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Gain
from swifttailor.wishes.reader import Wish
from swifttailor.wishes.text.mentions import find_mentions
from swifttailor.wishes.text.unread import says_nothing_else
from swifttailor.wording.claim_kinds import fits_kind
from swifttailor.wording.lexicon import SURENESS, WordReading, exclude
from swifttailor.wording.lexicon.conflicts import SCALES

SURE_OF_EVERY_WORD = 0.96
"""Enough for the network to come before the lexicon, where it leaves no word out."""
_DETAIL = {"certain": SURENESS["certain"], "usual": 0.92}
"""How sure what is said of a detail is: it is asked for, whatever is usual."""
_OF_BOTH_SIDES = {"neckline": "neckline", "sleeve": "sleeves"}
_PEPLUM = Claim("skirt", "peplum")


def united(text: str, words: WordReading, network: Iterable[Wish]) -> tuple[Wish, ...]:
    """What lexicon and network say together, surest first.

    Args:
        text: In which "long" behind a length is no claim: "60 cm long".
        words: By the lexicon.
        network: What the network reads of the same text, surest first.
    """
    lengths = {mention.end for mention in find_mentions(text) if mention.is_length}
    implied = [i for i in words.implications if len(text[: i.mark.start].rstrip(" -")) not in lengths]
    found = [
        Wish(Gain(each.claim), _DETAIL[each.certainty])
        for each in implied
        if each.certainty == "certain" or (each.said and each.certainty == "usual")
    ]
    told = [wish.change.claim for wish in found if isinstance(wish.change, Gain)]
    kind = next((str(claim.value) for claim in told if claim.name == "kind"), None)
    if kind == "skirt":  # "a skirt, no darts" asks for nothing of a bodice
        found = [w for w in found if not (isinstance(w.change, Gain) and w.change.claim.name == "bodice")]
    legs = any(claim.name == "legs" for claim in told)  # tight jeans are not straight ones
    implied = [
        each for each in implied if each.claim not in told and not (legs and each.claim.name == "legs")
    ]
    names = [Wish(Gain(each.claim), SURENESS[each.certainty]) for each in implied]
    network = tuple(network)
    guessed = [wish for wish in network if wish.certainty <= SURENESS["likely"]]
    for wish in (*[wish for wish in network if wish not in guessed], *names, *guessed):
        if not isinstance(wish.change, Gain):
            continue
        claim = wish.change.claim
        if claim in told or claim in words.never or any(exclude(claim, other) for other in told):
            continue
        if kind is not None and not fits_kind(claim.name, kind):
            continue
        if kind == "dress" and claim == _PEPLUM:
            continue  # only tops have one that the word of no text has asked for
        found.append(wish)
        told.append(claim)
    return tuple(sorted(found, key=lambda wish: -wish.certainty))


def explained(text: str, words: WordReading, network: Iterable[Wish]) -> tuple[Wish, ...]:
    """What both say where the network is sure of something for every word: it knows how they hang together.

    Returns:
        Surest first: what it is sure of, and of the rest what does not contradict that; nothing where there
        are words that it has no wish for.
    """
    sure = [w for w in network if isinstance(w.change, Gain) and w.certainty >= SURE_OF_EVERY_WORD]
    if not sure or not says_nothing_else(text, [wish.change for wish in sure]):
        return ()
    told = [wish.change.claim for wish in sure if isinstance(wish.change, Gain)]
    if any(claim in words.never for claim in told):
        return ()
    names = {claim.name for claim in told}
    said = [i.claim for i in words.implications if i.said and i.certainty == "certain"]
    # Slits at both sides, not one alone.
    beside = [claim for claim in said if claim.name in names and claim.name not in SCALES]
    for side in ("left_", "right_"):  # who tells one side has told of both
        names |= {plural for one, plural in _OF_BOTH_SIDES.items() if side + one in names}
    for wish in united(text, words, network):
        claim = wish.change.claim if isinstance(wish.change, Gain) else None
        if claim in told or claim is None or (claim.name in names and claim not in beside):
            continue
        if any(exclude(claim, other) for other in told):
            continue
        sure.append(wish)
    return tuple(sorted(sure, key=lambda wish: -wish.certainty))
