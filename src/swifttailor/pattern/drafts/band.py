"""Waistbands, hem bands and cuffs."""

from __future__ import annotations

from swifttailor.pattern.drafts.cutting_table import CuttingTable, turned
from swifttailor.pattern.drafts.figure import ANKLE_X_PER_HIPS, Figure, Halves
from swifttailor.pattern.drafts.joins import sew_sides
from swifttailor.pattern.drafts.outline import Outline, Side, annular_sector

CONTOUR = 0.2
"""Part of the body's widening below the waist that a waistband follows; a fully shaped one slides down."""
LOWEST_YOKE_CM, _YOKE_EASE_CM = 6.0, 2.0
"""What is lower is a waistband; and the room of a yoke at its lower edge, cm around."""
BAND_FRONT_Z = 24.0
"""Where front bands stand before draping, cm."""
BAND_BACK_Z = -20.0
"""Where back bands stand before draping, cm."""
LEG_CUFF_GAP = 2.0
"""Between a leg and its cuff before draping, cm."""
LEG_CUFF_FRONT_Z, LEG_CUFF_BACK_Z = 17.0, -20.0
"""Where the cuffs of legs stand before draping, cm: near the ankles, so that they close around them."""
_LEAST_RISE_CM, _RISING = 0.5, (0.3, 0.7)
"""What rises less behind is level, cm; where along it the controls of the risen edge are."""
_ABOVE_HIPS_CM = 1.5
"""The lowest bands of legs end so far above the hips."""
_LOWEST_CUFF_CM, _CUFF_EASE_CM = 1.0, 3.0
"""Cuffs of jumpsuits' legs: how high the lowest are, and their room, cm."""


def lay_waist_band(
    table: CuttingTable, upper: Halves, lower: Halves, height: float, top_y: float, *, at_waist: bool
) -> None:
    """Lays ``wb_front`` and ``wb_back`` and sews their sides.

    Edges: bottom, left_side, top, right_side.

    Args:
        table: Where they go.
        upper: Half widths of the upper edge, cm.
        lower: Half widths of the lower edge; wider than the upper ones for a band shaped to the body, cm.
        height: Height of the band, cm.
        top_y: World height of the upper edge, cm.
        at_waist: Whether the upper edge sits at the waist (it is then labelled for attachment).
    """
    for name, above, below in (
        ("wb_front", upper.front, lower.front),
        ("wb_back", upper.back, lower.back),
    ):
        front = name == "wb_front"
        outline = annular_sector("top", 2 * above, 2 * max(below, above), height, top_y)
        z = BAND_FRONT_Z if front else BAND_BACK_Z
        table.lay(name, outline, label="body", at=(0.0, 0.0, z), back=not front)
        if at_waist:
            table.label(f"{name}.top", "lower_interface")
    sew_sides(table, "wb")


def band_below_waist(figure: Figure, below_waist: float, height: float) -> float:
    """How far below the waist the upper edge of a band of legs is, cm: its lower edge stays above the hips.

    Args:
        figure: The body.
        below_waist: As far as is asked for, cm.
        height: Of the band, cm.
    """
    return min(below_waist, max(figure.waist_y - figure.hip_y - height - _ABOVE_HIPS_CM, 0.0))


def lay_body_waist_band(
    table: CuttingTable,
    figure: Figure,
    height: float,
    ease: float,
    below_waist: float = 0.0,
    back_rise: float = 0.0,
) -> Halves:
    """Lays a waistband shaped to the body, its upper edge at the waist or some centimetres below it.

    Args:
        table: Where it goes.
        figure: The body.
        height: Of the band at its sides, cm.
        ease: On top of the body's girth, cm around.
        below_waist: How far below the waist the upper edge is, cm; above it below 0.
        back_rise: How much higher it is in the middle of the back, cm.

    Returns:
        Half widths of its lower edge, cm: what is sewn to it.
    """
    girth = (
        figure.girth_below_waist(below_waist) if below_waist >= 0 else figure.girth_above_waist(-below_waist)
    )
    upper = girth.eased(ease)
    below = figure.girth_below_waist(below_waist + height).eased(ease)
    lower = Halves(
        upper.front + CONTOUR * max(below.front - upper.front, 0.0),
        upper.back + CONTOUR * max(below.back - upper.back, 0.0),
    )
    lay_waist_band(table, upper, lower, height, figure.waist_y - below_waist, at_waist=True)
    if back_rise >= _LEAST_RISE_CM:
        _raise_behind(table, back_rise)
    return lower


def lay_yoke_or_band(
    table: CuttingTable, figure: Figure, yoke: float, height: float, ease: float
) -> tuple[Halves, float]:
    """Lays a yoke that follows waist and hips where there is to be one, else a waistband.

    Args:
        table: Where it goes.
        figure: The body.
        yoke: Height of the yoke, cm; less than `LOWEST_YOKE_CM` is none.
        height: Of the waistband, cm.
        ease: On top of the body's girth at the waist, cm around.

    Returns:
        Half widths of its lower edge, and its height, cm.
    """
    if yoke < LOWEST_YOKE_CM:
        return lay_body_waist_band(table, figure, height, ease), height
    upper = figure.waist.eased(ease)
    below = figure.girth_below_waist(yoke).eased(ease + _YOKE_EASE_CM)
    lower = Halves(max(below.front, upper.front), max(below.back, upper.back))
    lay_waist_band(table, upper, lower, yoke, figure.waist_y, at_waist=True)
    return lower, yoke


