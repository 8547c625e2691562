"""Which design parameters a garment follows from; the others may be anything, and are drawn by lot."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

_ANGLED = ("TrapezoidNeckHalf", "CircleArcNeckHalf")
_FLIPPED = ("CurvyNeckHalf", "CircleArcNeckHalf", "Bezier2NeckHalf")
_CUT = ("depth", "width", "place")
_LEVELS = ("base", "level", "num_levels", "level_ruffle", "length", "rise", "base_length_frac")
_GODETS = ("base", "insert_w", "insert_depth", "num_inserts", "cuts_distance")


def matters(design: Mapping[str, Any]) -> frozenset[str]:
    """The names of the parameters that decide about the pattern of a design.

    Args:
        design: A complete one, by flat names.
    """
    names = {"meta.upper", "meta.wb", "meta.bottom"}
    if design["meta.wb"]:
        names |= {"waistband.waist", "waistband.width"}
    if design["meta.upper"]:
        names |= _of_upper(design)
    names |= _of_bottom(design, rises=design["meta.upper"] != "FittedShirt")
    return frozenset(names)


def _of_upper(design: Mapping[str, Any]) -> set[str]:
    fitted = design["meta.upper"] == "FittedShirt"
    names = {"collar.fc_depth", "collar.bc_depth", "left.enable_asym"}
    own = {"strapless"} if fitted else {"width", "flare"}
    names |= {f"shirt.{name}" for name in own}
    if not fitted:
        names.add("shirt.length")
    strapless = fitted and design["shirt.strapless"]
    names |= _of_side(design, "", strapless)
    if design["left.enable_asym"]:
        names |= {f"left.shirt.{name}" for name in own}
        return names | _of_side(design, "left.", fitted and design["left.shirt.strapless"])
    if not strapless:
        names.add("collar.component.style")
        style = design["collar.component.style"]
        if style in ("Turtle", "SimpleLapel"):
            names.add("collar.component.depth")
        if style == "SimpleLapel":
            names.add("collar.component.lapel_standing")
        if style == "Hood2Panels":
            names |= {"collar.component.hood_depth", "collar.component.hood_length"}
    return names


def _of_side(design: Mapping[str, Any], side: str, strapless: bool) -> set[str]:
    sleeve, collar = f"{side}sleeve", f"{side}collar"
    names = {f"{sleeve}.connecting_width"}
    if strapless:
        return names
    names |= {f"{collar}.width", f"{sleeve}.sleeveless"}
    style = None if design["left.enable_asym"] else design["collar.component.style"]
    for end in "fb":
        if style in ("Turtle", "Hood2Panels") or (style == "SimpleLapel" and end == "b"):
            continue  # these have a round neckline, whatever is said of it
        shape = design[f"{collar}.{end}_collar"]
        names.add(f"{collar}.{end}_collar")
        if shape in _ANGLED:
            names.add(f"{collar}.{end}c_angle")
        if shape in _FLIPPED:
            names.add(f"{collar}.{end}_flip_curve")
        if shape == "Bezier2NeckHalf":
            names |= {f"{collar}.{end}_bezier_x", f"{collar}.{end}_bezier_y"}
    if design[f"{sleeve}.sleeveless"]:
        return names | {f"{sleeve}.armhole_shape", f"{sleeve}.smoothing_coeff"}
    own = (
        "length",
        "end_width",
        "sleeve_angle",
        "connect_ruffle",
        "smoothing_coeff",
        "standing_shoulder",
        "opening_dir_mix",
    )
    names |= {f"{sleeve}.{name}" for name in own}
    if design[f"{sleeve}.standing_shoulder"]:
        names.add(f"{sleeve}.standing_shoulder_len")
    return names | _of_cuff(design, sleeve)


def _of_cuff(design: Mapping[str, Any], limb: str) -> set[str]:
    names, kind = {"type"}, design[f"{limb}.cuff.type"]
    if kind:
        names |= {"top_ruffle", "cuff_len"}
    if kind in ("CuffSkirt", "CuffBandSkirt"):
        names |= {"skirt_flare", "skirt_ruffle"}
    if kind == "CuffBandSkirt":
        names.add("skirt_fraction")
    return {f"{limb}.cuff.{name}" for name in names}


def _of_bottom(design: Mapping[str, Any], *, rises: bool) -> set[str]:
    kind = design["meta.bottom"]
    rise = {"rise"} if rises else set()
    if kind == "Pants":
        return {f"pants.{name}" for name in {"length", "width", "flare"} | rise} | _of_cuff(design, "pants")
    if kind == "GodetSkirt":
        names = {f"godet-skirt.{name}" for name in _GODETS}
        return names | _of_skirt(design, design["godet-skirt.base"], {"length"} | rise, alone=False)
    if kind == "SkirtLevels":
        names = {f"levels-skirt.{name}" for name in _LEVELS}
        for part in ("base", "level"):
            names |= _of_skirt(design, design[f"levels-skirt.{part}"], {"rise"}, alone=False)
        return names
    return _of_skirt(design, kind, {"length"} | rise, alone=True)


def _of_skirt(design: Mapping[str, Any], kind: str | None, ends: set[str], *, alone: bool) -> set[str]:
    """Of one skirt; `ends` are the names that say where it begins and ends, where it does by itself."""
    if kind == "Skirt2":
        return {f"skirt.{name}" for name in {"ruffle", "bottom_cut", "flare"} | ends}
    if kind == "PencilSkirt":
        slits = {f"{side}_slit" for side in ("front", "back", "left", "right")} if alone else set()
        return {f"pencil-skirt.{name}" for name in {"flare", "low_angle"} | ends | slits}
    if kind not in ("SkirtCircle", "AsymmSkirtCircle", "SkirtManyPanels"):
        return set()
    names = set(ends)
    names.add("asymm.front_length" if kind == "AsymmSkirtCircle" else "suns")
    if kind == "SkirtManyPanels":
        names |= {"skirt-many-panels.n_panels", "skirt-many-panels.panel_curve"}
    elif alone:
        names.add("cut.add")
        if design["flare-skirt.cut.add"]:
            names |= {f"cut.{name}" for name in _CUT}
    return {f"flare-skirt.{name}" for name in names}
