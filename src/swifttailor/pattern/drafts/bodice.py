"""The loose torso block: fronts and backs without darts, for t-shirts, tops and hoodies."""

from __future__ import annotations

from dataclasses import dataclass

from swifttailor.pattern.drafts.armholes import RACER_NECK, armhole, leaning_tip, racer_armhole
from swifttailor.pattern.drafts.back_hollow import BackHollow, back_hollow, draw_centre_back
from swifttailor.pattern.drafts.bust_dart import draw_side_with_bust_dart
from swifttailor.pattern.drafts.cutting_table import CuttingTable
from swifttailor.pattern.drafts.figure import Figure, Halves
from swifttailor.pattern.drafts.hem_dart import darted_half, draw_darted_hem, hem_dart
from swifttailor.pattern.drafts.hem_room import WOVEN, HemRoom
from swifttailor.pattern.drafts.neckline import Neckline, draw_bare_back, draw_neckline
from swifttailor.pattern.drafts.outline import Outline, Point
from swifttailor.pattern.drafts.side_seam import (
    OPEN_SHARE,
    SHORTEST_SLIT,
    SIDE_MINIMUM,
    as_long,
    curve_as_long,
    draw_curve,
    draw_side,
    runs_back,
    side_length,
)

FRONT_Z = 30.0
"""Where front torso panels stand before draping, cm."""
BACK_Z = -25.0
"""Where back torso panels stand before draping, cm."""
FRONT_BALANCE = 0.6
"""Part of the front's extra length over the bust that a loose garment has at neck and shoulder; with more,
necklines stand off."""
HEM_BALANCE = 0.45
"""Part of it that a garment without shoulders has at the centre front of its hem."""
LOOSE_HEM_BALANCE = 0.6
"""The same of a loose garment that hangs from its shoulders."""
_STRAP = 3.5
"""How much cloth is left beside a back that is bare, at the shoulder blades, cm."""
_CROPPED_CM = 6.0
"""What ends less far below the waist hangs from the bust, and has all of that there."""
BLADE_FULLNESS, RACER_FULLNESS = 0.01, -0.02
"""Extra length of the back over the shoulder blades, over the waist line; with more, the nape stands off."""
SHORT_CM = 12.0
"""Shaped tops that end less far below the waist have no room to widen again."""
POINT_X = 5.0
"""Distance of the point of a pointed front hem from the middle, cm."""
_LEVEL_TO, _LEVEL_FROM = 0.55, 0.72
"""As parts of the way to the side, controls of a hem that is level in the middle and again at the side."""
_ABOVE_SEAT_CM = 6.0
"""What ends less far below the waist does not reach the seat; from twice that on it does."""
_LONGEST_TOP_CM, _TAPER = 42.0, 0.75
"""Up to where wide tops narrow to the hem, and by which part of their room at the chest."""
_LEAST_CURVE = 6.0
"""Between bends of a side seam that follows the body, cm."""
_FOLLOWING_EASE = 1.0
"""Room of such a torso at waist and hips, over the body as its cloth is cut for it, cm around."""
_BELOW_HIPS_CM = 8.0
"""What follows the body ends at least so far below the hips: tops do not, for their hems would climb up the
seat, and cloth gather above it."""
_TO_THE_KNEE = 0.07
"""By which part of the hips' girth it is narrower at the knees, between which cloth lies together."""


@dataclass(frozen=True)
class LooseBodice:
    """How the loose block is cut."""

    neckline: Neckline
    chest_ease: float
    """On top of the bust girth, cm around."""
    length: float
    """Hem below the waist, cm."""
    armhole_drop: float
    """Underarm point below the armpit, cm."""
    hip_ease: float = 4.0
    """Least ease at the hem over the body there, cm around."""
    flare: float = 0.0
    """Extra width at the hem, cm around."""
    shoulder_extension: float = 0.0
    """Armhole seam beyond (positive) or inside (negative) the shoulder tip, cm."""
    waist_shaping: float = 0.0
    """How far each side seam bends inward between underarm and hem, cm."""
    hem_room: HemRoom = WOVEN
    front_point: float = 0.0
    """How far the front hem falls to a point beside the middle, cm."""
    front_slit: float = 0.0
    """Length of the lower end of the centre front that is left open, cm."""
    front_opening: float = 0.0
    """How far the edge of an open front has moved back from the middle at the hem, cm; negative for fronts
    that `overlap_fronts` lays over each other."""
    front_closed_to: float | None = None
    """How far below the waist a front that opens is sewn together, cm; instead of `front_slit`."""
    side_slits: float = 0.0
    """Length of the lower end of straight side seams that is left open, cm."""
    back_slit: float = 0.0
    """Length of the lower end of the centre back that is left open, cm."""
    side_rise: float = 0.0
    """How far the hem rises to the side seams in curves, as a shirt's, cm; with no points in front."""
    back_dip: float = 0.0
    """How much lower the hem is in the middle of the back than at the side seams, cm."""
    follows: bool = False
    """Whether the side seams follow waist and hips, as cloth that stretches can; `waist_shaping` is then how
    far they may bend inward."""
    racer: bool = False
    """Whether the back is cut in between the shoulder blades, so that its straps run together there."""
    darted: bool = False
    """Whether what ends at the waist and has `waist_shaping` has darts to the bust, and is taken in by others
    from the hem."""


