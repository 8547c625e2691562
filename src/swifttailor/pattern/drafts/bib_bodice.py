"""A bib in front and two straps over the shoulders, sewn to a waistband: dungarees, pinafores, aprons."""

from __future__ import annotations

from dataclasses import dataclass, replace

from swifttailor.pattern.drafts.band import lay_body_waist_band
from swifttailor.pattern.drafts.bodice import BACK_Z, FRONT_Z
from swifttailor.pattern.drafts.crossed_straps import STRAP_PLACE
from swifttailor.pattern.drafts.cutting_table import CuttingTable
from swifttailor.pattern.drafts.figure import Figure, Halves
from swifttailor.pattern.drafts.fitted_bodice import BLADE_FULLNESS
from swifttailor.pattern.drafts.outline import Outline
from swifttailor.pattern.drafts.strap_bodice import STRAP_LIFT

_STRAPS_BEHIND_X = 5.0
"""Distance of the middle of each strap from the middle of the waistband behind, cm."""
_WIDER_BELOW, _CORNER = 2.0, 1.0
"""How much wider the half of the bib is at the waist than above; how far it reaches beyond the strap, cm."""
_APART_Z = 2.5
"""So far behind the other strap does one that crosses it stand before draping, cm."""
_SIDES_FREE = 3.0
"""At least so much of each half of the waistband in front is free beside the bib, cm."""
_BRACES_X, _BRACES_PLACE = 0.42, 0.16
"""Where the middle of each brace begins in front, as a part of the half width of the waistband, and where it
lies on the shoulder, as a part of the way from the neck to its tip: close to the neck, or it slips off."""


@dataclass(frozen=True)
class Bib:
    """How bib, straps and waistband are cut."""

    strap: float
    """Width of the straps, cm."""
    over_bust: float
    """Height of the bib over the fullest part of the bust, cm."""
    waist_ease: float
    """On top of the waist girth, cm around."""
    band_height: float
    """Of the waistband, cm."""
    crossed: bool = False
    """Whether the straps cross behind."""
    bib: bool = True
    """Whether there is a bib; else straps rise from the waistband in front, too: braces."""


def lay_bib(table: CuttingTable, figure: Figure, shape: Bib) -> Halves:
    """Lays the waistband, and the left half of bib and straps; `sew_bib` sews them on after the mirror.

    Edges of ``left_ftorso``: waist, armhole, shoulder, neck, and of a bib centre; of ``left_btorso``, which
    is the strap behind: waist, armhole, shoulder, neck.

    Args:
        table: Where they go.
        figure: The body.
        shape: The cut.

    Returns:
        Half widths of the lower edge of the waistband, cm: what is sewn to it.
    """
    lower = lay_body_waist_band(table, figure, shape.band_height, shape.waist_ease)
    upper = figure.waist.eased(shape.waist_ease)
    place = STRAP_PLACE if shape.bib else _BRACES_PLACE
    middle = figure.neck_x + place * (figure.shoulder_x - figure.neck_x)
    inner, outer = middle - shape.strap / 2, middle + shape.strap / 2
    wide = min(outer + _CORNER + _WIDER_BELOW, upper.front - _SIDES_FREE)
    waist_y, top_y = figure.waist_y, figure.bust_y + shape.over_bust
    lift = STRAP_LIFT * figure.front_fullness
    if shape.bib:
        bib = Outline(0.0, waist_y).line("waist", wide, waist_y)
        bib.quadratic("armhole", (outer + _CORNER, 0.5 * (waist_y + top_y)), (outer + 0.3, top_y))
        bib.line("armhole", outer, figure.shoulder_line(outer) + lift)
        bib.line("shoulder", inner, figure.shoulder_line(inner) + lift)
        bib.line("neck", inner, top_y).line("neck", 0.0, top_y).line("centre", 0.0, waist_y)
        front, ends = [upper.front - wide, wide, wide, upper.front - wide], "free left right free"
    else:
        lift = 0.0  # they lie beside the bust
        start = _BRACES_X * upper.front - shape.strap / 2
        wide = start + shape.strap
        bib = Outline(start, waist_y).line("waist", wide, waist_y)
        bib.line("armhole", outer, figure.shoulder_line(outer) + lift)
        bib.line("shoulder", inner, figure.shoulder_line(inner) + lift).line("neck", start, waist_y)
        free = upper.front - wide
        front, ends = [free, shape.strap, 2 * start, shape.strap, free], "free left free right free"
    table.lay("left_ftorso", bib.closed(), label="body", at=(0.0, 0.0, FRONT_Z))
    lift = BLADE_FULLNESS * (figure.neck_y - waist_y)
    near, far = _STRAPS_BEHIND_X - shape.strap / 2, _STRAPS_BEHIND_X + shape.strap / 2
    at = (-far, -near) if shape.crossed else (near, far)
    strap = Outline(at[0], waist_y).line("waist", at[1], waist_y)
    strap.line("armhole", outer, figure.shoulder_line(outer) + lift)
    strap.line("shoulder", inner, figure.shoulder_line(inner) + lift).line("neck", at[0], waist_y)
    table.lay("left_btorso", strap.closed(), label="body", at=(0.0, 0.0, BACK_Z), back=True)
    _divide(table, "wb_front", front, ends)
    free = upper.back - far
    ends = "free left free right free" if shape.crossed else "free right free left free"
    _divide(table, "wb_back", [free, shape.strap, 2 * near, shape.strap, free], ends)
    table.seam("left_ftorso.shoulder", "left_btorso.shoulder")
    for panel in ("left_ftorso", "left_btorso"):
        table.label(f"{panel}.armhole", "left_armhole")
        table.label(f"{panel}.neck", "left_collar")
    return lower


def sew_bib(table: CuttingTable, *, crossed: bool = False, bib: bool = True) -> None:
    """Sews bib and straps to the waistband, and both halves of the bib together.

    Args:
        table: Where they lie, mirrored.
        crossed: Whether the straps cross behind: the right one then lies over the left one.
        bib: Whether there is a bib whose halves are to be joined.
    """
    if crossed:
        over = table.pieces["right_btorso"]
        x, y, z = over.placement.translation
        over.placement = replace(over.placement, translation=(x, y, z - _APART_Z))
    if bib:
        table.seam("right_ftorso.centre", "left_ftorso.centre")
    for side in ("left", "right"):
        table.seam(f"{side}_ftorso.waist", f"wb_front.{side}")
        table.seam(f"{side}_btorso.waist", f"wb_back.{side}")


def _divide(table: CuttingTable, band: str, widths: list[float], names: str) -> None:
    """Cuts the upper edge of a waistband into edges of such widths, cm, and gives them names."""
    piece = table.pieces[band]
    (top,) = piece.find("top")
    total, reached = sum(widths), 0.0
    fractions = []
    for width in widths[:-1]:
        reached += width
        fractions.append(reached / total)
    parts = [part.renamed(name) for part, name in zip(top.split(fractions), names.split(), strict=True)]
    at = piece.sides.index(top)
    piece.sides[at : at + 1] = parts
    for name in set(names.split()):
        table.label(f"{band}.{name}", "lower_interface")
