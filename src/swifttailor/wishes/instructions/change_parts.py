"""What grows or shrinks when a part of a garment is said to be longer, wider or higher."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Literal

from swifttailor.describing.claims import Claim
from swifttailor.describing.differences import Change, Gain, Step

Property = Literal["length", "width", "height", "depth"]
_LEGS = frozenset({"trousers", "shorts", "jumpsuit", "playsuit"})
_LOWER = frozenset({"trousers", "shorts"})
_Way = tuple[str, int]
"""A quantity, and whether it grows with the property (1) or shrinks (-1)."""

_OF: Mapping[str, Mapping[Property, _Way]] = {
    "sleeves": {
        "length": ("sleeve length", 1),
        "width": ("sleeve width", 1),
        "height": ("sleeve length", -1),
    },
    "sleeve_end": {"width": ("sleeve end", 1)},
    "legs": {"length": ("leg length", 1), "width": ("leg end", 1), "height": ("leg length", -1)},
    "leg_end": {"width": ("leg end", 1)},
    "inseam": {"length": ("leg length", 1)},
    "thigh": {"width": ("thigh", 1)},
    "neck": {
        "height": ("neck depth", -1),
        "depth": ("neck depth", 1),
        "width": ("neck width", 1),
        "length": ("neck depth", 1),
    },
    "back_neck": {"height": ("back depth", -1), "depth": ("back depth", 1)},
    "back": {"height": ("back depth", -1), "depth": ("back depth", 1)},
    "chest": {"width": ("chest", 1), "length": ("bodice length", 1)},
    "shoulders": {"width": ("shoulders", 1)},
    "straps": {"width": ("shoulders", 1)},
    "collar": dict.fromkeys(("length", "width", "height", "depth"), ("collar height", 1)),
    "hood": {
        "width": ("hood depth", 1),
        "height": ("hood height", 1),
        "length": ("hood height", 1),
        "depth": ("hood depth", 1),
    },
    "cuffs": dict.fromkeys(("length", "width", "height", "depth"), ("cuff length", 1)),
    "leg_cuffs": dict.fromkeys(("length", "width", "height", "depth"), ("leg cuff length", 1)),
    "band": dict.fromkeys(("width", "height", "depth"), ("waistband height", 1)),
    "armholes": {
        "height": ("armholes", -1),
        "depth": ("armholes", 1),
        "width": ("armholes", 1),
        "length": ("armholes", 1),
    },
    "tiers": {"length": ("tiers", 1), "width": ("tier gathers", 1)},
    "back_slit": {"length": ("back slit", 1), "height": ("back slit", 1)},
}
_OF_BODICES = frozenset(
    {"sleeves", "neck", "back_neck", "back", "chest", "shoulders", "straps", "collar", "hood", "armholes"}
)
"""Parts that skirts and trousers lack."""
WAIST_CM = 3.0
"""A waistband of skirt or trousers is too tight or too loose by so much, where nobody says by how much."""
_WAIST_OF_BODICES_CM = 6.0
"""The same of a bodice, taken in from shoulder to hem: by more, shoulders would be seen to change."""
PARTS = frozenset({*_OF, "hem", "waist", "hips", "skirt", "slit", "lower", "all"})
_SUBJECTS: Mapping[str, str] = {
    "sleeves": "sleeves sleeve_shape left_sleeve right_sleeve sleeve_cm sleeve_width_cm",
    "legs": "legs leg_hem inseam_cm leg_width_cm",
    "neck": "neckline neck_depth neck_depth_cm",
    "back": "back_neckline back_depth",
    "collar": "collar collar_cm",
    "hood": "hood",
    "cuffs": "cuffs cuff_cm",
    "band": "waistband waistband_cm",
    "skirt": "skirt skirt_hem hem_cm",
    "lower": "skirt skirt_hem legs leg_hem",
    "hem": "skirt_hem top_hem leg_hem hem_shape",
    "slit": "slit slit_size slit_cm",
    "tiers": "tiers",
    "straps": "straps",
    "shoulders": "shoulders",
    "chest": "fit chest_cm",
    "waist": "waist_seam",
}


def subjects_of(part: str) -> frozenset[str]:
    """Claims and quantities that are about a part."""
    quantities = {quantity for quantity, _ in _OF.get(part, {}).values()}
    if part == "all":
        return frozenset()
    if part in ("skirt", "lower"):
        quantities |= {"skirt hem", "skirt gathers", "length"}
    return frozenset({*quantities, *_SUBJECTS.get(part, "").split()})


def part_of(claim: str) -> str | None:
    """The part that a claim is about: of ``neckline`` the neck; None where it is of none of them."""
    return next((part for part, names in _SUBJECTS.items() if claim in names.split()), None)


def is_unsaid(change: Change) -> bool:
    """Whether it is a step that no number is said of: by how much a waist is let out is only usual then."""
    if not isinstance(change, Step):
        return False
    usual = {"waistband width": WAIST_CM, "chest": _WAIST_OF_BODICES_CM}.get(change.quantity)
    return change.amount is None or change.amount == usual


def changes_of(
    part: str | None, what: Property, sign: int, kind: str, amount: float | None
) -> tuple[Change, ...]:
    """What is asked for where a part is to be longer, wider or higher, or less so.

    Args:
        part: One of `PARTS`; None where none is named, which means the garment.
        what: The property.
        sign: 1 for more of it, -1 for less.
        kind: Of the garment.
        amount: cm or pieces, where it is said.

    Returns:
        Nothing where the garment has no such thing to measure.
    """
    if part == "sleeve_end" and kind in (*_LOWER, "skirt"):
        part = "leg_end" if kind in _LOWER else "hem"
    if part == "chest" and what == "length" and kind in ("top", "tunic"):
        part = "all"  # without a waist seam the body of it is all of it
    if part in _OF_BODICES and kind in (*_LOWER, "skirt"):
        return ()
    if part == "lower":
        part = "legs" if kind in _LEGS else "skirt"
    found = _way(part or "all", what, kind)
    if found is None:
        return ()
    if part == "hips" and kind in ("skirt", "dress") and amount is not None:
        return ()  # what is measured there is no lever of its own: better said than cut at the hem
    quantity, factor = found
    if part == "waist" and quantity == "waistband width" and amount is None:
        amount = WAIST_CM
    if part == "waist" and quantity == "chest" and amount is None:
        amount = _WAIST_OF_BODICES_CM
    step = Step(quantity, sign * factor, amount)
    if part == "straps" and sign < 0 and amount is None:
        return step, Gain(Claim("straps", "narrow"))
    return (step,)


def _way(part: str, what: Property, kind: str) -> _Way | None:
    if part == "all":
        if what == "height":
            return None
        if what == "depth":
            return None if kind in _LOWER or kind == "skirt" else ("neck depth", 1)
        if kind in _LEGS and (what == "length" or kind in _LOWER):
            return ("leg length", 1) if what == "length" else ("leg end", 1)
        return ("length", 1) if what == "length" else ("skirt hem" if kind == "skirt" else "chest", 1)
    if part == "hem":
        if what == "depth":
            return None
        if what == "width":
            return {"skirt": ("skirt hem", 1), "dress": ("skirt hem", 1)}.get(
                kind, ("leg end", 1) if kind in _LEGS else ("top width", 1)
            )
        return "leg length" if kind in _LEGS else "length", 1 if what == "length" else -1
    if part == "skirt":
        return {"length": ("length", 1), "width": ("skirt hem", 1), "height": ("length", -1)}.get(what)
    if part in ("hips", "waist"):
        if part == "waist" and what == "height" and kind in ("dress", "jumpsuit", "playsuit"):
            return "bodice length", -1
        if what != "width":
            return None
        if part == "waist":
            return ("waistband width", 1) if kind in _LOWER or kind == "skirt" else ("chest", 1)
        return (
            ("thigh", 1)
            if kind in _LEGS
            else ("top width", 1)
            if kind in ("top", "tunic")
            else ("skirt hem", 1)
        )
    if part == "slit":
        return None
    return _OF.get(part, {}).get(what)
