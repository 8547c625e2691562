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
)
from swifttailor.pattern.drafts.crossed_straps import (
    TAKEN_IN,
    draw_top_below_strap,
    lay_crossed_strap,
    sew_torso_on_straps,
    strap_at,
)
from swifttailor.pattern.drafts.cutting_table import CuttingTable
from swifttailor.pattern.drafts.figure import Figure, Halves
from swifttailor.pattern.drafts.hem_dart import HemDart, draw_darted_hem
from swifttailor.pattern.drafts.outline import Outline
from swifttailor.pattern.drafts.side_seam import as_long, draw_side, runs_back, side_length

OVER_BUST = 8.5
"""Height of the front's upper corners over the fullest part of the bust, cm."""
OVER_UNDERARM = 1.0
"""Height of the back's upper corners over the underarm, cm."""
STRAP_LIFT = 0.4
"""Part of the front's extra length over the bust that the straps have."""
_HIP_CM, _SHAPED_HIP_CM = 6.0, 2.0
"""Least room over the body at the hem, cm around; of sides that bend in, besides what they lose above it."""
_ON_RIBS_CM, _MOST_FLARE_CM = 1.5, 4.0
"""Room on the ribs of what ends above the waist, cm around; hems with more flare than that hang free."""
_DARTS_CM, _DART_SHARE, _DART_BELOW_CM = (4.5, 3.0), 0.75, 2.5
"""The widest dart in front and behind, cm; the part of what is to be taken in that darts take; and how far
below the bust, and behind below the underarm, they end."""
_LOWEST_DART_CM, _LEAST_DART_CM, _ASIDE = 4.0, 1.0, 0.46
"""Height of the lowest dart and width of the least one, cm; where that of the back is, as a part of the way
to the side."""
_STEEPEST = 0.3
"""How far aside a side seam may run over how far it runs down."""


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
    crossed: bool = False
    """Whether the straps cross behind."""


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
    ends = {True: chest.front + widening - behind, False: chest.back + widening + behind}
    darts: dict[bool, HemDart | None] = {True: None, False: None}
    draws_in = shape.length < 0.0 and not hugs and shape.flare <= _MOST_FLARE_CM
    if draws_in:
        body = ribs_at(figure, hem_y).eased(_ON_RIBS_CM)
        for front in darts:
            darts[front], ends[front] = _drawn_in(figure, chest, body, hem_y, under_y, front=front)
    front_corner = (ends[True], hem_y + 0.5)
    for side, half in (("f", chest.front), ("b", chest.back)):
        front = side == "f"
        drop = HEM_BALANCE * figure.front_fullness if front else 0.0
        lift = STRAP_LIFT * figure.front_fullness if front else 0.0
        base_y = figure.bust_y + OVER_BUST if front else under_y + OVER_UNDERARM
        base_y = max(base_y, under_y + 0.5)
        outline = Outline(0.0, hem_y - drop)
        corner, dart = (ends[front], hem_y + 0.5), darts[front]
        if (shaping or hugs or draws_in) and not front:
            seam = side_length(front_corner, (chest.front, under_y), shaping)
            corner = as_long(seam, corner, (half, under_y), shaping)
        if dart is not None:
            draw_darted_hem(outline, corner, dart)
        else:
            outline.quadratic("hem", (corner[0] * 0.6, hem_y - drop), corner)
        draw_side(outline, (half, under_y), shaping, 0.0)
        low = max(base_y - (shape.dip if front else 0.0), hem_y - drop + SIDE_MINIMUM)
        if shape.crossed and not front:
            draw_top_below_strap(outline, figure, shape.strap, base_y)
            lay_crossed_strap(table, figure, shape.strap, base_y)
        else:
            draw_top_on_strap(outline, figure, shape.strap, base_y=base_y, low=low, lift=lift)
        outline.line("centre", *outline.sides[0].start).closed()
        table.lay(
            f"left_{side}torso",
            outline,
            label="body",
            at=(0.0, 0.0, FRONT_Z if front else BACK_Z),
            back=not front,
        )
    sew_torso_on_straps(table, crossed=shape.crossed)


def _drawn_in(
    figure: Figure, chest: Halves, body: Halves, hem_y: float, under_y: float, *, front: bool
) -> tuple[HemDart | None, float]:
    """The dart of a half whose hem lies on the ribs, and how far from the middle its hem ends, cm.

    Args:
        figure: The body.
        chest: Half widths at the underarm.
        body: Half widths of the sewn hem.
        hem_y: Height of the hem.
        under_y: Height of the underarm.
        front: Of the front, or of the back.
    """
    half, own = (chest.front, body.front) if front else (chest.back, body.back)
    room = max(half - own, 0.0)
    tip_y = (figure.bust_y if front else under_y) - _DART_BELOW_CM
    width = min(_DART_SHARE * room, _DARTS_CM[0 if front else 1])
    slant = min(room - width, _STEEPEST * (under_y - hem_y))
    end = half - slant
    if width < _LEAST_DART_CM or tip_y - hem_y < _LOWEST_DART_CM:
        return None, half - min(room, _STEEPEST * (under_y - hem_y))
    return HemDart(figure.bust_x if front else _ASIDE * end, width, tip_y), end


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
    inner, outer = strap_at(figure, strap)
    x, y = outline.sides[-1].end
    outline.quadratic("armhole", (outer + 0.35 * (x - outer), y + 0.1), (outer, base_y))
    outline.line("armhole", outer, figure.shoulder_line(outer) + lift)
    outline.line("shoulder", inner, figure.shoulder_line(inner) + lift)
    outline.line("neck", inner, base_y)
    outline.quadratic("neck", (0.5 * inner, low), (TAKEN_IN, low))
