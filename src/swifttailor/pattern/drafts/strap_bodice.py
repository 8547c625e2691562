"""The bodice on thin straps: straight across at the bust, two straps over the shoulders."""

from __future__ import annotations

from dataclasses import dataclass

from swifttailor.pattern.drafts.bodice import (
    BACK_Z,
    FRONT_Z,
    HEM_BALANCE,
    SHORT_CM,
    SIDE_MINIMUM,
    ribs_at,
    sew_torso,
)
from swifttailor.pattern.drafts.cutting_table import CuttingTable
from swifttailor.pattern.drafts.figure import Figure
from swifttailor.pattern.drafts.outline import Outline
from swifttailor.pattern.drafts.side_seam import as_long, draw_side, runs_back, side_length

OVER_BUST = 8.5
"""Height of the front's upper corners over the fullest part of the bust, cm."""
OVER_UNDERARM = 1.0
"""Height of the back's upper corners over the underarm, cm."""
TAKEN_IN = 1.5
"""So far the middle of the upper edge is taken in, on either side, cm: it would stand off the chest."""
STRAP_PLACE = 0.36
"""Where the straps lie, as a part of the way from neck to shoulder tip: further out they slide off."""
STRAP_LIFT = 0.4
"""Part of the front's extra length over the bust that the straps have."""
_HIP_CM, _SHAPED_HIP_CM = 6.0, 2.0
"""Least room over the body at the hem, cm around; of sides that bend in, besides what they lose above it."""


@dataclass(frozen=True)
class StrapBodice:
    """How the bodice is cut."""

    strap: float
    """Width of the straps, cm."""
    chest_ease: float
    """On top of the bust girth, cm around."""
    length: float
    """Hem below the waist, cm."""
    dip: float
    """How far the front falls between the straps, cm."""
    flare: float = 0.0
    """Extra width at the hem, cm around."""
    waist_shaping: float = 0.0
    """How far each side seam bends inward between underarm and hem, cm."""
    stretches: bool = False
    """Whether it is of cloth that stretches: what ends at the ribs is as narrow as these."""


def lay_strap_bodice(table: CuttingTable, figure: Figure, shape: StrapBodice) -> None:
    """Lays and sews both left halves; call before `CuttingTable.mirror` lays the right-hand ones.

    Edges of ``left_ftorso`` and ``left_btorso``: hem, side, armhole, shoulder, neck, centre.
    """
    chest = figure.bust.eased(shape.chest_ease)
    hem_y = figure.waist_y - shape.length
    under_y = max(figure.armpit_y - 1.5, hem_y + SIDE_MINIMUM)
    shaping = shape.waist_shaping if shape.length >= SHORT_CM else 0.0
    body = figure.girth_below_waist(shape.length).eased(_SHAPED_HIP_CM + 2 * shaping if shaping else _HIP_CM)
    widening = max(body.girth - chest.girth, 0.0) / 4 if shape.length > 0 else 0.0
    hugs = shape.stretches and shape.length < 0.0
    if hugs:
        body = ribs_at(figure, hem_y).eased(shape.chest_ease)
        widening = (body.girth - chest.girth) / 4
    widening += shape.flare / 4
    behind = runs_back(chest, body, widening, under_y - hem_y) if shaping or hugs else 0.0
    front_corner = (chest.front + widening - behind, hem_y + 0.5)
    for side, half in (("f", chest.front), ("b", chest.back)):
        front = side == "f"
        drop = HEM_BALANCE * figure.front_fullness if front else 0.0
        lift = STRAP_LIFT * figure.front_fullness if front else 0.0
        base_y = figure.bust_y + OVER_BUST if front else under_y + OVER_UNDERARM
        base_y = max(base_y, under_y + 0.5)
        outline = Outline(0.0, hem_y - drop)
        corner = front_corner if front else (half + widening + behind, hem_y + 0.5)
        if (shaping or hugs) and not front:
            seam = side_length(front_corner, (chest.front, under_y), shaping)
            corner = as_long(seam, corner, (half, under_y), shaping)
        outline.quadratic("hem", (corner[0] * 0.6, hem_y - drop), corner)
        draw_side(outline, (half, under_y), shaping, 0.0)
        low = max(base_y - (shape.dip if front else 0.0), hem_y - drop + SIDE_MINIMUM)
        draw_top_on_strap(outline, figure, shape.strap, base_y=base_y, low=low, lift=lift)
        outline.line("centre", *outline.sides[0].start).closed()
        table.lay(
            f"left_{side}torso",
            outline,
            label="body",
            at=(0.0, 0.0, FRONT_Z if front else BACK_Z),
            back=not front,
        )
    sew_torso(table)


def draw_top_on_strap(
    outline: Outline, figure: Figure, strap: float, *, base_y: float, low: float, lift: float
) -> None:
    """Draws from the underarm up to the strap, over the shoulder, and across to the middle.

    Args:
        outline: Ends at the underarm.
        figure: The body.
        strap: Width of the strap, cm.
        base_y: World height where the strap begins, cm.
        low: World height of the upper edge in the middle, cm.
        lift: By how much the strap is longer than the shoulder is high, cm.
    """
    middle_x = figure.neck_x + STRAP_PLACE * (figure.shoulder_x - figure.neck_x)
    middle_x = min(middle_x, figure.shoulder_x - strap)
    inner, outer = middle_x - strap / 2, middle_x + strap / 2
    x, y = outline.sides[-1].end
    outline.quadratic("armhole", (outer + 0.35 * (x - outer), y + 0.1), (outer, base_y))
    outline.line("armhole", outer, figure.shoulder_line(outer) + lift)
    outline.line("shoulder", inner, figure.shoulder_line(inner) + lift)
    outline.line("neck", inner, base_y)
    outline.quadratic("neck", (0.5 * inner, low), (TAKEN_IN, low))
