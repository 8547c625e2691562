"""Lengths and widths well within what a word means: who asks for long sleeves does not want the shortest."""

from __future__ import annotations

from collections.abc import Sequence

from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Change, Gain, Step
from swifttailor.describing.facts import GarmentFacts

FULL_LEGS_CM, FULL_LEGS_AT_MOST_CM = 5.0, 8.0
"""Where full legs end above the floor, and what is left as it is."""
ON_THE_FOOT_CM, WHOLE_FOOT_CM, WHOLE_AT_MOST_CM = 66.0, 7.5, 9.0
"""The same of legs whose ends are no wider than that around: lower ones rest on the foot and fold."""
JUMPSUIT_CM, JUMPSUIT_AT_MOST_CM = 7.5, 9.0
"""The same of jumpsuits, whose bodice gives: on the body they hang some three centimetres lower."""
OVER_THE_FOOT_CM = 43.0
"""Around; legs with narrower ends stay above the instep, on which they would be torn open."""
LONG_SLEEVES, LONG_SLEEVES_AT_LEAST = 0.98, 0.93
"""Parts of the arm's length."""
MAXI, MAXI_AT_MOST = 0.18, 0.24
"""Parts of the height of the knee at which the hem hangs."""
FLOOR_CM, FLOOR_AT_LEAST_CM, FLOOR_AT_MOST_CM = 7.0, 5.5, 7.5
"""Where the hem of a gown is measured on its pattern. On the body long dresses hang half a dozen
centimetres lower (median of 28 drapes, `benchmarks/hem_levels.py`); skirts do not."""
SKIRT_FLOOR_CM, SKIRT_FLOOR_AT_LEAST_CM, SKIRT_FLOOR_AT_MOST_CM = 4.5, 3.5, 5.5
MINI_CM, MINI_AT_MOST_CM = 13.0, 17.0
"""How far below the crotch a mini ends, and what is left as it is."""
ABOVE_KNEE_CM, ABOVE_KNEE_AT_LEAST_CM = 10.0, 7.0
KNEE_CM, COVERED_KNEE_CM, COVERED_AT_LEAST_CM = 2.5, -5.0, -3.0
"""How far from the middle of the knee a hem "at the knee" may be, where one below it ends, and at least."""
MIDI, MIDI_AT_LEAST = (0.68, 0.78), (0.58, 0.7)
"""Parts of the height of the knee at which the hem of a midi skirt and dress is measured, and at least: lower
ones look like maxis."""
COVERED_AT_MOST_CM, BELOW_CM = -10.0, -7.0
"""How far above the middle of the knee a hem ends that is to be below it and hangs lower than that."""
ABOVE_THE_KNEE_CM, SLIT_SHARE = 13.0, 0.9
"""How far above the knee a slit ends, and the part of that height that is left as it is."""
BELOW_CROTCH_CM, BELOW_CROTCH_AT_MOST_CM = 9.0, 13.0
"""Where a high slit in a long skirt begins."""
AS_STATED_CM = 1.5
"""By so much a hem may end elsewhere than was stated."""
WIDE_LEGS, WIDE_LEGS_AT_LEAST = 1.3, 1.2
"""Ends of wide legs in girths of the thigh."""


def well_within(said: Sequence[Change], facts: GarmentFacts) -> tuple[Change, ...]:
    """Measures that make plain what words ask for, where a garment meets them at their border.

    Args:
        said: What is asked for, what is likely meant, and what goes without saying.
        facts: What the garment shows now.

    Returns:
        Measures to be cut to where that costs nothing; none of a part of which a measure is asked for.
    """
    claims = [wish.claim for wish in said if isinstance(wish, Gain)]
    names = {claim.name for claim in claims}
    words = {(claim.name, claim.value) for claim in claims}
    found = [
        _legs(words, names, facts),
        _wide_legs(words, names, facts),
        _sleeves(words, names, facts),
        _skirt(words, names, facts),
        _high_slit(words, names, facts),
        *_slits(words, names, facts),
    ]
    return tuple([Gain(each) if isinstance(each, Claim) else each for each in found if each is not None])


