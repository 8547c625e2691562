"""Names and phrases of several words, which networks take apart: "dress shirt", "quarter circle skirt"."""

from __future__ import annotations

from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Gain
from swifttailor.wishes.corrections.named_collars import named_collars
from swifttailor.wishes.reader import Wish
from swifttailor.wording.lexicon import WordReading
from swifttailor.wording.lexicon.reading import Implication

_STRAIGHT, _GATHERED = Claim("skirt", "straight"), Claim("skirt", "gathered")
_PART = 3
"""Words of a long name of a part: a "full gathered skirt" is no full circle."""
_PHRASE = 4
"""Words of an entry of the lexicon that is surer than anything a network reads in it."""
_LENGTHS = frozenset(["micro", "mini", "midi", "midaxi"])


def is_against_phrase(wish: Wish, words: WordReading) -> bool:
    """Whether the network takes a part of a phrase for it: in "one and a half circles" a half circle."""
    if not isinstance(wish.change, Gain):
        return False
    claim = wish.change.claim
    long = [
        i.claim
        for i in words.implications
        if is_long_name(i)
        or (i.said and len(i.mark.word.split()) >= _PHRASE)
        or (i.mark.role == "part" and _words(i) >= _PART)
    ]
    return claim not in long and any(claim.name == other.name for other in long)


def is_long_name(implied: Implication) -> bool:
    """Whether words say it beyond doubt.

    Several name the garment, one of which alone may name another: a "dress shirt"; or a word names a length
    and nothing else: whatever milkmaids wear, a midi milkmaid dress ends at the calf.
    """
    word = implied.mark.word.lower()
    if implied.said and implied.claim.name == "skirt_hem" and (word in _LENGTHS or word.endswith(" length")):
        return not implied.mark.denied
    named = implied.claim.name == "kind" and implied.certainty == "certain" and not implied.mark.denied
    return named and _words(implied) > 1


def _words(implied: Implication) -> int:
    return len(implied.mark.word.replace("-", " ").split())


def hangs_so(refused: Claim, words: WordReading) -> bool:
    """Whether what is refused may be true of what is asked for: a gathered skirt may hang straight."""
    return refused == _STRAIGHT and any(i.claim == _GATHERED and i.said for i in words.implications)


def against_names(words: WordReading) -> dict[Claim, Claim]:
    """Shapes of skirts that nobody says because another's name speaks against them.

    A quarter circle is no three quarters of one, whatever a network takes it for.

    Returns:
        By what the name says, the last of what it speaks against in the same respect.
    """
    implied = {i.claim for i in words.implications}
    told = [
        i
        for i in words.implications
        if i.claim.name == "skirt" and i.certainty == "certain" and not i.mark.denied and _words(i) > 1
    ]
    against = [(i.claim, other) for i in told for entry in i.mark.entries for other in entry.against]
    return {claim: other for claim, other in against if other.name == claim.name and other not in implied}


def against_phrases(words: WordReading) -> tuple[Claim, ...]:
    """What phrases of several words speak against: "above the ankle" is no ankle, a tab collar is one."""
    implied = {i.claim for i in words.implications}
    told = [i for i in words.implications if i.said and not i.mark.denied and _words(i) >= _PART]
    against = [claim for i in told for entry in i.mark.entries for claim in entry.against]
    against += named_collars(words)
    return tuple(dict.fromkeys(claim for claim in against if claim not in implied))
