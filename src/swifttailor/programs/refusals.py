"""Designs that GarmentCode refuses before drafting: empty ones, and skirts that would slide down."""

from __future__ import annotations

from swifttailor.programs.design import Design
from swifttailor.programs.design_error import DesignError

_FLARED = ("SkirtCircle", "AsymmSkirtCircle", "SkirtManyPanels")
_BASES = {"GodetSkirt": "godet-skirt.base", "SkirtLevels": "levels-skirt.base"}


def refuse_combinations(design: Design) -> None:
    """Refuses combinations of parameters as GarmentCode's sampler does.

    Raises:
        DesignError: The garment would be empty, or nothing would hold it up.
    """
    lower, belt = design["meta.bottom"], design["meta.wb"]
    if design["meta.upper"]:
        return
    if not lower:
        what = f"only a waistband ({belt})" if belt else "empty"
        raise DesignError(
            f"The garment would be {what}: meta.upper and meta.bottom are both null. "
            "Set at least one of them."
        )
    base = design[_BASES[lower]] if lower in _BASES else lower
    loose_belt = not belt or design["waistband.waist"] > 1
    if base == "Skirt2" and design["skirt.ruffle"] > 1 and loose_belt:
        raise DesignError(
            f"A gathered skirt (skirt.ruffle {design['skirt.ruffle']:.3g}) would slide down without an upper "
            f"garment: {_belt(design)}. Set skirt.ruffle to 1, or meta.wb with waistband.waist 1, or "
            "meta.upper."
        )
    if base in _FLARED and (loose_belt or design["waistband.width"] <= 0.25):
        name = "levels-skirt.length" if lower == "SkirtLevels" else "flare-skirt.length"
        if design[name] > 0.5 or design["flare-skirt.suns"] > 0.75:
            raise DesignError(
                f"A heavy skirt ({name} {design[name]:.3g}, flare-skirt.suns "
                f"{design['flare-skirt.suns']:.3g}) would slide down without an upper garment: "
                f"{_belt(design)}. Set {name} to 0.5 at most and flare-skirt.suns to 0.75 at most, or "
                "meta.wb with waistband.waist 1 and waistband.width above 0.25, or meta.upper."
            )


def _belt(design: Design) -> str:
    if not design["meta.wb"]:
        return "meta.wb is null"
    return (
        f"waistband.waist is {design['waistband.waist']:.3g}, waistband.width {design['waistband.width']:.3g}"
    )
