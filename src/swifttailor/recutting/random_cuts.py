"""Random cuts: the levers that `alter` pulls, drawn by chance, for patterns to learn editing from."""

from __future__ import annotations

import random
from collections.abc import Callable, Iterator, Mapping
from typing import TypeVar

from swifttailor.describing.dimensions import DIMENSIONS
from swifttailor.errors import SwiftTailorError
from swifttailor.recutting.levers.all_levers import LEVERS, TRICKS
from swifttailor.recutting.levers.lever import Lever, Trick
from swifttailor.recutting.table.checking import accepted
from swifttailor.recutting.table.cutter import Cutter

Way = Lever | Trick
T = TypeVar("T")

TRIES = 3
"""Of each topic, with other ways or amounts."""
_LEAST_STEPS = 4.0
"""By how many steps of a lever a measure is moved at least that is no dimension."""
_SHORTER = 1.5
"""Exponent: small changes are drawn more often than large ones."""


def topic_of(way: Way) -> str:
    """What a way is about: a dimension, or a claim where it is about none."""
    first = way.serves[0] if isinstance(way, Lever) else way.only_for[0]
    return first.split(":")[0]


_NOT_DRAWN = frozenset({"sides", "waistband width"})
"""What hardly any pattern allows, or nobody sees at once: drawing it would only change what is drawn for all
the others."""
WAYS: Mapping[str, Way] = {way.label: way for way in (*TRICKS, *LEVERS) if topic_of(way) not in _NOT_DRAWN}
"""All that can be drawn, by label."""
TOPICS: Mapping[str, tuple[Way, ...]] = {
    topic: tuple(way for way in WAYS.values() if topic_of(way) == topic)
    for topic in dict.fromkeys(map(topic_of, WAYS.values()))
}
"""By what they are about; each topic is as likely as any other. Listed in docs/edits.md."""


def recut_variously(
    cutter: Cutter,
    rng: random.Random,
    use: Callable[[Way, Cutter], T | None],
    *,
    topics: Mapping[str, tuple[Way, ...]] = TOPICS,
) -> Iterator[T]:
    """Recuts a pattern about one topic after the other, each tried a few times with other ways or amounts.

    Args:
        cutter: The pattern.
        rng: Decides order, ways and amounts.
        use: Makes something of what is left; of nothing, or what is empty, there is another try.
        topics: Ways to choose from.

    Yields:
        What was made, at most once for each topic.
    """
    for topic in rng.sample(list(topics), len(topics)):
        ways = [way for way in topics[topic] if can_be_drawn(way, cutter)]
        for _ in range(TRIES if ways else 0):
            way = rng.choice(ways)
            after = recut(cutter, way, rng)
            made = None if after is None else use(way, after)
            if made:
                yield made
                break


def can_be_drawn(way: Way, cutter: Cutter) -> bool:
    """Whether a garment has what a way changes, as far as its facts tell."""
    facts = cutter.facts
    if isinstance(way, Trick):
        return way.imagine(facts) is not None
    if not way.applies(facts):
        return False
    low, high = way.span(facts)
    return high > low and any(way.imagine(facts, end) != facts for end in (low, high))


def recut(cutter: Cutter, way: Way, rng: random.Random) -> Cutter | None:
    """Cuts by a random amount and checks what comes out.

    Returns:
        The edited pattern, in which the checker finds no error or warning that was not there before, every
        seam fits as well as it did, and lengths are such as are worn; None where it cannot be cut so.
    """
    try:
        edited = way.cut(cutter) if isinstance(way, Trick) else way.cut(cutter, _amount(way, cutter, rng))
    except SwiftTailorError:
        return None
    return accepted(cutter, edited, gathers=way.gathers)


def _amount(lever: Lever, cutter: Cutter, rng: random.Random) -> float:
    """To a measure within the span of a lever: any for what is new, mostly near ones for what is there."""
    now = lever.of(cutter.facts)
    low, high = lever.span(cutter.facts)
    if now is None:
        return (low + lever.step * rng.randint(0, int((high - low) / lever.step))) / lever.rate
    dimension = DIMENSIONS.get(lever.serves[0])
    least = max(dimension.least, lever.step) if dimension else _LEAST_STEPS * lever.step
    room = {sign: end - least for sign, end in ((1.0, high - now), (-1.0, now - low)) if end > least}
    sign = rng.choice(list(room) or [1.0, -1.0])
    change = least + room.get(sign, 0.0) * rng.random() ** _SHORTER
    return sign * change / lever.rate
