"""Which kind of garment a pattern is, as errors are listed."""

from __future__ import annotations

from typing import Literal

from swifttailor.pattern import Pattern, body_region

GarmentKind = Literal["upper", "dress", "jumpsuit", "trousers", "skirt", "other"]
KINDS: tuple[GarmentKind, ...] = ("upper", "dress", "jumpsuit", "trousers", "skirt", "other")


def garment_kind(pattern: Pattern) -> GarmentKind:
    """The kind, from the names and labels of the panels alone.

    With a torso it is a dress where there is a skirt too, a jumpsuit where there are trousers, else an upper.
    """
    names = [p.name.lower() for p in pattern.panels]
    legs = [n for p, n in zip(pattern.panels, names, strict=True) if body_region(p.name, p.label) == "leg"]
    trousers = any("pant" in n or "trouser" in n for n in legs)
    arms = any(body_region(p.name, p.label) == "arm" for p in pattern.panels)
    torso = arms or any("torso" in n for n in names)
    if not (torso or legs):
        return "other"
    if trousers:
        return "jumpsuit" if torso else "trousers"
    if torso:
        return "dress" if legs else "upper"
    return "skirt"
