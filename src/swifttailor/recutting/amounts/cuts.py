"""Cuts by given amounts: lengths, widths, bands; each returns None where the pattern does not allow it."""

from __future__ import annotations

from collections.abc import Sequence

from swifttailor.describing.measuring.anatomy import Border
from swifttailor.describing.measuring.parts import (
    LOWER_PARTS,
    SKIRT_PARTS,
    UPPER_PARTS,
    Face,
    Part,
    Side,
)
from swifttailor.describing.measuring.shoulders import sleeves_carry_shoulders
from swifttailor.describing.measuring.skirts import skirt_rows, upper_edges
from swifttailor.pattern import EdgeRef, Pattern
from swifttailor.recutting.table.checking import SEAM_TOLERANCE
from swifttailor.recutting.table.cutter import Cutter
from swifttailor.recutting.ways.bands import BandPlan, add_band
from swifttailor.recutting.ways.ends import move_ends, swing_sides
from swifttailor.recutting.ways.fullness import let_out_darts, widen_panels
from swifttailor.recutting.ways.over_hips import widen_below
from swifttailor.recutting.ways.removal import WAIST_LABEL, remove_panels

STEEPEST_SIDE, STEEPEST_GORE = 0.25, 0.6
"""How far a side seam of a skirt, or every seam of a gored one, is turned: cm at the hem for 1 of length."""
OVER_HIPS = 1.05
"""Girth over that of the body, between waist and hips, that slides over it."""
_BETWEEN_DARTS_CM = 0.3
MOST_LET_OUT = 1.6
"""Of a band."""
_FACES: tuple[Face, Face] = ("front", "back")
_SIDES: tuple[Side, Side] = ("left", "right")


def free_hem(cutter: Cutter) -> tuple[EdgeRef, ...]:
    """The hem of a skirt, dress or top that ends without a band."""
    return cutter.hem_of(*SKIRT_PARTS) or cutter.hem_of(Part.TORSO)


def lengthen_hem(cutter: Cutter, distance: float) -> Pattern | None:
    """Moves the hem of a skirt, dress or top down, cm; that of a top stays as wide where hips pass it."""
    hem = free_hem(cutter)
    if not hem:
        return None
    if not _falls_straight(cutter, distance):
        return move_ends(cutter.pattern, hem, distance)
    # With what is open beside it, which stays as high as it is.
    around = {ref for loop in cutter.anatomy.loops(Border.HEM) for ref in loop.edges}
    lower = [ref for ref in cutter.anatomy.free_edges(Part.TORSO) if ref in around]
    return move_ends(cutter.pattern, lower, distance, upright=True) or move_ends(
        cutter.pattern, hem, distance
    )


def _falls_straight(cutter: Cutter, distance: float) -> bool:
    """Whether what a top is made longer by may hang straight down: nobody walks in that below the knees."""
    hem, body = cutter.facts.hem, cutter.facts.body
    if distance <= 0 or hem is None or not cutter.hem_of(Part.TORSO) or cutter.facts.kind != "top":
        return False
    level = hem.level - distance
    return level > body.knee and hem.length >= OVER_HIPS * _girth_at(cutter, level)


def _girth_at(cutter: Cutter, level: float) -> float:
    """Of the body at a height below the waist, cm; that of the hips below them."""
    figure = cutter.anatomy.figure
    down = (figure.waist_y - level) / max(figure.waist_y - figure.hip_y, 1.0)
    return figure.waist.girth + min(max(down, 0.0), 1.0) * (figure.hips.girth - figure.waist.girth)


def lengthen_over_hips(cutter: Cutter, distance: float) -> Pattern | None:
    """Moves the hem of a top down, cm, and makes what is added wide enough for the hips."""
    free = free_hem(cutter) if cutter.hem_of(Part.TORSO) and distance > 0 else ()
    # Between darts that are drawn on little is left until they are closed again.
    longer = move_ends(cutter.pattern, free, distance, least=_BETWEEN_DARTS_CM) if free else None
    if longer is None or cutter.facts.hem is None:
        return None
    after = cutter.with_pattern(longer)
    hem = free_hem(after)
    # What is closer above, at the waist, stays so.
    girth = _girth_at(after, cutter.facts.hem.level - distance)
    missing = OVER_HIPS * girth - sum(map(longer.edge_length, hem))
    if not hem or missing <= 0:
        return None
    return widen_below(longer, hem, missing, distance)


