"""The trouser block: four legs' panels with shaped crotch, back darts and a slanted centre back."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

from swifttailor.errors import PatternError
from swifttailor.pattern.drafts.cutting_table import CuttingTable
from swifttailor.pattern.drafts.figure import Figure, Halves
from swifttailor.pattern.drafts.outline import Outline, Point
from swifttailor.pattern.drafts.side_seam import SHORTEST_SLIT
from swifttailor.pattern.drafts.suppression import Suppression, dart_places, suppress, waist_darts

FRONT_Z = 25.0
"""Where front leg panels stand before draping, cm."""
BACK_Z = -22.0
"""Where back leg panels stand before draping, cm."""
LEGS_APART_X = 0.5
"""Distance of the innermost points of legs from the middle before draping, cm."""
STEP = 1.2
"""At knee and below, the back is this much wider than half of the leg, the front this much narrower, cm."""

_MORE_STEP_CM = (0.0, 1.0, 2.0, 3.0, 4.0)
"""Tried where the inseams of front and back can't be equally long."""

NARROWEST = 0.4
"""Least width of the hem of slim legs over the girth of the thigh."""
CLOSE_REACH = 0.8
"""Of slim legs, which have less cloth at the thigh."""
FLARED_SIDE_SHARE, _FLARED_CM = 0.22, 16.0
"""Flares that narrow at the inseams alone are caught at the calves and tear; so much flare they have."""
SIDE_SHARE = 0.27
"""Slim legs narrow at the side seams as much as at the inseams, so that they hang around the calves."""
NARROWING_CM = -9.0
"""Wider legs whose hems are so much narrower than the knee do, too: else a calf catches them as they fall."""
NARROW_CM = 7.0
"""So do legs with less room at the hem: a calf catches them as they fall."""
_WIDE_HIPS_CM, _SHARE_PER_CM, _MOST_SHARE = 115.0, 0.006, 0.36
"""Hips from which side seams of narrowing legs run inward by more, by how much per cm, and at most."""
CLOSE_LEGS_CM = 3.5
"""Legs with less room than this lie close all the way down, as of jersey."""
SLANT = 2.0
"""Without darts the slant of the centre back takes no more than this, cm."""
ROOMY_CM = 10.0
"""Short legs with so much room have a straight inseam: hollowed out they would stand apart above the hems."""
SHORTEST_INSEAM = 4.0
"""Hem below the crotch at least, cm."""
_SLIT_SHARE = 0.6
"""Slits are no longer than this part of the side seam below the knee, or of short legs below the hips."""


@dataclass(frozen=True)
class Trousers:
    """How the legs are cut."""

    length: float
    """From the body's waist to the hem along the side, cm."""
    hip_ease: float
    """On top of the hip girth, cm around."""
    leg_ease: float
    """On top of the leg's girth at knee and hem, cm around."""
    flare: float
    """Extra width of the hem, cm around; negative narrows it."""
    crotch_drop: float
    """Crotch of the garment below the body's, cm."""
    narrowest: float = 0.55
    """Least width of the hem over the girth of the thigh."""
    reach: float = 1.0
    """How far front and back reach under the crotch, as a part of what roomy trousers have."""
    darts: bool = True
    """Whether darts take what the waist is narrower; else the side seams and the centre back do."""
    side_share: float = 0.18
    """Part of what the leg loses from thigh to knee that each side seam takes; the inseams take the rest."""
    of_bodice: bool = False
    """Whether they hang from a bodice."""
    bow: float = 0.0
    """How far each side seam bows outward between hip and knee, as that of jodhpurs, cm."""
    barrel: float = 0.0
    """How far each side seam stands out at the knee, as that of barrel legs, cm."""
    side_slit: float = 0.0
    """How far each side seam is open above the hem, cm."""


def legs_of_bodice(
    length: float, hip_ease: float, leg_ease: float, flare: float, crotch_drop: float
) -> Trousers:
    """Legs sewn to a bodice, measured as in `Trousers`; those with next to no room have no darts."""
    narrow = flare <= NARROWING_CM or leg_ease + flare < NARROW_CM
    share = SIDE_SHARE if narrow else FLARED_SIDE_SHARE if flare > _FLARED_CM else Trousers.side_share
    if leg_ease >= CLOSE_LEGS_CM:
        return Trousers(length, hip_ease, leg_ease, flare, crotch_drop, side_share=share, of_bodice=True)
    return Trousers(
        length,
        hip_ease,
        leg_ease,
        flare,
        crotch_drop,
        narrowest=NARROWEST,
        darts=False,
        reach=CLOSE_REACH,
        side_share=share,
        of_bodice=True,
    )