def off_the_floor(said: Sequence[Change], facts: GarmentFacts) -> tuple[Change, ...]:
    """By how much a gown or skirt is too long to walk in: too few cm to show in a stated length."""
    claims = [wish.claim for wish in said if isinstance(wish, Gain)]
    words, hem = {(claim.name, claim.value) for claim in claims}, facts.hem
    if hem is None or facts.kind not in ("dress", "skirt") or ("skirt_hem", "floor") not in words:
        return ()
    stated = {claim.name for claim in claims} & {"length_cm", "skirt_length_cm", "hem_shape"}
    gown = facts.kind == "dress"
    if stated or hem.level >= (FLOOR_AT_LEAST_CM if gown else SKIRT_FLOOR_AT_LEAST_CM):
        return ()
    return (Step("length", -1, round((FLOOR_CM if gown else SKIRT_FLOOR_CM) - hem.level, 1)),)


def as_stated(said: Sequence[Change], facts: GarmentFacts) -> tuple[Change, ...]:
    """By how much a garment is longer or shorter than was stated, where that shows: words forgive more.

    Legs that are longer than was stated lie on the feet.
    """
    claims = {wish.claim.name: wish.claim.value for wish in said if isinstance(wish, Gain)}
    if "hem_shape" in claims:
        return ()
    skirt = facts.length if facts.kind == "skirt" else facts.skirt.length if facts.skirt else None
    long = facts.length if facts.kind in ("top", "dress") else None
    for name, length in (("length_cm", long), ("skirt_length_cm", skirt)):
        stated = claims.get(name)
        if length is not None and isinstance(stated, float | int) and abs(stated - length) > AS_STATED_CM:
            by = round(float(stated) - length, 1)
            return (Step("length", 1 if by > 0 else -1, abs(by)),)
    stated, legs = claims.get("inseam_cm"), facts.trousers
    if legs is not None and isinstance(stated, float | int) and legs.inseam - stated > AS_STATED_CM:
        return (Step("leg length", -1, round(legs.inseam - stated, 1)),)
    return ()


_Words = set[tuple[str, str | float]]


def _legs(words: _Words, names: set[str], facts: GarmentFacts) -> Claim | None:
    legs, hem = facts.trousers, facts.hem
    if legs is None or hem is None or ("leg_hem", "full") not in words or names & {"inseam_cm", "length_cm"}:
        return None
    whole = facts.kind == "jumpsuit"
    low, most = (JUMPSUIT_CM, JUMPSUIT_AT_MOST_CM) if whole else (FULL_LEGS_CM, FULL_LEGS_AT_MOST_CM)
    if not whole and legs.hem < ON_THE_FOOT_CM:
        low, most = WHOLE_FOOT_CM, WHOLE_AT_MOST_CM
    if hem.level <= most or legs.hem < OVER_THE_FOOT_CM:
        return None
    return Claim("inseam_cm", round(legs.inseam + hem.level - low, 1))


def _wide_legs(words: _Words, names: set[str], facts: GarmentFacts) -> Claim | None:
    legs, thigh = facts.trousers, facts.body.thigh_girth
    if legs is None or ("legs", "wide") not in words or "leg_width_cm" in names or legs.cuff is not None:
        return None
    return None if legs.hem >= WIDE_LEGS_AT_LEAST * thigh else Claim("leg_width_cm", round(WIDE_LEGS * thigh))


def _sleeves(words: _Words, names: set[str], facts: GarmentFacts) -> Claim | None:
    sleeves, arm = [s for s in (facts.left_sleeve, facts.right_sleeve) if s], facts.body.arm_length
    if len(sleeves) < 2 or ("sleeves", "long") not in words or "sleeve_cm" in names:
        return None
    short = min(sleeve.length for sleeve in sleeves) < LONG_SLEEVES_AT_LEAST * arm
    return Claim("sleeve_cm", round(LONG_SLEEVES * arm, 1)) if short else None


