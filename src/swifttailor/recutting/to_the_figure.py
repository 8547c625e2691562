"""Measures brought to the figures that are asked for: 120 cm around the hem is not 126.8.

A claim with a number holds while its measure is near it, so cutting stops there. Where a lever leads nearer,
without harm to anything that holds, it is moved on; what is still off can be told by `figures_missed`.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace

from swifttailor.describing.differences import Change, Gain
from swifttailor.describing.dimensions import QUANTITIES
from swifttailor.describing.facts import GarmentFacts
from swifttailor.describing.measuring import measure_facts
from swifttailor.errors import SwiftTailorError
from swifttailor.recutting.alter import Alteration
from swifttailor.recutting.set_dimension import set_dimension
from swifttailor.recutting.unasked import spoken_parts, unasked

NEAR_CM = 1.0
"""What is nearer to a figure than this is as it is asked for."""
_SAME_CM = 0.1
_PIECES = frozenset({"tiers", "gores", "godets"})
_QUANTITY_OF = {
    how.claim: name
    for name, quantity in QUANTITIES.items()
    if (how := quantity.stated) is not None and name not in _PIECES
}


def to_the_figures(
    done: Alteration,
    wishes: Sequence[Change],
    original: GarmentFacts,
    kept: Collection[str] = (),
) -> Alteration:
    """An alteration with measures moved on to the figures that are asked for, where that harms nothing.

    Args:
        done: What has come of altering.
        wishes: What is asked for.
        original: Of the garment before; steps are counted from it.
        kept: Claims and quantities that are to stay.
    """
    parts = spoken_parts(wishes)
    for wish in wishes:
        figure = _figure(wish, original)
        if figure is None or wish in done.open:
            continue
        quantity, value = figure
        now = _measured(quantity, done.facts)
        if now is None or abs(now - value) <= NEAR_CM:
            continue
        try:
            pattern, said = set_dimension(done.pattern, quantity, value)
            facts = measure_facts(pattern)
        except SwiftTailorError:
            continue
        after = _measured(quantity, facts)
        held = [w for w in wishes if w not in done.open]
        changed = len(unasked(parts, original, facts, kept)) > len(unasked(parts, original, done.facts, kept))
        nearer = said and after is not None and abs(after - value) < abs(now - value)
        if nearer and not changed and all(w.holds(original, facts) for w in held):
            done = replace(done, pattern=pattern, facts=facts, cuts=(*done.cuts, said))
    return done


def figures_missed(wishes: Sequence[Change], original: GarmentFacts, facts: GarmentFacts) -> list[Change]:
    """What holds roughly and is off the figure that is asked for by more than a centimetre.

    Args:
        wishes: What is asked for.
        original: Of the garment before.
        facts: Of what it has become.
    """
    found = []
    for wish in wishes:
        figure = _figure(wish, original)
        now = None if figure is None else _measured(figure[0], facts)
        if figure is not None and now is not None and abs(now - figure[1]) > NEAR_CM:
            found.append(wish)
    return found


def _measured(quantity: str, facts: GarmentFacts) -> float | None:
    """What a figure is compared with; None where sides differ, or it is not said of such a garment."""
    how, own = QUANTITIES[quantity].stated, QUANTITIES[quantity].of(facts)
    if how is None or how.of is None or own is None:
        return own
    said = how.of(facts)
    return own if said is not None and abs(said - own) < _SAME_CM else None


def _figure(wish: Change, original: GarmentFacts) -> tuple[str, float] | None:
    """The measure that a wish has a figure for, and where that is to end; None where it has none."""
    if isinstance(wish, Gain):
        quantity = _QUANTITY_OF.get(wish.claim.name)
        return None if quantity is None or isinstance(wish.claim.value, str) else (quantity, wish.claim.value)
    was = QUANTITIES[wish.quantity].of(original)
    if wish.amount is None or was is None or wish.quantity in _PIECES or not QUANTITIES[wish.quantity].in_cm:
        return None
    return wish.quantity, was + wish.direction * wish.amount
