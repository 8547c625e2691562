"""What is asked for, weighed against what else is: one slit alone, tiers and no flare, figures and sizes."""

from __future__ import annotations

import re
from collections.abc import Collection, Sequence

from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Gain
from swifttailor.wishes.reader import SURE, Wish
from swifttailor.wording.lexicon import Entry

_BOTH_FACES = re.compile(
    r"(?:neck\w*|(?<!\w)v)[^.,;]{0,20}(?<!\w)"
    r"(?:front (?:and|&) (?:(?:at|in) )?(?:the )?back|back (?:and|&) (?:(?:at|in) )?(?:the )?front)(?!\w)",
    re.IGNORECASE,
)
_BEHIND = {"v": "v", "square": "square", "round": "round", "scoop": "round", "crew": "round"}
"""Shapes of back necklines by those of front ones."""
_ONE_SLIT = re.compile(
    r"(?<!\w)(?:(?:one|single|only one|just one|only a|just a|an?) (?:\w+ )?(?:slit|split|vent)(?!\w)"
    r"(?![^.;,]{0,20}(?<!\w)(?:each|both|either|two|every)(?!\w))"
    r"|(?:slit|split|vent)[^.;]{0,30}(?<!\w)only"
    r"|(?:slit|split)(?!\w)[^.;,]{0,30}(?<!\w)(?:on|at|up|in) the (?:left|right))(?!\w)",
    re.IGNORECASE,
)
"""That there is one: it is called so, or stands in the singular beside the side that it is on."""
_AT_THE_SIDE = re.compile(
    r"(?<![\w-])(?:slit|split)(?!\w)[^.;,\d]{0,12}(?<!\w)(?:on|at|up|in) (?:the|teh|one|its) side(?!\w)",
    re.IGNORECASE,
)
"""One at either side, as it is called: "slit on the side"."""
_TOPS = frozenset({Claim("kind", "top"), Claim("kind", "tunic")})
"""Whose slit at the side is one at either side, by the lexicon."""
_SIZES_OF_WORDS = (
    ("cuff_cm", "cuffs", "deep", 12.0, 99.0),
    ("sleeve_cm", "sleeves", "cap", 3.0, 17.0),
    ("sleeve_cm", "sleeves", "short", 12.0, 33.0),
    ("sleeve_cm", "sleeves", "long", 46.0, 75.0),
    ("leg_cuff_cm", "leg_cuffs", "deep", 15.0, 99.0),
    ("waistband_cm", "waistband", "wide", 10.0, 99.0),
    ("waistband_cm", "waistband", "narrow", 0.0, 6.5),
)
"""Measure, claim, word, and between which figures in cm the word may be true."""


_FROM_THE_KNEE = Gain(Claim("skirt", "fitted base"))
_ABOVE_FLOUNCES = frozenset(
    [Gain(Claim("skirt_hem", end)) for end in ("micro", "mini", "above the knee", "knee", "below the knee")]
)
_WIDE_LEGS = frozenset({Gain(Claim("legs", "flared")), Gain(Claim("legs", "wide"))})
_WIDE, _TAPERED, _ROOMY = (
    Gain(Claim("legs", "wide")),
    Gain(Claim("legs", "tapered")),
    Gain(Claim("hips", "loose")),
)
_LOOSE = frozenset({Gain(Claim("fit", "loose")), Gain(Claim("fit", "oversized"))})
_CLINGS = frozenset(
    {Gain(Claim("hips", "close")), Gain(Claim("skirt", "pencil")), Gain(Claim("fit", "close"))}
)


def other_slits(text: str, claims: Sequence[Claim]) -> tuple[Claim, ...]:
    """Slits that are refused by asking for one alone: "one slit, on the right"."""
    places = {claim.value for claim in claims if claim.name == "slit"}
    if places == {"left", "right"} and not _TOPS.isdisjoint(claims):
        return ()
    if places in (set(), {"left", "right"}) and _AT_THE_SIDE.search(text):
        return (Claim("slit", "right"),)
    if len(places) != 1 or not _ONE_SLIT.search(text):
        return ()
    return tuple([Claim("slit", each) for each in ("left", "right", "front", "back") if each not in places])


def weighed_all(found: Sequence[Wish], named: Collection[Claim]) -> tuple[Wish, ...]:
    """What is asked for, without what figures, room and gores that are asked for contradict.

    Args:
        found: What is asked for.
        named: What names alone mean, and no detail says.
    """
    return _loosened_names(_gored_below(_loose_alone(_within_figures(found))), named)