def _skirt(words: _Words, names: set[str], facts: GarmentFacts) -> Claim | None:
    hem, skirt = facts.hem, facts.skirt
    if hem is None or names & {"length_cm", "skirt_length_cm", "hem_shape"}:
        return None
    level = None
    if ("skirt_hem", "floor") in words:
        gown = facts.kind == "dress"
        most = FLOOR_AT_MOST_CM if gown else SKIRT_FLOOR_AT_MOST_CM
        level = (FLOOR_CM if gown else SKIRT_FLOOR_CM) if hem.level > most else None
    elif ("skirt_hem", "maxi") in words and ("skirt_hem", "ankle") not in words:
        level = MAXI * facts.body.knee if hem.level > MAXI_AT_MOST * facts.body.knee else None
    elif ("skirt_hem", "mini") in words:
        mini = facts.body.crotch - MINI_CM
        level = mini if hem.level < facts.body.crotch - MINI_AT_MOST_CM else None
    elif ("skirt_hem", "above the knee") in words:
        above = facts.body.knee + ABOVE_KNEE_CM
        level = above if hem.level < facts.body.knee + ABOVE_KNEE_AT_LEAST_CM else None
    elif ("skirt_hem", "knee") in words:
        level = facts.body.knee if abs(hem.level - facts.body.knee) > KNEE_CM else None
    elif ("skirt_hem", "below the knee") in words and hem.level > facts.body.knee + COVERED_AT_LEAST_CM:
        level = facts.body.knee + COVERED_KNEE_CM
    elif ("skirt_hem", "below the knee") in words and hem.level < facts.body.knee + COVERED_AT_MOST_CM:
        level = facts.body.knee + BELOW_CM
    elif ("skirt_hem", "midi") in words and ("skirt_hem", "ankle") not in words:
        low = hem.level < MIDI_AT_LEAST[facts.kind == "dress"] * facts.body.knee
        level = MIDI[facts.kind == "dress"] * facts.body.knee if low else None
    if level is None or facts.kind not in ("dress", "skirt"):
        return None
    if skirt is None:
        return Claim("length_cm", round(facts.length + hem.level - level, 1)) if facts.length else None
    length = facts.length if facts.kind == "skirt" else skirt.length
    return Claim("skirt_length_cm", round(length + hem.level - level, 1))


def _slits(words: _Words, names: set[str], facts: GarmentFacts) -> list[Step]:
    """Slits of no stated size in a long skirt open to above the knee; a vent behind is left as it is."""
    hem, skirt = facts.hem, facts.skirt
    if hem is None or skirt is None or names & {"slit_cm", "slit_size"}:
        return []
    above = facts.body.knee + ABOVE_THE_KNEE_CM - hem.level
    low = [s for s in skirt.slits if s.place != "back" and ("slit", s.place) in words]
    low = [slit for slit in low if slit.height < SLIT_SHARE * above]
    return [Step(f"{slit.place} slit", 1, round(above - slit.height, 1)) for slit in low]


def _high_slit(words: _Words, names: set[str], facts: GarmentFacts) -> Step | None:
    hem, skirt = facts.hem, facts.skirt
    if hem is None or skirt is None or not skirt.slits or "slit_cm" in names:
        return None
    if ("slit_size", "high") not in words or hem.level > facts.body.knee / 2:
        return None
    highest = max(skirt.slits, key=lambda slit: slit.height)
    lacking = facts.body.crotch - hem.level - highest.height
    if lacking <= BELOW_CROTCH_AT_MOST_CM:
        return None
    return Step(f"{highest.place} slit", 1, round(lacking - BELOW_CROTCH_CM, 1))