@dataclass(frozen=True)
class LegLines:
    """What front and back share: heights and the shape of the side seam, cm."""

    top_y: float
    hip_y: float
    crotch_y: float
    knee_y: float | None
    """None when the leg ends near or above the knee."""
    hem_y: float
    side_taken: float
    """What the side seam loses from hip to waist."""
    knee_width: float
    """Half of the leg's width around at the knee (or at the hem of short legs)."""
    hem_width: float
    side_shift: float
    """How far the side seam moves inward from hip to knee."""
    reach: tuple[float, float]
    """How far front and back reach under the crotch."""
    step: float
    """By how much the back of the hem is wider than half of the leg, and the front narrower."""
    bow: float
    """How far the side seam bows outward above the knee."""
    barrel: float
    """How far it stands out at the knee."""
    slit: float
    """How far it is open above the hem."""
    roomy: bool
    """Whether there is so much room that the inseam of short legs runs straight."""


def lay_trousers(table: CuttingTable, figure: Figure, shape: Trousers, waist: Halves, top_y: float) -> None:
    """Lays the left leg and sews its side, inseam and darts; see `sew_legs` for the rest.

    Edges of ``pant_f_l`` and ``pant_b_l``: hem, side, waist, centre, inseam, dart.

    Args:
        table: Where they go.
        figure: The body.
        shape: The cut.
        waist: Sewn half widths of the upper edge, cm.
        top_y: World height of the upper edge, cm.
    """
    hips = figure.hips.eased(shape.hip_ease)
    taken = suppress(hips, waist, 1.0, 3.5) if shape.darts else _without_darts(hips, waist)
    hips = taken.wide(waist)
    lines = _leg_lines(figure, shape, hips, taken, top_y)
    places = dart_places(figure, waist)
    for more in _MORE_STEP_CM:  # the shortest legs may need hems that are less even
        stepped = replace(lines, step=lines.step + more)
        front = _front(stepped, hips.front, waist.front, taken.front, places.front)
        back = _as_long(front, stepped, hips.back, waist.back, taken.back, places.back)
        if back is not None:
            break
    else:
        raise PatternError(
            f"No legs can be drafted with a front of {waist.front:.0f} cm and a back of {waist.back:.0f} cm "
            "at the upper edge on half of the body: their inseams would not fit each other. Change the room "
            "at waist or hips, or the length."
        )
    # The legs stand apart so far that the crotch points of both sides do not overlap.
    for name, outline, z in (("pant_f_l", front, FRONT_Z), ("pant_b_l", back, BACK_Z)):
        x = LEGS_APART_X - min(s.start[0] for s in outline.sides)
        table.lay(name, outline.closed(), label="leg", at=(x, 0.0, z), back=name == "pant_b_l")
    table.seam("pant_f_l.side", "pant_b_l.side")
    table.seam("pant_b_l.inseam", "pant_f_l.inseam")


def sew_legs(table: CuttingTable) -> None:
    """Sews the right legs to the left ones along centre front and centre back."""
    table.seam("pant_f_r.centre", "pant_f_l.centre")
    table.seam("pant_b_l.centre", "pant_b_r.centre")


