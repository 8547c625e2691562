"""Rows of cloth, each gathered into the one above: below the waist of a skirt, or below a close part."""

from __future__ import annotations

from swifttailor.pattern.drafts.cutting_table import CuttingTable
from swifttailor.pattern.drafts.fitted_skirt import SKIRT_BACK_Z, SKIRT_FRONT_Z
from swifttailor.pattern.drafts.outline import annular_sector

_PARTS = {"front": SKIRT_FRONT_Z, "back": SKIRT_BACK_Z}


def lay_tiers_below(table: CuttingTable, count: int, height: float, top_y: float, fullness: float) -> None:
    """Lays ``skirt_front_0``, ``skirt_back_0`` ... below a skirt, and sews them to its hems.

    Args:
        table: Where the skirt lies, its hems called ``hem``.
        count: Of the rows.
        height: Of each, cm.
        top_y: World height of the uppermost seam, cm.
        fullness: Width of each over that of the edge it is gathered into.
    """
    widths = {part: table.length(f"skirt_{part}.hem") for part in _PARTS}
    above = {part: f"skirt_{part}.hem" for part in _PARTS}
    for tier in range(count):
        for part in _PARTS:
            widths[part] *= fullness
            name = f"skirt_{part}_{tier}"
            outline = annular_sector("waist", widths[part], widths[part], height, top_y - tier * height)
            table.lay(name, outline, label="leg", at=(0.0, 0.0, _PARTS[part]), back=part == "back")
            table.seam(above[part], f"{name}.waist", gathered=True)
            above[part] = f"{name}.bottom"
        for side in ("left_side", "right_side"):
            table.seam(f"skirt_front_{tier}.{side}", f"skirt_back_{tier}.{side}")
