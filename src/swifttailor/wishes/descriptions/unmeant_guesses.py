"""What a network guesses that no word of a text can mean."""

from __future__ import annotations

import re
from collections.abc import Iterable

from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Gain
from swifttailor.wishes.corrections.short_wholes import is_short_itself
from swifttailor.wishes.descriptions.words_for_guesses import may_be_meant
from swifttailor.wishes.reader import SURE, Wish
from swifttailor.wording.lexicon import WordReading

_SLITS = re.compile(r"slit|split|vent|\bcuts?\b|slash|open|gap|pleat|walk", re.IGNORECASE)
_PLACED = re.compile(
    r"(?:pockets?|bows?|buttons?|zips?|zippers?|laces?|lacing|ties?|tied|darts?|pleats?|folds|keyhole|seams?"
    r"|elastic|yokes?|print|logo|neck\w*|longer|long|shorter|higher|lower|two|one|none)"
    r"[^.;,]{0,25}? (?:at|in|on|down|up|behind)(?: the)? (?:front|back|rear|sides?)",
    re.IGNORECASE,
)
"""What else is in front or behind: no slit is there."""
_WAISTS = re.compile(
    r"waist|empire|bust|breast|bosom|chest|rib|hip|seam|drop|flapper|1920|20s|join|belly|tummy|bump", re.I
)
_LONG_SLEEVES = Claim("sleeves", "long")
_SHORT_SLEEVES = tuple([Claim("sleeves", value) for value in ("cap", "short", "elbow")])
_LOOSE = Claim("fit", "loose")
_UNCUFFED = frozenset({"turn_ups", "raw_hem"})
_CLOSE_HIPS = Claim("hips", "close")
_ROOMY = frozenset(
    {
        *[Claim("skirt", value) for value in ("gathered", "circle", "flared", "half circle", "a-line")],
        *[Claim("fit", value) for value in ("loose", "oversized")],
    }
)
_HIPS = re.compile(r"\bhips?\b|\bbum|bottom|\bseat\b|curv|hug|cling|tight|fitted", re.IGNORECASE)
_TIERS = frozenset({Claim("skirt", "tiered"), Claim("skirt", "gathered tiers")})
_POINTED = Claim("hem_shape", "pointed")


def without_guesses(text: str, found: Iterable[Wish], words: WordReading) -> tuple[Wish, ...]:
    """Without what only a network reads and no word of the text can mean.

    Turned-up and frayed ends are no bands, a bow at the back is no slit there, of the hips of tops nothing
    is said unless a word names them, and no gathered skirt or loose dress is close there.
    """
    lacking = {lack.what for lack in words.lacks}
    implied = {i.claim for i in words.implications}
    certain = {i.claim for i in words.implications if i.certainty == "certain"}
    unwaisted = any(m.denied and e.part == "waist_seam" for m in words.marks for e in m.entries)
    kinds = {i.claim.value for i in words.implications if i.claim.name == "kind"}
    kept = []
    for wish in found:
        claim = wish.change.claim if isinstance(wish.change, Gain) else None
        tied = claim is not None and claim.name == "waist_seam" and "belt" in lacking
        if tied and _LOOSE in implied and claim not in certain:
            continue  # a belt over loose cloth
        if claim is not None and claim not in implied:
            if claim in _SHORT_SLEEVES and _LONG_SLEEVES in implied and is_short_itself(text):
                continue  # "a robe, short, with lace sleeves"
            if claim.name in ("leg_cuffs", "leg_cuff_cm") and not lacking.isdisjoint(_UNCUFFED):
                continue
            if claim.name == "hips" and kinds == {"top"}:
                continue
            if claim == _CLOSE_HIPS and not _ROOMY.isdisjoint(implied) and not _HIPS.search(text):
                continue
            if not (words.unknown or may_be_meant(claim, text)):
                continue
            if claim.name == "hem_shape" and "curved_hem" in lacking:  # level but for its sides
                continue
            if claim.name == "waist_seam" and unwaisted and wish.certainty < SURE:
                continue
            if claim.name == "waist_seam" and not (words.unknown or _WAISTS.search(text)):
                continue
            if claim in _TIERS and ("second_layer" in lacking or _POINTED in implied):  # layers of cloth
                continue
            if claim.name == "slit" and "lacing" in lacking and not _SLITS.search(text):  # a laced front
                continue
            if claim.name == "slit" and _PLACED.search(text) and not _SLITS.search(text):
                continue
            if claim.name == "slit" and wish.certainty < SURE and not (words.unknown or _SLITS.search(text)):
                continue
        kept.append(wish)
    return tuple(kept)