def _leg_lines(figure: Figure, shape: Trousers, hips: Halves, taken: Suppression, top_y: float) -> LegLines:
    crotch_y = figure.crotch_y - shape.crotch_drop
    hem_y = min(figure.waist_y - shape.length, crotch_y - SHORTEST_INSEAM)
    knee_y = figure.knee_y if hem_y < figure.knee_y - 10.0 else None
    knee = figure.leg_girth(hem_y if knee_y is None else knee_y) + shape.leg_ease
    hem = figure.leg_girth(hem_y) + shape.leg_ease
    front_reach, back_reach = _reach(figure, shape.reach)
    front_thigh, back_thigh = hips.front + front_reach, hips.back + back_reach
    thigh = front_thigh + back_thigh
    wide = knee > thigh - 2.0
    knee = min(knee, thigh - 2.0)
    hem = max((knee if knee_y is None else hem) + shape.flare, shape.narrowest * figure.thigh)
    if wide and knee_y is not None:  # widens or narrows evenly all the way, as palazzos do
        knee = max(knee, thigh + (crotch_y - knee_y) / (crotch_y - hem_y) * (hem - thigh))
    # Short legs keep the thigh's division into a narrow front and a wide back; it evens out to the knee.
    near_thigh = min(max((hem_y - figure.knee_y) / (crotch_y - figure.knee_y), 0.0), 1.0)
    step = STEP + near_thigh * ((back_thigh - front_thigh) / 2 - STEP)
    return LegLines(
        top_y=top_y,
        hip_y=figure.hip_y,
        crotch_y=crotch_y,
        knee_y=knee_y,
        hem_y=hem_y,
        side_taken=taken.side,
        knee_width=(hem if knee_y is None else knee) / 2,
        hem_width=hem / 2,
        side_shift=_side_share(figure, shape) * (thigh - (hem if knee_y is None else knee)),
        reach=_reach(figure, shape.reach),
        step=step,
        bow=shape.bow if knee_y is not None else 0.0,
        barrel=shape.barrel if knee_y is not None else 0.0,
        slit=shape.side_slit if shape.side_slit >= SHORTEST_SLIT else 0.0,
        roomy=shape.leg_ease >= ROOMY_CM,
    )


def _side_share(figure: Figure, shape: Trousers) -> float:
    """Part of what the leg narrows that its side seam takes: more below wide hips, where legs run inward."""
    wider = max(figure.hips.girth - _WIDE_HIPS_CM, 0.0)
    if shape.flare > NARROWING_CM or shape.of_bodice:
        return shape.side_share
    return max(shape.side_share, min(shape.side_share + _SHARE_PER_CM * wider, _MOST_SHARE))


def _without_darts(wide: Halves, narrow: Halves) -> Suppression:
    """All that the waist is narrower, lost at the side seams and in the slant of the centre back."""
    total = max(wide.girth - narrow.girth, 0.0) / 2
    back = min(SLANT, total / 3)
    return Suppression((total - back) / 2, 0.0, back)


def _reach(figure: Figure, share: float) -> tuple[float, float]:
    """How far front and back reach under the crotch, cm."""
    return share * 0.052 * figure.hips.girth, share * 0.092 * figure.hips.girth


def _as_long(
    front: Outline, lines: LegLines, hip: float, waist: float, lost: float, place: float
) -> Outline | None:
    """The back leg that has its crotch point where its inseam is as long as the front's; None: nowhere."""
    inseam = sum(s.length for s in front.sides if s.name == "inseam")

    def excess(drop: float) -> float:
        back = _back(lines, hip, waist, lost, place, drop)
        return sum(s.length for s in back.sides if s.name == "inseam") - inseam

    from scipy.optimize import brentq

    lowest = lines.crotch_y - (lines.hem_y if lines.knee_y is None else lines.knee_y) - 1.0
    most = min(lowest, 12.0)
    if excess(-6.0) * excess(most) > 0:
        return None
    drop = brentq(excess, -6.0, most, xtol=1e-10)
    assert isinstance(drop, float)
    return _back(lines, hip, waist, lost, place, drop)


def _front(lines: LegLines, hip: float, waist: float, lost: float, place: float) -> Outline:
    outline = _leg_and_side(lines, hip, -lines.step)
    side_x = outline.sides[-1].end[0]
    end = (side_x - math.sqrt((waist + lost) ** 2 - _rise(lines) ** 2), lines.top_y)
    outline.darted_line("waist", end, waist_darts(waist, lost, place, 9.0))
    reach = lines.reach[0]
    outline.line("centre", 0.0, lines.hip_y)
    drop = lines.hip_y - lines.crotch_y
    outline.cubic(
        "centre",
        (0.0, lines.hip_y - 0.62 * drop),
        (-0.45 * reach, lines.crotch_y + 0.04 * drop),
        (-reach, lines.crotch_y),
    )
    return _inseam(outline, lines)


