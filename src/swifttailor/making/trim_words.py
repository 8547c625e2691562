"""What the trims of a pattern are called on paper."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
import shapely

from swifttailor.pattern.trims import Patch, Trim

POCKETS: Mapping[str, str] = {
    "chest pocket": "breast pocket",
    "chest pockets": "breast pocket",
    "patch pockets": "patch pocket",
    "kangaroo pocket": "kangaroo pocket",
    "front pocket": "front pocket",
    "lower back pockets": "back pocket",
    "bib pocket": "bib pocket",
    "back pockets": "back pocket",
    "cargo pockets": "cargo pocket",
    "thigh pocket": "thigh pocket",
}
"""Pockets that are sewn on, by the trim's name."""
ACROSS = ("kangaroo pocket", "bib pocket", "front pocket", "lower back pockets")
"""Pockets whose halves meet in the middle."""
OPENINGS = ("side pockets", "slant pockets")
"""Pockets that hang inside."""
BANDS = ("buttons", "big buttons", "button placket", "polo placket", "waist placket")
"""What has bands along an opening; those without a placket on skirts alone."""
ZIPS = ("zip", "half zip", "back zip", "side zip")
_LINES: Mapping[str, str] = {
    "side pockets": "pocket opening",
    "slant pockets": "pocket opening: cut 1 cm outside",
    "side zip": "zip",
    "zip": "topstitching",
    "half zip": "topstitching",
    "fly": "fly: topstitching",
    "quilting": "",
    "double-breasted buttons": "edge of the upper front",
    "drawstring": "cord",
    "elastic waist": "",
    "back elastic": "",
    "neck cord": "cord",
    "lacing": "lacing",
    "back lacing": "lacing",
    "back buttons": "edge of the upper half",
    "boning": "channel of a bone",
    "cups": "seam of a cup",
    "smocking": "",
    "ruching": "gathers",
    "cowl folds": "fold of the cowl",
    "tucks": "tuck",
    "creases": "pressed crease",
    "pleat lines": "edge of a pleat",
    "front pleats": "edge of a pleat",
    **dict.fromkeys(("neck gathers", "shoulder gathers"), "gathers"),
    "sleeve petals": "edge of the upper half",
    **dict.fromkeys(
        ("pleated front", "fine pleats", "neck pleats", "shoulder pleats", "back pleat", "box pleats"),
        "fold of a pleat",
    ),
    "diagonal closing": "piping",
    "shoulder drape": "fold",
    "draped folds": "fold",
    **dict.fromkeys(("princess seams", "princess panels"), "princess seam"),
    "yoke": "seam of the yoke",
    "kick pleat": "fold of a pleat",
    "back yoke": "seam of the yoke",
}


def words_of(patch: Patch, *, is_flap: bool) -> str:
    """What is printed beside a patch or a line."""
    if patch.look == "metal":
        return "zip"
    if patch.look == "hole":
        return "rip" if "rip" in patch.trim else "opening"
    if patch.look == "dark":
        return _LINES.get(patch.trim, "")
    if patch.trim in POCKETS:
        return f"{POCKETS[patch.trim]}, flap" if is_flap else POCKETS[patch.trim]
    if patch.trim in ("welt pockets", "back welt pockets"):
        return "pocket welt"
    return "front band" if patch.trim in BANDS else patch.trim


def is_flap(patch: Patch, trims: Sequence[Trim]) -> bool:
    """Whether a piece of cloth falls over a pocket on the same panel: of two, it is the smaller one."""
    if patch.trim not in POCKETS or patch.trim in ACROSS or patch.look != "cloth":
        return False
    area = _area(patch)
    pockets = [
        other
        for other in trims
        if isinstance(other, Patch)
        and (other.trim, other.panel, other.look) == (patch.trim, patch.panel, "cloth")
        and np.hypot(*(other.outline.mean(axis=0) - patch.outline.mean(axis=0))) < 15.0
    ]
    return any(_area(other) > area + 1.0 for other in pockets)


def _area(patch: Patch) -> float:
    return float(shapely.Polygon(patch.outline).area)