def lengthen_legs(cutter: Cutter, distance: float) -> Pattern | None:
    """Moves the ends of both legs, cuffs along with them, cm."""
    free = cutter.ends_of(Part.TROUSER, Border.LEG)
    ends = free or cutter.anatomy.seam(Part.TROUSER, Part.LEG_CUFF).own
    cuffs = () if free else cutter.names(Part.LEG_CUFF)
    return move_ends(cutter.pattern, ends, distance, cuffs) if ends else None


def lengthen_sleeves(cutter: Cutter, distance: float, sides: Sequence[Side] = _SIDES) -> Pattern | None:
    """Moves the ends of the sleeves, cuffs along with them, cm."""
    pattern, done = cutter.pattern, False
    for side in sides:
        sleeves = {p.name for p in cutter.anatomy.panels(Part.SLEEVE, side)}
        cuffs = [p.name for p in cutter.anatomy.panels(Part.CUFF, side)]
        free = [r for r in cutter.ends_of(Part.SLEEVE, Border.ARM) if r.panel in sleeves]
        ends = free or cutter.anatomy.seam(Part.SLEEVE, Part.CUFF, side).own
        if not ends:
            continue
        moved = move_ends(pattern, ends, distance, cuffs)
        if moved is None:
            return None
        pattern, done = moved, True
    return pattern if done else None


def lengthen_cuffs(cutter: Cutter, distance: float, part: Part = Part.CUFF) -> Pattern | None:
    """Moves the free ends of the cuffs of sleeves or legs, cm."""
    ends = cuff_ends(cutter, part)
    return move_ends(cutter.pattern, ends, distance) if ends else None


def cuff_ends(cutter: Cutter, part: Part) -> tuple[EdgeRef, ...]:
    """Free ends of the cuffs of sleeves or legs."""
    return cutter.ends_of(part, Border.ARM if part is Part.CUFF else Border.LEG)


def widen_cuffs(cutter: Cutter, width: float, part: Part = Part.CUFF) -> Pattern | None:
    """Flares the cuffs: each end of each of their side seams moves out, cm."""
    ends = cuff_ends(cutter, part)
    return swing_sides(cutter.pattern, ends, width) if ends else None


def raise_band(cutter: Cutter, distance: float) -> Pattern | None:
    """Makes the waistband or hem band higher, cm; what hangs from it moves down."""
    hem = cutter.hem_of(Part.WAISTBAND)
    if hem:
        return move_ends(cutter.pattern, hem, distance)
    below = cutter.anatomy.seam(Part.WAISTBAND, LOWER_PARTS)
    if not below.pairs:
        return None
    return move_ends(cutter.pattern, below.own, distance, cutter.names(*LOWER_PARTS))


def lengthen_bodice(cutter: Cutter, distance: float) -> Pattern | None:
    """Moves the lower edge of the bodice down, all below it along with it, cm."""
    lower = cutter.anatomy.seam(Part.TORSO, {Part.WAISTBAND} | LOWER_PARTS)
    if not lower.pairs:
        return None
    carried = cutter.names(Part.WAISTBAND, *LOWER_PARTS)
    return move_ends(cutter.pattern, lower.own, distance, carried)


def lengthen_with_band(cutter: Cutter, distance: float) -> Pattern | None:
    """Moves the band of a top down, cm; where it would be too tight to lie there, it is let out."""
    band, torso = cutter.facts.waistband, cutter.facts.torso
    longer = lengthen_bodice(cutter, distance) if distance > 0 else None
    if longer is None or band is None or torso is None:
        return None
    figure = cutter.anatomy.figure
    low = torso.lower_level - distance - band.height
    needed = OVER_HIPS * figure.girth_below_waist(max(figure.waist_y - low, 0.0)).girth
    factor = needed / max(min(band.upper, band.lower), 1.0)
    if not 1.0 < factor <= MOST_LET_OUT:
        return None
    after = cutter.with_pattern(longer)
    wider = widen_panels(longer, after.names(Part.WAISTBAND), factor)
    short = needed - torso.lower_edge
    if wider is None or short <= 0.0:
        return wider
    final = cutter.with_pattern(wider)
    seam = final.anatomy.seam(Part.TORSO, Part.WAISTBAND).own
    return swing_sides(wider, seam, short / 4, steepest=0.4) if seam else None


