"""Levers of slits: opened, closed, made higher or lower."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from swifttailor.describing.facts import GarmentFacts, Place, Slit
from swifttailor.describing.measuring.hems import place_of
from swifttailor.describing.measuring.parts import SKIRT_PARTS
from swifttailor.pattern import EdgeRef, Pattern
from swifttailor.recutting.levers.lever import Lever, Trick, of_dimension
from swifttailor.recutting.table.cutter import Cutter
from swifttailor.recutting.ways.slits import close_slits, open_middle, open_side, reach_slit

_PLACES: tuple[Place, ...] = ("left", "right", "back", "front")
_WORDS: dict[Place, str] = {"left": "left", "right": "right", "back": "behind", "front": "in front"}
_WEDGE_CM, _MOST_JOINTS = 12.0, 6
LEAST_SLIT_CM = 3.0
"""Shorter ones are not opened again."""
_SHORTEST_CM, _CROTCH_CM = 6.0, 38.0
"""The lowest slit that is cut, and how far below the waist one in the middle ends at the highest, cm."""
_CLAIMS = ("slit", "slit_cm", "slit_size", *(f"{p} slit" for p in _PLACES))


def slit_sides(cutter: Cutter, place: Place | None = None) -> list[tuple[EdgeRef, EdgeRef]]:
    """The two sides of every slit, or of those in one place."""
    anatomy = cutter.anatomy
    cloth, hem = anatomy.cloth, set(cutter.hem)
    tops: dict[int, list[EdgeRef]] = {}
    for ref in anatomy.hem.edges if anatomy.hem else ():
        if ref in hem:
            continue
        ends = cloth.samples[ref][[0, -1]]
        top = ends[np.argmax(cutter.worn.level[cloth.node[ends]])]
        if place is None or place_of(cloth.world[top]) == place:
            tops.setdefault(int(cloth.node[top]), []).append(ref)
    return [(refs[0], refs[1]) for refs in tops.values() if len(refs) == 2]


def closed(cutter: Cutter, place: Place | None = None) -> Pattern | None:
    """The pattern with its slits closed; None where there are none.

    Of a seam with joints what is open below one meets only once what is above it is closed.
    """
    shut = None
    for _ in range(_MOST_JOINTS):
        sides = slit_sides(cutter, place)
        if not sides:
            break
        shut = close_slits(cutter.pattern, sides)
        steep = len(cutter.anatomy.hem.edges) - len(cutter.hem) if cutter.anatomy.hem else 0
        if steep <= 2 * len(sides):
            break
        cutter = cutter.with_pattern(shut)
    return shut


def recut_closed(
    cutter: Cutter, recut: Callable[[Cutter], Pattern | None], *, first: bool = True
) -> Pattern | None:
    """Recuts a skirt; where its slits are in the way, with them closed, and opens them again.

    Args:
        cutter: The pattern.
        recut: What is done.
        first: Whether to try it with open slits first.
    """
    edited = recut(cutter) if first or not _slits(cutter.facts) else None
    shut = closed(cutter) if edited is None else None
    edited = edited if shut is None else recut(cutter.with_pattern(shut))
    if edited is None or shut is None:
        return edited
    for slit in _slits(cutter.facts):
        if slit.height < LEAST_SLIT_CM:
            continue
        after = cutter.with_pattern(edited)
        edited = open_slit(after, slit.place, slit.height, max(slit.width, 2.0))
        if edited is None:
            return None
    return edited


def open_slit(cutter: Cutter, place: Place, height: float, width: float) -> Pattern | None:
    """Opens a slit of some height and width at the hem, cm."""
    hem = cutter.hem_of(*SKIRT_PARTS)
    if not hem:
        return None
    if place in ("left", "right"):
        return open_side(cutter.pattern, hem, height, place)
    return open_middle(cutter.pattern, hem, height, "front" if place == "front" else "back", width)


def _slits(facts: GarmentFacts) -> tuple[Slit, ...]:
    return facts.skirt.slits if facts.skirt else ()


def _with_slits(facts: GarmentFacts, slits: tuple[Slit, ...]) -> GarmentFacts:
    return replace(facts, skirt=replace(facts.skirt, slits=slits)) if facts.skirt else facts


def _lever(place: Place, wedge: bool = False) -> Lever:
    of = of_dimension(f"{place} slit")

    def imagine(facts: GarmentFacts, height: float) -> GarmentFacts:
        others = tuple(s for s in _slits(facts) if s.place != place)
        width = _WEDGE_CM if wedge else 0.0
        return _with_slits(facts, (*others, Slit(place, height, width)))

    def cut(cutter: Cutter, amount: float) -> Pattern | None:
        height = amount + (of(cutter.facts) or 0.0)
        sides = slit_sides(cutter, place)
        if len(sides) == 1 and not wedge:
            reached = reach_slit(cutter.pattern, sides[0], height)
            if reached is not None:
                return reached
        shut = closed(cutter, place) if of(cutter.facts) else None
        now = cutter if shut is None else cutter.with_pattern(shut)
        return open_slit(now, place, height, _WEDGE_CM if wedge else 2.0)

    def span(facts: GarmentFacts) -> tuple[float, float]:
        skirt = facts.skirt
        if skirt is None:
            return 0.0, 0.0
        last = (skirt.length - skirt.base_length) / (skirt.tiers - 1) if skirt.tiers > 1 else skirt.length
        most = 0.8 * last
        if place in ("front", "back"):  # in the middle, one up to the crotch would show what it should not
            most = min(most, max(skirt.length - _CROTCH_CM, _SHORTEST_CM))
        return _SHORTEST_CM, most

    return Lever(
        name=f"slit {_WORDS[place]}{', a wedge,' if wedge else ''}",
        serves=(f"{place} slit", "slits"),
        stage=7,
        of=of,
        imagine=imagine,
        cut=cut,
        span=span,
        words=("higher", "lower"),
        natural=24.0,
        only_for=_CLAIMS,
    )


def _closing(place: Place | None) -> Trick:
    def imagine(facts: GarmentFacts) -> GarmentFacts | None:
        left = tuple(s for s in _slits(facts) if place is not None and s.place != place)
        return _with_slits(facts, left) if len(left) < len(_slits(facts)) else None

    return Trick(
        name="slits closed" if place is None else f"slit {_WORDS[place]} closed",
        stage=1,
        imagine=imagine,
        cut=lambda cutter: closed(cutter, place),
        only_for=("slit",) if place is None else ("slit", f"{place} slit"),
    )


SLIT_LEVERS: tuple[Lever, ...] = (
    *(_lever(place) for place in _PLACES),
    _lever("back", wedge=True),
    _lever("front", wedge=True),
)
SLIT_TRICKS: tuple[Trick, ...] = tuple(_closing(place) for place in (None, *_PLACES))
