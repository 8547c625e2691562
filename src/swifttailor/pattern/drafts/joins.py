"""How upper and lower parts are sewn together at the waist."""

from __future__ import annotations

from swifttailor.pattern.drafts.cutting_table import CuttingTable

SKIRT_HALVES = ("left_waist", "right_waist")
"""Upper edges of a skirt panel drawn in two halves, in loop order of the front."""
SKIRT_WHOLE = ("waist",)
"""Upper edge of a skirt panel drawn in one piece."""


def sew_sides(table: CuttingTable, part: str) -> None:
    """Sews front and back of a skirt or band together at both sides."""
    for side in ("left_side", "right_side"):
        table.seam(f"{part}_front.{side}", f"{part}_back.{side}")


def sew_skirt_to_bodice(
    table: CuttingTable,
    edges: tuple[str, ...],
    *,
    gathered: bool = False,
    fronts: tuple[str, ...] = ("left", "right"),
) -> None:
    """Sews the skirt's upper edges to the bodice's waist and labels them; `fronts` are those with a waist."""
    for part, halves in (("front", fronts), ("back", ("right", "left"))):
        skirt = [f"skirt_{part}.{e}" for e in (edges if part == "front" else edges[::-1])]
        for edge in skirt:
            table.label(edge, "lower_interface")
        table.seam(skirt, [f"{half}_{part[0]}torso.waist" for half in halves], gathered=gathered)


def sew_skirt_to_band(table: CuttingTable, edges: tuple[str, ...], *, gathered: bool = False) -> None:
    """Sews the skirt's upper edges to the lower edge of the waistband."""
    for part in ("front", "back"):
        skirt = [f"skirt_{part}.{e}" for e in (edges if part == "back" else edges[::-1])]
        table.seam(f"wb_{part}.bottom", skirt, gathered=gathered)


def sew_trousers_to_band(table: CuttingTable, *, gathered: bool = False) -> None:
    """Sews the waists of both legs to the lower edge of the waistband."""
    table.seam("wb_front.bottom", ["pant_f_r.waist", "pant_f_l.waist"], gathered=gathered)
    table.seam("wb_back.bottom", ["pant_b_l.waist", "pant_b_r.waist"], gathered=gathered)


def sew_trousers_to_bodice(table: CuttingTable) -> None:
    """Sews the waists of both legs to the bodice's waist; labels the trousers' edges."""
    for part, halves in (("f", ("r", "l")), ("b", ("l", "r"))):
        for half in halves:
            table.label(f"pant_{part}_{half}.waist", "lower_interface")
            side = "left" if half == "l" else "right"
            table.seam(f"{side}_{part}torso.waist", f"pant_{part}_{half}.waist")
