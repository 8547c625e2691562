"""Which words of a description nothing came of, although they speak of how a garment is cut.

Whoever names sleeves and gets what comes by chance should be told.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence, Set

from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Change, Gain, subject_of
from swifttailor.wording.lexicon import WordMark, WordReading, exclude
from swifttailor.wording.lexicon.sizes_of_details import TURNS

_ABOUT = {
    "sleeves": "sleeves sleeve_shape left_sleeve right_sleeve cuffs sleeve_cm sleeve_width_cm cuff_cm",
    "left_sleeve": "sleeves left_sleeve",
    "right_sleeve": "sleeves right_sleeve",
    "sleeve_head": "sleeve_shape",
    "neckline": "neckline neck_depth neck_depth_cm left_neckline right_neckline collar shoulders hood",
    "back_neckline": "back_neckline back_depth back_depth_cm",
    "collar": "collar collar_cm",
    "hood": "hood",
    "cuffs": "cuffs cuff_cm leg_cuffs leg_cuff_cm",
    "leg_cuffs": "leg_cuffs leg_cuff_cm",
    "waistband": "waistband waistband_cm",
    "hem_band": "waistband",
    "hem": "skirt_hem top_hem leg_hem hem_shape hem_cm leg_width_cm skirt_length_cm length_cm waistband legs "
    "slit",
    "slit": "slit slit_size slit_cm",
    "straps": "straps shoulders",
    "shoulders": "shoulders straps sleeves sleeve_shape neckline",
    "legs": "legs leg_hem inseam_cm leg_width_cm leg_cuffs slit slit_size",
    "tiers": "tiers skirt",
    "gores": "gores skirt",
    "godets": "godets skirt",
    "skirt": "skirt skirt_hem hem_cm skirt_length_cm hips tiers gores",
    "darts": "bodice skirt",
}
"""Claims that are about a part; parts that are named only to say where something is are left out."""
_HIGH_NECKS = frozenset(
    {Claim("collar", "stand"), Claim("collar", "turtleneck"), Claim("neck_depth", "high")}
)
_HIGH_WAISTS = frozenset({Claim("waist_seam", "empire"), Claim("rise", "high")})
_SAME = {claim: group for group in (_HIGH_NECKS, _HIGH_WAISTS) for claim in group}
"""What one word may mean of one garment or another: a "high neck", a "high waist"."""
_DIPPED = Claim("hem_shape", "high-low")
"""What is short in one place and long in another."""
_CLOSE_HIPS = Claim("hips", "close")
_CLOSE = frozenset({Claim("legs", "slim"), Claim("fit", "close"), _CLOSE_HIPS})
_OF_THE_CUT = frozenset(["fits", "lengths", "styles", "parts"])
_TURNING = frozenset(
    {Claim("skirt", value) for value in ("fitted base", "tiered", "gathered tiers", "godets")}
)
"""Skirts that are close down to where a text says that they turn."""
_COMPARED = frozenset(
    "longer shorter wider narrower tighter looser bigger smaller deeper higher lower shallower fuller "
    "slimmer roomier larger straighter rounder baggier puffier".split()
)
"""Words that compare parts of the cut; other comparisons ("warmer") ask for nothing that is cut."""


def unaccounted(
    words: WordReading,
    changes: Sequence[Change],
    never: Sequence[Claim] = (),
    numbers: Sequence[int] = (),
    *,
    compared: bool = False,
    told: Sequence[tuple[int, int]] = (),
) -> tuple[str, ...]:
    """Words about the cut that nothing came of, in their order.

    Args:
        words: By the lexicon.
        changes: What was understood of the text.
        never: What the text refuses.
        numbers: Where the numbers of the text end that are measures: what "long" behind one says is known.
        compared: Whether its comparisons are understood: "longer behind than in front".
        told: From where to where all of it is understood.
    """
    claims = {change.claim for change in changes if isinstance(change, Gain)}
    subjects = {subject_of(change) for change in changes}
    refused = {*words.never, *never}
    lacking = [lack.mark for lack in words.lacks]
    found = []
    opposed = [mark for pair in words.contradictions for mark in (pair.first, pair.second)]
    for k, mark in enumerate(words.marks):
        if mark.word.lower() in _COMPARED and not compared and not numbers:
            # "Not longer than the knee" is a hem at the knee.
            with_what = [
                i.claim for near in words.marks[k + 1 : k + 4] for e in near.entries for i in e.implied
            ]
            found += [] if claims.intersection(with_what) else [mark.word]
        if mark.role == "astray" and not mark.denied:
            named = any(start <= mark.start < end for start, end in told)
            turns = k > 0 and words.marks[k - 1].word.lower() in TURNS and not _TURNING.isdisjoint(claims)
            found += [] if named or turns else [mark.word]
            continue
        if not mark.entries or mark.entries[0].category not in _OF_THE_CUT or mark.role == "theirs":
            continue
        if mark.denied and any(entry.cannot for entry in mark.entries):  # "no train": it is left out
            continue
        if mark in opposed or any(start <= mark.start < end for start, end in told):  # named as such
            continue
        if any(0 <= mark.start - end <= 2 for end in numbers):
            continue
        if _DIPPED in claims and mark.entries[0].category == "lengths":  # "short in front and long behind"
            continue
        # What stands beside something that cannot be made says where that is: "a zip at the side".
        if any(near in lacking for near in words.marks[max(0, k - 2) : k + 3]):
            continue
        if not _is_answered(mark, claims, subjects, refused):
            found.append(mark.word)
    return tuple(dict.fromkeys(found))


def subjects_spoken_of(words: WordReading) -> frozenset[str]:
    """Claims that details of a text are about: what they imply, also denied, and what their part has.

    Any word may tell the kind, and what is said of sleeves tells of shoulders.

    Args:
        words: By the lexicon.
    """
    found = {"kind"}
    for mark in words.marks:
        for entry in mark.entries if mark.role not in ("garment", "like", "second") else ():
            found |= {each.claim.name for each in entry.implied} | {claim.name for claim in entry.without}
            found |= set(_ABOUT.get(entry.part or "", "").split())
    return frozenset(found | ({"shoulders"} if "sleeves" in found else set()))


def _is_answered(
    mark: WordMark, claims: Collection[Claim], subjects: Set[str], refused: Collection[Claim]
) -> bool:
    entry = mark.entries[0]
    if entry.category == "parts":
        about = _ABOUT.get(entry.part or "", "").split()
        return not about or bool(subjects & set(about)) or any(c.name in about for c in refused)
    said = [each.claim for one in mark.entries for each in one.implied]
    if not said:
        return True
    if mark.denied:
        gone = [claim for one in mark.entries for claim in one.without]
        return any(claim in claims for claim in gone) or any(claim in refused for claim in said)
    if any(claim in claims or not _SAME.get(claim, frozenset()).isdisjoint(claims) for claim in said):
        return True
    if _CLOSE_HIPS in claims and _CLOSE.issuperset(said):  # "tight on the thighs", of flares
        return True
    about = [claim for claim in claims for one in said if claim.name == one.name]
    stepped = {claim.name for claim in said} & (subjects - {claim.name for claim in claims})
    # Of "a long skirt" that becomes a short one nothing came, though its hem was spoken of.
    return bool(stepped) or any(not exclude(claim, one) for claim in about for one in said)
