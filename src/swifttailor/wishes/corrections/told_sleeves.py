"""Sleeves that words tell: how long they are, and that there are any."""

from __future__ import annotations

from collections.abc import Iterable

from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Gain
from swifttailor.wishes.looks.words_of_looks import has_sheer_sleeves
from swifttailor.wishes.reader import Wish
from swifttailor.wording.lexicon import SURENESS, WordReading
from swifttailor.wording.lexicon.conflicts import SCALES

_NONE, _BARE = Claim("sleeves", "none"), Claim("shoulders", "strapless")
_FRILL, _FRILLED_BAND = Claim("cuffs", "flounce"), Claim("cuffs", "band and flounce")
_BAND, _BANDLESS = Claim("cuffs", "band"), frozenset({"short", "cap"})
_LENGTHS = frozenset(value for step in SCALES["sleeves"] for value in step)
_OTHER_ARMS = {Claim("sleeves", "left only"): "right_sleeve", Claim("sleeves", "right only"): "left_sleeve"}
_OF_SLEEVES = frozenset({"sleeves", "left_sleeve", "sleeve_cm"})


def as_long_as_told(found: Iterable[Wish], words: WordReading) -> tuple[Wish, ...]:
    """The same wishes without another length of sleeves than words say.

    A network takes "long" for that of both: "a long cardigan, three quarter sleeves". Nor are there bands
    above the frills of flounced cuffs, or at the ends of short sleeves where none are spoken of.
    """
    said = [i.claim for i in words.implications if i.said and i.certainty == "certain"]
    told = {claim.value for claim in said if claim.name == "sleeves"}
    others = {Gain(_FRILLED_BAND)} if _FRILL in said and _FRILLED_BAND not in said else set()
    if told and told <= _BANDLESS and _BAND not in said:  # a shirt's cuffs are those of long sleeves
        others.add(Gain(_BAND))
    if len(told) == 1 and told <= _LENGTHS:
        others |= {Gain(Claim("sleeves", value)) for value in _LENGTHS - told}
    return tuple([wish for wish in found if wish.change not in others])


def with_named_sleeves(found: Iterable[Wish], never: Iterable[Claim], words: WordReading) -> tuple[Wish, ...]:
    """The same wishes with sleeves, where words speak of some: they are not left bare by what is only usual.

    "A sweetheart wedding dress, lace sleeves" has shoulders to sew these to.

    Args:
        found: What is asked for.
        never: What is refused; bare arms, where sleeves are spoken of.
        words: Of the text, by the lexicon.
    """
    found = tuple(found)
    if _NONE not in never:
        return found
    said = {i.claim for i in words.implications if i.said and i.certainty == "certain"}
    unwanted = {Gain(claim) for claim in (_NONE, _BARE) if claim not in said}
    kept = tuple([wish for wish in found if wish.change not in unwanted])
    if any(isinstance(w.change, Gain) and w.change.claim.name in _OF_SLEEVES for w in kept):
        return kept
    length = "long" if has_sheer_sleeves(words) else "short"
    sure = SURENESS["usual"] if len(kept) == len(found) else SURENESS["certain"]
    return (*kept, Wish(Gain(Claim("sleeves", length)), sure))


def of_the_only_arm(found: Iterable[Wish]) -> tuple[Wish, ...]:
    """The same wishes without how long the sleeve of the other arm is, where there is but one sleeve."""
    found = tuple(found)
    claims = [wish.change.claim for wish in found if isinstance(wish.change, Gain)]
    others = {name for only, name in _OTHER_ARMS.items() if only in claims}
    if len(others) != 1:
        return found
    return tuple([w for w in found if not (isinstance(w.change, Gain) and w.change.claim.name in others)])