def shoulder_tip_x(
    figure: Figure, neckline: Neckline, extension: float, chest: Halves | None = None
) -> float:
    """Distance of the armhole's upper end from the middle; at least 3 cm of shoulder remain, cm.

    Args:
        figure: The body.
        neckline: Where the shoulder begins.
        extension: Beyond the shoulder tip, cm.
        chest: Half widths at the underarm, beyond which no shoulder reaches; those of the body when None.
    """
    chest = chest or figure.bust
    widest = figure.shoulder_x + min(extension, min(chest.front, chest.back) - figure.shoulder_x)
    return max(widest, neckline.start_x(figure) + 3.0)


def lay_loose_bodice(table: CuttingTable, figure: Figure, shape: LooseBodice) -> None:
    """Lays and sews both fronts and backs; call before `CuttingTable.mirror` lays the right-hand ones.

    Edges of ``left_ftorso`` and ``left_btorso``: hem, side, armhole, shoulder, neck, centre.
    """
    chest = figure.bust.eased(max(shape.chest_ease, 0.0))
    hem_y = figure.waist_y - shape.length
    follows = shape.follows and hem_y < figure.hip_y - _BELOW_HIPS_CM
    under_y = max(figure.armpit_y - shape.armhole_drop, hem_y + SIDE_MINIMUM)
    short = shape.waist_shaping > 0.0 and shape.length < SHORT_CM
    body = figure.girth_below_waist(shape.length).eased(shape.hip_ease)
    if short and shape.follows:
        body = ribs_at(figure, hem_y).eased(_FOLLOWING_EASE)
    widening = max(body.girth - chest.girth, 0.0) / 4 if shape.length > 0 else 0.0
    shaping = shape.waist_shaping
    darted = shape.darted and short and not (follows or shape.side_slits or shape.side_rise)
    if short:  # what ends at the waist narrows down to it
        widening = min(max((body.girth - chest.girth) / 4, -shaping), widening)
        shaping = 0.0
    elif shaping and not follows:  # bent sides are narrower above the hem, and the seat holds them up
        least = body.girth + shape.hem_room.per_shaping * shaping - chest.girth
        widening = least / 4 if shape.hem_room.narrows else max(widening, least / 4)
    if follows:
        shaping = 0.0
        widening = _half_at(figure, shape, hem_y).girth / 4 - chest.girth / 4
    elif not (short or shape.waist_shaping or shape.flare):
        widening = max(widening - _taper(shape), (body.girth - chest.girth) / 4)
    widening += shape.flare / 4
    rise = _hem_rise(max(widening, 0.0), under_y - hem_y, chest.girth / 4 + widening)
    tip_x = shoulder_tip_x(figure, shape.neckline, shape.shoulder_extension, chest)
    neck_x = shape.neckline.start_x(figure)
    slit = shape.front_slit
    if shape.front_closed_to is not None:
        slit = max(shape.length - shape.front_closed_to, 0.0) if shape.front_opening else 0.0
    on_seat = min(max((shape.length - _ABOVE_SEAT_CM) / _ABOVE_SEAT_CM, 0.0), 1.0)
    on_seat = 1.0 if short and shape.follows else on_seat  # below the bust the front needs less
    if shape.front_opening < 0.0:  # fronts that lie over each other would stand out in front
        on_seat = 0.0
    behind = on_seat * runs_back(chest, body, widening, under_y - hem_y)
    room = chest.girth - 4 * shaping - figure.waist.girth
    hollow = None if short or follows else back_hollow(figure.waist_y, shaping=shape.waist_shaping, room=room)
    length, followed = None, None
    for side, half in (("f", chest.front), ("b", chest.back)):
        front = side == "f"
        hem_x = half + widening + (-behind if front else behind)
        hem_x = max(hem_x, darted_half(figure, shape.length, front=front)) if darted else hem_x
        balance = LOOSE_HEM_BALANCE if shape.length > _CROPPED_CM else 1.0
        drop = balance * figure.front_fullness if front and not darted else 0.0
        if not front and not darted:
            drop = shape.back_dip
        start = max(shape.front_opening, 0.0) if front else 0.0
        curved = shape.side_rise > 0.0
        hem_end = min(hem_y + rise + shape.side_rise, under_y - SIDE_MINIMUM) if curved else hem_y + rise
        corner, underarm = (hem_x, hem_end), (half, under_y)
        along = None
        if follows:
            along = _along_body(figure, shape, corner, underarm, front=front)
            along = along if followed is None else curve_as_long(followed, along)
            followed, corner = along, along[0]
        elif length is None:
            length = side_length(corner, underarm, shaping)
        else:
            corner = as_long(length, corner, underarm, shaping)
        outline = Outline(start, hem_y - drop)
        dart = hem_dart(figure, shape.length, (start, hem_x), under_y, front=front) if darted else None
        if front and shape.front_point:
            outline.line("hem", POINT_X, hem_y - drop - shape.front_point)
        if dart is not None:
            draw_darted_hem(outline, corner, dart)
        elif front and shape.front_point:
            outline.line("hem", *corner)
        elif curved:
            across = (start + _LEVEL_TO * (hem_x - start), hem_y - drop)
            outline.cubic("hem", across, (start + _LEVEL_FROM * (hem_x - start), corner[1]), corner)
        elif abs(corner[1] - hem_y) + drop > 0.01:
            level = max(hem_x * 0.6, start + 0.2 * (hem_x - start))  # wide openings start beyond
            outline.quadratic("hem", (level, hem_y - drop), corner)
        else:
            outline.line("hem", *corner)
        if along is not None:
            draw_curve(outline, along)
        elif darted and front:  # or the front would stand away below the bust
            draw_side_with_bust_dart(outline, figure, underarm)
        else:
            draw_side(outline, underarm, shaping, shape.side_slits)
        scoop = 0.72 if front else 0.5
        shoulder = (neck_x, tip_x)
        lay_torso_half(
            table,
            figure,
            outline,
            shape.neckline,
            shoulder,
            front=front,
            balance=FRONT_BALANCE,
            scoop=scoop,
            slit=slit if front else shape.back_slit,
            blade=RACER_FULLNESS if shape.racer else BLADE_FULLNESS,
            racer=shape.racer and not front,
            hollow=None if front else hollow,
        )
    sew_torso(table)