def _back(lines: LegLines, hip: float, waist: float, lost: float, place: float, drop: float) -> Outline:
    outline = _leg_and_side(lines, hip, lines.step)
    side_x, side_y = outline.sides[-1].end
    # Part of what the back loses goes into the slant of the centre back, which also rises for sitting.
    darts = lost - min(0.4 * lost, 3.2)
    darts = darts if darts >= 1.2 and lost > SLANT else 0.0
    raised = lines.top_y + 2.0
    length = waist + darts
    end = (side_x - math.sqrt(length**2 - (raised - side_y) ** 2), raised)
    outline.darted_line("waist", end, waist_darts(waist, darts, place, 0.55 * (lines.top_y - lines.hip_y)))
    reach = lines.reach[1]
    outline.line("centre", 0.0, lines.hip_y)
    low = lines.crotch_y - drop
    fall = lines.hip_y - low
    lean = end[0] / (raised - lines.hip_y)
    outline.cubic(
        "centre",
        (-lean * 0.6 * fall, lines.hip_y - 0.6 * fall),
        (-0.5 * reach, low + 0.02 * fall),
        (-reach, low),
    )
    return _inseam(outline, lines)


def _leg_and_side(lines: LegLines, hip: float, step: float) -> Outline:
    """Draws hem and side seam up to the waist; front and back side seams have the same shape."""
    knee_x = hip - lines.side_shift
    hem_x = knee_x + (lines.hem_width - lines.knee_width) / 2
    inner_hem = hem_x - lines.hem_width - step
    outline = Outline(inner_hem, lines.hem_y).line("hem", hem_x, lines.hem_y)
    below = lines.hem_y
    if lines.knee_y is not None:
        _side_below_knee(outline, knee_x + lines.barrel, lines.knee_y, lines.barrel, lines.slit)
        below = lines.knee_y
    elif lines.slit:
        below += min(lines.slit, _SLIT_SHARE * (lines.hip_y - below))
        outline.line("slit", hem_x, below)
    fall = lines.hip_y - below
    lean = (knee_x - hem_x) / max(below - lines.hem_y, 1.0) if lines.knee_y is not None else 0.0
    lean = 0.0 if lines.barrel else lean
    start = outline.sides[-1].end
    # Two controls moved alike move the middle of the curve by three quarters as much.
    out = lines.bow / 0.75
    outline.cubic(
        "side",
        (start[0] + lean * 0.3 * fall + 0.5 * out, below + 0.3 * fall),
        (hip + 1.5 * out, lines.hip_y - 0.35 * fall),
        (hip, lines.hip_y),
    )
    top = lines.top_y + _rise(lines)
    fall = top - lines.hip_y
    outline.cubic(
        "side",
        (hip, lines.hip_y + 0.4 * fall),
        (hip - 0.75 * lines.side_taken, top - 0.35 * fall),
        (hip - lines.side_taken, top),
    )
    return outline


def _side_below_knee(outline: Outline, x: float, y: float, barrel: float, slit: float) -> None:
    """Draws the side seam from the hem to a point at the knee, upright there where the leg is widest."""
    if slit:
        hem_x, hem_y = outline.at
        share = min(slit / math.dist((x, y), (hem_x, hem_y)), _SLIT_SHARE)
        outline.line("slit", hem_x + share * (x - hem_x), hem_y + share * (y - hem_y))
    if not barrel:
        outline.line("side", x, y)
        return
    hem_x, hem_y = outline.sides[-1].end
    rise = y - hem_y
    outline.cubic("side", (hem_x + 0.4 * (x - hem_x), hem_y + 0.3 * rise), (x, y - 0.4 * rise), (x, y))


def _inseam(outline: Outline, lines: LegLines) -> Outline:
    """Draws from the crotch point over the knee back to the hem."""
    x, y = outline.sides[-1].end
    hem: Point = outline.sides[0].start
    if lines.knee_y is None and lines.roomy:
        return outline.line("inseam", *hem)
    if lines.knee_y is None:
        return outline.quadratic("inseam", (0.75 * hem[0] + 0.25 * x, y - 0.45 * (y - hem[1])), hem)
    knee = (hem[0] + (lines.hem_width - lines.knee_width) / 2, lines.knee_y)
    fall = y - knee[1]
    lean = (hem[0] - knee[0]) / (knee[1] - hem[1])
    upper = (x + 0.4 * (knee[0] - x), y - 0.3 * fall)
    outline.cubic("inseam", upper, (knee[0] - lean * 0.35 * fall, knee[1] + 0.35 * fall), knee)
    return outline.line("inseam", *hem)


def _rise(lines: LegLines) -> float:
    """How much the waist rises from the middle to the side, cm."""
    return min(0.8, 0.25 * max(lines.side_taken, 0.0))
