"""What has changed of a garment that an instruction does not speak of."""

from __future__ import annotations

from people_prompts import PeopleEdit
from swifttailor.describing.differences import find_differences
from swifttailor.describing.facts import GarmentFacts

_PARTS = {
    "sleeves": "sleeves left_sleeve right_sleeve sleeve_shape cuffs sleeve_cm sleeve_width_cm cuff_cm "
    "left_sleeve_cm right_sleeve_cm sleeve_length sleeve_width sleeve_end sleeve_head sleeve_gathers "
    "cuff_length cuff_opening",
    "neck": "neckline left_neckline right_neckline neck_depth neck_depth_cm back_neckline back_depth "
    "back_depth_cm neck_width back_depth collar collar_cm collar_height hood hood_depth hood_height",
    "shoulders": "shoulders straps armholes",
    "bodice": "fit bodice chest chest_cm bodice_gathers top_width",
    "waist": "waist waist_seam waistband waistband_cm waistband_height waistband_width rise bodice_length "
    "belly",
    "hem": "skirt_hem top_hem leg_hem length length_cm skirt_length skirt_length_cm inseam_cm leg_length "
    "hem_shape dip slit slit_size slit_cm slits front_slit back_slit left_slit right_slit",
    "skirt": "skirt hips hem_cm skirt_hem_width skirt_gathers tiers tier_gathers gores godets godet_cm "
    "godet_width godet_height base_width",
    "legs": "legs leg_width_cm leg_end thigh leg_cuffs leg_cuff_cm leg_cuff_length",
}
_PART = {name: part for part, names in _PARTS.items() for name in names.split()}
_WITH = {
    "sleeves": {"shoulders"},
    "neck": {"shoulders"},
    "shoulders": {"neck", "sleeves", "hem", "waist"},
    "bodice": {"shoulders", "sleeves", "waist", "skirt", "hem"},
    "waist": {"bodice", "skirt"},
    "hem": {"skirt", "legs", "waist"},
    "skirt": {"hem", "waist"},
    "legs": {"hem", "skirt"},
}
"""What cannot but change with a part: armholes are seen without sleeves, a hem widens with its length, and
lengths are measured from the shoulder."""
_EVERYTHING = frozenset({"kind", "sides"})
_ONE_SIDE = frozenset({"bare left", "bare right", "left only", "right only", "unequal"})
"""Values of claims about one side alone."""


def part_of(subject: str) -> str | None:
    """The part of a garment that a claim or a quantity is about; None where it is about all of it."""
    if subject == "skirt hem":  # the quantity is its width, the claim `skirt_hem` where it ends
        return "skirt"
    return _PART.get(subject.replace(" ", "_"))


def changed_elsewhere(prompt: PeopleEdit, before: GarmentFacts, after: GarmentFacts) -> list[str]:
    """What has visibly changed in parts that the instruction does not speak of, nor hang on those it does.

    Args:
        prompt: The instruction with what is expected of it.
        before: The garment that was given.
        after: The one that came out.
    """
    spoken = {e.claim for e in (*prompt.expect, *prompt.never)} | {
        m for s in prompt.steps for m in s.measures
    }
    if spoken & _EVERYTHING:
        return []
    one_sided = any(_ONE_SIDE.intersection(e.values) for e in prompt.expect)
    sides = {"sides"} if one_sided else set()  # what is bare or sleeved on one side makes the sides differ
    asked = {part for name in spoken if (part := part_of(name))}
    allowed = asked | {other for part in asked for other in _WITH[part]}
    gains, steps = find_differences(before, after)
    found = [
        f"{g.claim.name}={g.claim.value}"
        for g in gains
        if g.claim.name not in sides and part_of(g.claim.name) not in allowed
    ]
    found += [
        f"{s.quantity} {s.direction * (s.amount or 0):+.1f}"
        for s in steps
        if part_of(s.quantity) not in allowed
    ]
    return found