def without_flare(found: Sequence[Wish]) -> tuple[Wish, ...]:
    """Without what skirts of rows or wedges, or flared from the knee, are not: flared from the waist.

    What flares from the knee does not end there, unless that is said for sure.
    """
    changes = [wish.change for wish in found]
    parted = any(Gain(Claim("skirt", value)) in changes for value in ("godets", "tiered", "fitted base"))
    less = {Gain(Claim("skirt", "flared"))} if parted else set()
    if Gain(Claim("skirt", "gathered tiers")) in changes:
        less.add(Gain(Claim("skirt", "gathered")))
    less_likely = _ABOVE_FLOUNCES if _FROM_THE_KNEE in changes else frozenset()
    return tuple(
        [w for w in found if w.change not in less and (w.certainty >= SURE or w.change not in less_likely)]
    )


def without_flared_legs(found: Sequence[Wish], meant: Collection[Entry]) -> tuple[Wish, ...]:
    """Without legs that widen to the hem where what widens is the thigh, as of jodhpurs.

    Wide legs that are to be narrow at the ankle are roomy at the hips: "baggy, tapered trousers"; those
    that end in cuffs are both.
    """
    bowed = any(option[0] == "bow" for entry in meant for draft in entry.drafts for option in draft.options)
    found = [w for w in found if not (bowed and w.change in _WIDE_LEGS)]
    cuffed = any(isinstance(w.change, Gain) and w.change.claim.name == "leg_cuffs" for w in found)
    if cuffed or not {_WIDE, _TAPERED} <= {w.change for w in found if w.certainty >= SURE}:
        return tuple(found)
    roomy = any(w.change == _ROOMY and w.certainty >= SURE for w in found)
    found = [w for w in found if w.change != _WIDE and (roomy or w.change != _ROOMY)]
    return tuple(found) if roomy else (*found, Wish(_ROOMY, SURE))


def _within_figures(found: Sequence[Wish]) -> tuple[Wish, ...]:
    """Without words for a size that a figure contradicts: a cuff of 8 cm is not deep."""
    figures = {w.change.claim.name: w.change.claim.value for w in found if isinstance(w.change, Gain)}
    against = {
        Gain(Claim(name, word))
        for measure, name, word, low, high in _SIZES_OF_WORDS
        if measure in figures and not low <= float(figures[measure]) <= high
    }
    return tuple([w for w in found if w.change not in against])


def _loose_alone(found: Sequence[Wish]) -> tuple[Wish, ...]:
    """Without an easy fit where a loose one is asked for: "long and loose, straight cut" stays loose."""
    certain = {w.change for w in found if w.certainty >= SURE}
    if not certain & {Gain(Claim("fit", "loose")), Gain(Claim("fit", "oversized"))}:
        return tuple(found)
    return tuple([w for w in found if w.change != Gain(Claim("fit", "easy"))])


def _gored_below(found: Sequence[Wish]) -> tuple[Wish, ...]:
    """Gores that flare from the knee are all of one row: no flounce below a close part is asked for."""
    changes = [wish.change for wish in found]
    if Gain(Claim("skirt", "gored")) not in changes or _FROM_THE_KNEE not in changes:
        return tuple(found)
    return tuple([w for w in found if w.change != _FROM_THE_KNEE])


def _loosened_names(found: Sequence[Wish], named: Collection[Claim]) -> tuple[Wish, ...]:
    """Without the close hips of a name where the whole is to be loose: a "loose fitting bodycon dress"."""
    if not {w.change for w in found if w.certainty >= SURE} & _LOOSE:
        return tuple(found)
    clings = {change for change in _CLINGS if change.claim in named}
    return tuple([w for w in found if w.change not in clings])


def of_both_faces(text: str, found: Sequence[Wish]) -> list[Wish]:
    """A neckline that is the same behind: "a V neck front and back"."""
    claims = {w.change.claim.name: w for w in found if isinstance(w.change, Gain)}
    front = claims.get("neckline")
    if front is None or "back_neckline" in claims or not _BOTH_FACES.search(text):
        return []
    assert isinstance(front.change, Gain)
    shape = _BEHIND.get(str(front.change.claim.value))
    return [] if shape is None else [Wish(Gain(Claim("back_neckline", shape)), front.certainty)]
