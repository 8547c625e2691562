"""Slits that are seen: over a leg in front, or with the front cut away aslant beside a side seam.

The two sides of an open seam hang beside each other, and nobody would know that it is open.
"""

from __future__ import annotations

from dataclasses import replace

from swifttailor.pattern import EdgeRef, Line, Pattern
from swifttailor.recutting.levers.slits import closed, slit_sides
from swifttailor.recutting.table.cutter import Cutter
from swifttailor.recutting.table.workbench import Workbench
from swifttailor.recutting.ways.slits import cut_wedge

_OVER_LEG_CM, _WIDEST_CM = 13.0, 23.0
"""How far from the middle of the front a slit over a leg is, and how wide at most."""
_PART, _OF_HEM = 0.45, 0.3
"""How much is cut away at the hem at most, as a part of the height of the slit, and of the front's hem."""
_BOTH_PART, _FRONT_PART = 0.3, 0.3
"""The same beside each of two slits, and in the middle of the front."""
_MUCH_LOWER = 0.6
"""A slit of less than so much of the height of another was not asked for."""
_HIGHEST_UNSEEN_CM = 18.0
"""Lower ones are vents, and stay as they are."""
_LEAST_CM, _JOINTS = 1.0, 3
"""Shorter edges are not cut; no seam has more joints."""


def parted_slit(pattern: Pattern) -> Pattern | None:
    """The pattern with its one high slit in a side seam parted at the hem; None where it has no such.

    Args:
        pattern: Of a dress or skirt.
    """
    cutter = Cutter(pattern)
    slits = [] if cutter.facts.skirt is None else cutter.facts.skirt.slits
    if len(slits) != 1 or slits[0].height < _HIGHEST_UNSEEN_CM or slits[0].place not in ("left", "right"):
        return None
    pairs = slit_sides(cutter, slits[0].place)
    if len(pairs) != 1 or pairs[0][0].panel == pairs[0][1].panel:
        return None
    front = max(pairs[0], key=lambda ref: float(cutter.pattern.panel(ref.panel).normal()[2]))
    hem = sum(cutter.pattern.edge_length(ref) for ref in cutter.hem if ref.panel == front.panel)
    return _cut_away(cutter.pattern, front, min(_PART * slits[0].height, _OF_HEM * hem))


def parted_sides(pattern: Pattern) -> Pattern | None:
    """The pattern with its front cut away beside slits in both side seams; None where it has no such.

    Args:
        pattern: Of a dress or skirt.
    """
    cutter = Cutter(pattern)
    slits = () if cutter.facts.skirt is None else cutter.facts.skirt.slits
    if sorted(slit.place for slit in slits) != ["left", "right"]:
        return None
    done = None
    for slit in slits:
        pairs = slit_sides(cutter, slit.place)
        if len(pairs) != 1 or pairs[0][0].panel == pairs[0][1].panel:
            continue
        front = max(pairs[0], key=lambda ref: float(cutter.pattern.panel(ref.panel).normal()[2]))
        hem = sum(cutter.pattern.edge_length(ref) for ref in cutter.hem if ref.panel == front.panel)
        cut = _cut_away(cutter.pattern, front, min(_BOTH_PART * slit.height, _OF_HEM / 2 * hem))
        if cut is not None:
            done, cutter = cut, cutter.with_pattern(cut)
    return done


def parted_front(pattern: Pattern) -> Pattern | None:
    """The pattern with the high slit in the middle of its front cut as a wedge; None where it has none.

    Args:
        pattern: Of a dress or skirt.
    """
    cutter = Cutter(pattern)
    slits = () if cutter.facts.skirt is None else cutter.facts.skirt.slits
    high = [slit for slit in slits if slit.place == "front" and slit.height >= _HIGHEST_UNSEEN_CM]
    width = _FRONT_PART * high[0].height if high else 0.0
    if len(high) != 1 or high[0].width >= width:
        return None
    more = (width - high[0].width) / 2
    for k in (0, 1):
        pairs = slit_sides(cutter, "front")
        cut = _cut_away(cutter.pattern, pairs[0][k], more) if len(pairs) == 1 else None
        if cut is None:
            return None
        cutter = cutter.with_pattern(cut)
    return cutter.pattern


def slit_over_leg(pattern: Pattern) -> Pattern | None:
    """The pattern with its one high slit in a side seam cut into the front instead, a wedge over that leg.

    A much lower one is sewn shut.

    Args:
        pattern: Of a dress or skirt.

    Returns:
        The pattern; None where it has no such slit, or its front is not one panel there.
    """
    cutter = Cutter(pattern)
    slits = [] if cutter.facts.skirt is None else cutter.facts.skirt.slits
    first, *others = sorted(slits, key=lambda slit: -slit.height) or [None]
    if first is None or first.height < _HIGHEST_UNSEEN_CM or first.place not in ("left", "right"):
        return None
    if any(slit.height > _MUCH_LOWER * first.height for slit in others):
        return None
    shut = _all_closed(cutter)
    if shut is None:
        return None
    cutter = cutter.with_pattern(shut)
    x = _OVER_LEG_CM if first.place == "left" else -_OVER_LEG_CM
    height = first.height
    bench = Workbench(cutter.pattern)
    for ref in cutter.hem:
        if float(cutter.pattern.panel(ref.panel).normal()[2]) <= 0.0:
            continue
        # Of a wide skirt more falls together again.
        most = max(_WIDEST_CM, _OF_HEM * cutter.pattern.edge_length(ref))
        if cut_wedge(bench, bench.at[ref], height, min(_PART * height, most), x=x):
            return bench.pattern()
    return None


def _all_closed(cutter: Cutter) -> Pattern | None:
    """The pattern with its slits closed; one over a joint in a seam is so in two steps."""
    shut = closed(cutter)
    for _ in range(_JOINTS):
        again = None if shut is None else closed(cutter.with_pattern(shut))
        if again is None:
            break
        shut = again
    return shut


def _cut_away(pattern: Pattern, ref: EdgeRef, width: float) -> Pattern | None:
    """A free side of a front, its lower end moved along the hem by a width, cm."""
    bench = Workbench(pattern)
    side = bench.at[ref]
    world = bench.piece_of(side).panel.to_world(bench.piece_of(side).chord(side))
    step = 1 if float(world[1, 1]) < float(world[0, 1]) else -1
    if bench.partner(side) is not None:
        return None
    while width > _LEAST_CM:
        hem = bench.neighbour(side, step)
        length = bench.piece_of(hem).length(hem)
        if bench.partner(hem) is not None or len(bench.piece_of(hem).sides) < 4:
            return None
        if length > width + _LEAST_CM:
            second = bench.split(hem, width / length if step > 0 else 1.0 - width / length)
            hem = hem if step > 0 else second
        if step < 0:
            bench.side(side).start = bench.side(hem).start
        bench.drop(hem)
        width -= length
    bench.side(side).edge = replace(bench.side(side).edge, curve=Line())
    return bench.pattern()