def is_gored(cutter: Cutter) -> bool:
    """Whether a skirt has more than front, back and one more panel."""
    return len(cutter.names(Part.SKIRT)) > 3


def flare_hem(cutter: Cutter, width: float) -> Pattern | None:
    """Turns the side seams of a skirt or top, all seams of a gored one: their ends move out, cm."""
    hem, gored = free_hem(cutter), is_gored(cutter)
    steepest = STEEPEST_GORE if gored else STEEPEST_SIDE
    return swing_sides(cutter.pattern, hem, width, all_seams=gored, steepest=steepest) if hem else None


def flare_legs(cutter: Cutter, width: float) -> Pattern | None:
    """Turns the side seams of the legs: their lower ends move out, cm."""
    ends = cutter.ends_of(Part.TROUSER, Border.LEG)
    return swing_sides(cutter.pattern, ends, width) if ends else None


def flare_sleeves(cutter: Cutter, width: float) -> Pattern | None:
    """Turns the seams of the sleeves: their lower ends move out, cm."""
    ends = cutter.ends_of(Part.SLEEVE, Border.ARM)
    return swing_sides(cutter.pattern, ends, width) if ends else None


def skirt_gather(cutter: Cutter) -> float | None:
    """How much a skirt is gathered into what it hangs from; None where that cannot change."""
    _, seam = upper_edges(cutter.anatomy, Part.SKIRT)
    if not seam.pairs or cutter.anatomy.darts(Part.SKIRT) or cutter.anatomy.has(Part.GODET):
        return None
    return seam.gather


def gather_skirt(cutter: Cutter, factor: float) -> Pattern | None:
    """Makes a skirt that hangs from a seam wider by a factor, so that more of it is gathered in."""
    gather = skirt_gather(cutter)
    if gather is None or not 0.99 <= gather * factor <= 2.8:
        return None
    names = cutter.names(Part.SKIRT)
    rows = skirt_rows(cutter.anatomy)
    whole = widen_panels(cutter.pattern, names, factor)
    if whole is not None or max(rows.values(), default=0) == 0:
        return whole
    first = [n for n in names if rows.get(n) == 0]
    edited = widen_panels(cutter.pattern, first, factor, keep_lower=True)
    return edited if edited is not None and _tiers_fit(cutter, edited) else None


def _tiers_fit(cutter: Cutter, edited: Pattern) -> bool:
    """Whether the rows of a skirt are sewn to each other as before."""
    names = set(cutter.names(Part.SKIRT))
    now = cutter.with_pattern(edited).seam_ratios
    return all(
        abs(now[pair] / ratio - 1.0) <= SEAM_TOLERANCE
        for pair, ratio in cutter.seam_ratios.items()
        if set(pair) <= names
    )


def let_out_skirt(cutter: Cutter) -> Pattern | None:
    """Takes the darts out of a skirt that hangs from a seam; their cloth is gathered into it."""
    if not upper_edges(cutter.anatomy, Part.SKIRT)[1].pairs:
        return None
    return let_out_darts(cutter.pattern, cutter.names(Part.SKIRT))


def remove_parts(cutter: Cutter, *parts: Part) -> Pattern | None:
    """Takes off all panels of some parts, where there are any of the first and nothing hangs from them."""
    if not cutter.anatomy.has(parts[0]):
        return None
    if Part.SLEEVE in parts and sleeves_carry_shoulders(cutter.anatomy):
        return None
    return remove_panels(cutter.pattern, cutter.names(*parts))


def _two_parts(cutter: Cutter) -> bool:
    return cutter.anatomy.has(Part.TORSO) and any(cutter.anatomy.has(p) for p in LOWER_PARTS)


def remove_lower(cutter: Cutter) -> Pattern | None:
    """Leaves the upper part of a dress or jumpsuit."""
    return remove_panels(cutter.pattern, cutter.names(*LOWER_PARTS)) if _two_parts(cutter) else None


def remove_upper(cutter: Cutter) -> Pattern | None:
    """Leaves the skirt of a dress or the trousers of a jumpsuit."""
    return remove_panels(cutter.pattern, cutter.names(*UPPER_PARTS)) if _two_parts(cutter) else None