def _taper(shape: LooseBodice) -> float:
    """How much narrower a very wide top is at its hem than at the chest, cm for each half."""
    top = 0.0 < shape.length <= _LONGEST_TOP_CM
    wide = max(_TAPER * (shape.chest_ease - shape.hem_room.wide), 0.0)
    return min(wide, shape.hem_room.most_taper) / 4 if top else 0.0


def follows_body(stretch: float, waist_shaping: float, armhole: str = "set-in") -> bool:
    """Whether a torso with these options follows the body: one whose cloth stretches and that has a waist."""
    return stretch > 0.0 and waist_shaping > 0.0 and armhole != "cut-in-one"


def ribs_at(figure: Figure, y: float) -> Halves:
    """Half widths of the body between bust and waist, where it narrows fast below the bust, or below, cm."""
    above = min(max((y - figure.waist_y) / (figure.bust_y - figure.waist_y), 0.0), 1.0) ** 2
    below = figure.girth_below_waist(figure.waist_y - y)
    return Halves(
        (1.0 - above) * below.front + above * figure.bust.front,
        (1.0 - above) * below.back + above * figure.bust.back,
    )


def _half_at(figure: Figure, shape: LooseBodice, y: float) -> Halves:
    """Half widths at height `y` of a torso that follows the body, cm: low down more of it lies behind."""
    above = min(max((y - figure.waist_y) / (figure.bust_y - figure.waist_y), 0.0), 1.0)
    chest = figure.bust.eased(shape.chest_ease)
    below_waist = figure.girth_below_waist(figure.waist_y - y)
    body = below_waist.girth + above * (figure.bust.girth - figure.waist.girth)
    below = min(max((figure.hip_y - y) / (figure.hip_y - figure.knee_y), 0.0), 1.0)
    body *= 1.0 - _TO_THE_KNEE * below
    quarter = max((body + _FOLLOWING_EASE) / 4, chest.girth / 4 - shape.waist_shaping)
    at_chest, at_body = (one.front - one.girth / 4 for one in (chest, below_waist))
    forward = above * at_chest + (1.0 - above) * at_body
    return Halves(quarter + forward, quarter - forward)