def _raise_behind(table: CuttingTable, rise: float) -> None:
    """Bends the upper edge of the back waistband up, so that it is so much higher in the middle, cm."""
    piece = table.pieces["wb_back"]
    (top,) = piece.find("top")
    start, end = top.start, top.end
    level = start[1] + (rise + _sag(top)) / 0.75  # two controls move the middle by three quarters as much
    edge = Outline(*start)
    controls = [(start[0] + share * (end[0] - start[0]), level) for share in _RISING]
    edge.cubic("top", controls[0], controls[1], end)
    piece.sides[piece.sides.index(top)] = edge.sides[0]
    table.label("wb_back.top", "lower_interface")


def _sag(edge: Side) -> float:
    """By how much the middle of an edge lies above its ends, cm; less than 0 where it lies below."""
    return edge.split([0.5])[0].end[1] - (edge.start[1] + edge.end[1]) / 2


def lay_sleeve_cuff(
    table: CuttingTable, figure: Figure, at: float, ease: float, height: float, *, flare: float = 0.0
) -> None:
    """Lays the left cuff below the left sleeve and sews it on; the sleeve may be gathered into it.

    Edges of ``sl_left_cuff_f`` and ``sl_left_cuff_b``: under, end, top, join.

    Args:
        table: Must already hold the left sleeve.
        figure: Gives the arm's girth.
        at: Where the cuff begins, from the shoulder along the arm, cm.
        ease: Room on top of the arm's girth there, cm; the cuff is no wider than the sleeve's end, and split
            like it.
        height: Along the arm, cm.
        flare: How much wider each half is at its end, above and below the arm each, cm.
    """
    start = table.pieces["left_sleeve_f"].find("hem")[0].end[0] + 4.0
    total = table.length("left_sleeve_f.hem", "left_sleeve_b.hem")
    width = min(figure.arm_girth(at) + ease, total)
    for side in "fb":
        half = width * table.length(f"left_sleeve_{side}.hem") / total
        # Cut as a piece of a ring, whose free edge is as far from the seam everywhere.
        end, bent = start + height - 0.35 * flare, start + height + 0.3 * flare
        outline = Outline(start, -half).line("under", end, -half - flare)
        if flare:
            outline.cubic("end", (bent, -half - 0.3 * flare), (bent, 0.3 * flare), (end, flare))
        else:
            outline.line("end", end, 0.0)
        outline.line("top", start, 0.0).line("join", start, -half)
        name = f"sl_left_cuff_{side}"
        sleeve = table.pieces[f"left_sleeve_{side}"].placement
        table.lay(
            name,
            turned(outline.closed(), -90.0),
            label="arm",
            at=sleeve.translation,
            rotation=(0.0, 0.0, 90.0 + sleeve.rotation[2]),
            back=side == "b",
        )
        table.seam(f"left_sleeve_{side}.hem", f"{name}.join", gathered=True)
    table.seam("sl_left_cuff_f.top", "sl_left_cuff_b.top")
    table.seam("sl_left_cuff_f.under", "sl_left_cuff_b.under")


def lay_leg_cuff(table: CuttingTable, figure: Figure, ease: float, height: float) -> None:
    """Lays the left leg's cuff below it and sews it on; the leg may be gathered into it.

    Edges of ``pant_l_cuff_f`` and ``pant_l_cuff_b``: end, outer, join, inner.

    Args:
        table: Must already hold the left leg.
        figure: Gives the leg's girth.
        ease: Room on top of the leg's girth where the cuff ends, cm; the cuff is no wider than the leg's
            hem, and split like it.
        height: Of the cuff, cm.
    """
    total = table.length("pant_f_l.hem", "pant_b_l.hem")
    hem_y = table.pieces["pant_f_l"].find("hem")[0].end[1]
    width = min(figure.close_leg_girth(hem_y - height) + ease, total)
    for side in "fb":
        leg, name = f"pant_{side}_l", f"pant_l_cuff_{side}"
        (hem,) = table.pieces[leg].find("hem")
        half = width * hem.length / total / 2
        outline = Outline(-half, hem_y - height).line("end", half, hem_y - height)
        outline.line("outer", half, hem_y).line("join", -half, hem_y).line("inner", -half, hem_y - height)
        ankle = ANKLE_X_PER_HIPS * figure.hips.girth
        z = LEG_CUFF_FRONT_Z if side == "f" else LEG_CUFF_BACK_Z
        at = (ankle, -LEG_CUFF_GAP, z)
        table.lay(name, outline.closed(), label="leg", at=at, back=side == "b")
        table.seam(f"{leg}.hem", f"{name}.join", gathered=True)
    table.seam("pant_l_cuff_f.outer", "pant_l_cuff_b.outer")
    table.seam("pant_l_cuff_f.inner", "pant_l_cuff_b.inner")


def lay_gathering_leg_cuff(table: CuttingTable, figure: Figure, height: float) -> None:
    """Lays a cuff that the left leg of a jumpsuit is gathered into; none where `height` is 0, cm."""
    if height >= _LOWEST_CUFF_CM:
        lay_leg_cuff(table, figure, _CUFF_EASE_CM, height)