def remove_sleeve(cutter: Cutter, side: Side) -> Pattern | None:
    """Takes one of two sleeves off, where shoulders are no part of them."""
    if sleeves_carry_shoulders(cutter.anatomy):
        return None
    names = [p.name for p in cutter.anatomy.panels((Part.SLEEVE, Part.CUFF), side)]
    both = all(cutter.anatomy.panels(Part.SLEEVE, s) for s in _SIDES)
    return remove_panels(cutter.pattern, names) if names and both else None


def remove_band(cutter: Cutter) -> Pattern | None:
    """Takes the waistband off; only where nothing hangs on both sides of it."""
    anatomy = cutter.anatomy
    between = (
        anatomy.seam(Part.WAISTBAND, Part.TORSO).pairs and anatomy.seam(Part.WAISTBAND, LOWER_PARTS).pairs
    )
    if between or not anatomy.has(Part.WAISTBAND):
        return None
    return remove_panels(cutter.pattern, cutter.names(Part.WAISTBAND))


def add_cuffs(
    cutter: Cutter, height: float, share: float = 1.0, flare: float = 1.0, *, upper: Part = Part.SLEEVE
) -> Pattern | None:
    """Sews cuffs or flounces to the sleeves or legs.

    Args:
        cutter: The pattern.
        height: Of the cuffs, cm.
        share: Length of a cuff over that of the end it is sewn to; more where hand or leg need it.
        flare: Length of its free edge over its sewn one.
        upper: Sleeve or trouser.
    """
    lower, border = (Part.CUFF, Border.ARM) if upper is Part.SLEEVE else (Part.LEG_CUFF, Border.LEG)
    ends = cutter.ends_of(upper, border)
    if not ends or cutter.anatomy.has(lower):
        return None
    plans = [
        BandPlan(cuff_name(name), tuple(r for r in ends if r.panel == name))
        for name in dict.fromkeys(r.panel for r in ends)
    ]
    length = sum(map(cutter.pattern.edge_length, ends))
    body = cutter.anatomy.body
    least = 2 * (1.25 * body.wrist if upper is Part.SLEEVE else 0.5 * body.leg_circ)
    share = max(share, min(1.0, least / length))
    return add_band(cutter.pattern, plans, height, share=share, flare=flare)


def add_hem_band(cutter: Cutter, height: float, share: float = 1.0) -> Pattern | None:
    """Sews a band to the hem of a top; `share` is its length over that of the hem."""
    hem = cutter.hem_of(Part.TORSO)
    if not hem or cutter.anatomy.has(Part.WAISTBAND):
        return None
    length = sum(map(cutter.pattern.edge_length, hem))
    share = max(share, min(1.0, cutter.anatomy.body.waist / length))
    return add_band(cutter.pattern, _front_and_back(cutter, hem), height, share=share)


def add_waistband(cutter: Cutter, height: float) -> Pattern | None:
    """Sews a waistband to a skirt or trousers."""
    anatomy = cutter.anatomy
    if anatomy.has(Part.TORSO) or anatomy.has(Part.WAISTBAND):
        return None
    top = upper_edges(anatomy, Part.TROUSER if anatomy.has(Part.TROUSER) else Part.SKIRT)[0]
    if not top:
        return None
    return add_band(cutter.pattern, _front_and_back(cutter, top), height, label=WAIST_LABEL)


def cuff_name(upper: str) -> str:
    """GarmentCode's name of the cuff panel below a sleeve or leg panel; a like name for other makers'."""
    parts = upper.split("_")
    if len(parts) == 3 and parts[1] == "sleeve":
        return f"sl_{parts[0]}_cuff_{parts[2]}"
    if len(parts) == 3 and parts[0] == "pant":
        return f"pant_{parts[2]}_cuff_{parts[1]}"
    return f"{upper}_cuff"


def _front_and_back(cutter: Cutter, edges: Sequence[EdgeRef]) -> list[BandPlan]:
    parts = cutter.anatomy.parts
    plans = [BandPlan(f"wb_{f}", tuple(r for r in edges if parts[r.panel].face == f)) for f in _FACES]
    return [p for p in plans if p.edges]