def _along_body(
    figure: Figure, shape: LooseBodice, hem: Point, underarm: Point, *, front: bool
) -> list[Point]:
    """Points of a side seam that follows the body, from the hem up, the underarm among them.

    Args:
        figure: The body.
        shape: The torso.
        hem: Where it begins.
        underarm: Where it ends.
        front: Of the front, or of the back.
    """
    points = [hem]
    for level in (figure.hip_y, figure.waist_y):
        if hem[1] < level - _LEAST_CURVE and level < underarm[1] - _LEAST_CURVE:
            half = _half_at(figure, shape, level)
            points.append((half.front if front else half.back, level))
    return [*points, underarm]


def lay_torso_half(
    table: CuttingTable,
    figure: Figure,
    outline: Outline,
    neckline: Neckline,
    shoulder: tuple[float, float],
    *,
    front: bool,
    balance: float,
    scoop: float,
    slit: float = 0.0,
    blade: float = BLADE_FULLNESS,
    racer: bool = False,
    hollow: BackHollow | None = None,
) -> None:
    """Draws the upper end of a left front or back, and lays it.

    Args:
        table: Where it goes.
        figure: The body.
        outline: Drawn from the lower end of the centre to the underarm.
        neckline: Its shape in front; it is round behind.
        shoulder: Distances of both ends of the shoulder seam from the middle, neck first, cm.
        front: Or back.
        balance: Length of the front over the back, as a part of the body's extra length there.
        scoop: Of the armhole.
        slit: Length of the lower end of the centre that is left open, cm; less where the centre is short.
        blade: Extra length of the back over the shoulder blades, as a part of the waist line.
        racer: Whether the armhole is cut in between the shoulder blades.
        hollow: How the middle of a back is drawn in; None where it is straight.
    """
    lift = balance * figure.front_fullness if front else blade * (figure.neck_y - figure.waist_y)
    neck, tip = ((x, figure.shoulder_line(x) + lift) for x in shoulder)
    underarm = outline.sides[-1].end[1]
    if racer:
        tip = leaning_tip(neck, tip)
        racer_armhole(outline, tip, figure.slope)
    else:
        armhole(outline, tip, figure.slope, scoop)
    outline.line("shoulder", *neck)
    fall = figure.neck_y + lift - neck[1]
    depth = (neckline.fall_in_front if front else neckline.back_depth) - fall
    low = outline.sides[0].start
    if racer:  # above where the straps run together
        depth = min(depth, RACER_NECK * (tip[1] - underarm))
    if not front and neckline.bares_back and not racer:
        draw_bare_back(outline, neck, depth, shoulder[1] - _STRAP)
    else:
        depth = max(min(depth, neck[1] - low[1] - SIDE_MINIMUM), 0.5)
        draw_neckline(outline, neck, depth, figure.slope, neckline.shape if front else "round")
    slit = min(slit, OPEN_SHARE * (outline.sides[-1].end[1] - low[1]))
    if slit >= SHORTEST_SLIT:
        outline.line("centre", outline.sides[-1].end[0], low[1] + slit).line("slit", *low)
    elif hollow is not None:
        draw_centre_back(outline, low, hollow)
    else:
        outline.line("centre", *low)
    outline.closed()
    table.lay(
        "left_ftorso" if front else "left_btorso",
        outline,
        label="body",
        at=(0.0, 0.0, FRONT_Z if front else BACK_Z),
        back=not front,
    )


def sew_torso(table: CuttingTable) -> None:
    """Sews sides and shoulders of the left half and labels its armhole and neckline."""
    table.seam("left_ftorso.side", "left_btorso.side")
    table.seam("left_ftorso.shoulder", "left_btorso.shoulder")
    for panel in ("left_ftorso", "left_btorso"):
        table.label(f"{panel}.armhole", "left_armhole")
        table.label(f"{panel}.neck", "left_collar")


def sew_centres(table: CuttingTable) -> None:
    """Sews the right half to the left one along centre front and centre back."""
    table.seam("right_ftorso.centre", "left_ftorso.centre")
    table.seam("left_btorso.centre", "right_btorso.centre")


def _hem_rise(widening: float, side: float, hem_x: float) -> float:
    """How much the hem rises at the side so that it meets the slanted side seam at a right angle, cm."""
    return min(0.5 * hem_x * widening / max(side, 1.0) * 0.8, 0.25 * side, 4.0)
