"""What an order asks for, read once: its words, its picture, its pattern to edit."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from swifttailor.arrays import Pixels
from swifttailor.describing.differences import Change, Gain
from swifttailor.describing.facts import GarmentFacts
from swifttailor.describing.measuring import measure_facts
from swifttailor.errors import SwiftTailorError
from swifttailor.pattern import Pattern, check_pattern
from swifttailor.pattern_maker.asking.framing import Framing, frame_figure
from swifttailor.pattern_maker.asking.pictures import read_picture
from swifttailor.pattern_maker.maker import Request
from swifttailor.recutting.alter import Alteration, alter
from swifttailor.recutting.one_sided import asks_for_one_side
from swifttailor.tailor.order import Order
from swifttailor.wishes.own_words import in_own_words
from swifttailor.wishes.reader import Wish, WishReader
from swifttailor.wishes.spelling import put_right

LEAST_CERTAINTY = 0.9
"""What the reader is less sure of is not asked for: what the network wrote may be as right."""
_NONE = "none"
_FRAMING_NOTES = {
    Framing.KEPT: (),
    Framing.CROPPED: ("The picture was cropped to its figure: the background is plain.",),
    Framing.BUSY: (
        "The background of the picture is not plain, so it was used whole; the network knows people and "
        "garments before plain backgrounds.",
    ),
    Framing.EMPTY: ("Nothing stands out from the background of the picture; it was used whole.",),
}


@dataclass(frozen=True, eq=False)
class Wanted:
    """An order that was read. What takes long is done when it is first needed, and once."""

    order: Order
    text: str
    """With slips of the fingers put right, where the order is altered to it."""
    image: Pixels | None = None
    """(h, w, 3) as the network is shown it."""
    wishes: tuple[Wish, ...] = ()
    """What the text asks for, as far as it was understood for certain."""
    likely: tuple[Wish, ...] = ()
    """What it may ask for, to be done last, where that costs nothing else."""
    notes: tuple[str, ...] = ()
    """What was done to the picture."""

    @property
    def unsaid(self) -> bool:
        """Whether words are all there is to go by, so that what they do not speak of is to be as usual."""
        return self.order.alter and self.order.edit is None and self.image is None

    @cached_property
    def tolerated(self) -> frozenset[str]:
        """Codes of what a check finds in the pattern to edit."""
        return frozenset(f.code for f in check_pattern(self.order.edit)) if self.order.edit else frozenset()

    @cached_property
    def original(self) -> GarmentFacts | None:
        """What the pattern to edit shows; None where it cannot be measured, or nothing is to be altered."""
        return None if self.order.edit is None or not self.wishes else _facts(self.order.edit)

    @cached_property
    def recut(self) -> Alteration | None:
        """The pattern to edit, altered: the same whatever the network writes."""
        if self.order.edit is None or self.original is None:
            return None
        return altered(self.order.edit, [wish.change for wish in self.wishes], self.original)

    def request(self, attempt: int) -> Request:
        """What the network is asked; of a description every second time in words that it was taught."""
        return Request(self._own_words(attempt) or self.text, self.image, self.order.edit)

    def _own_words(self, attempt: int) -> str:
        if self.order.edit is not None or self.image is not None or attempt % 2 == 0:
            return ""
        changes = [wish.change for wish in (*self.wishes, *self.likely)]
        if asks_for_one_side(changes):
            return ""  # easily mistaken for each other
        return in_own_words(changes, attempt)


def read_order(order: Order, reader: WishReader | None) -> Wanted:
    """Reads what an order asks for.

    Args:
        order: What is wanted.
        reader: Of the text; None where nothing is to be altered.

    Raises:
        InputError: The picture cannot be read.
    """
    image, notes = _picture(order)
    if reader is None:
        return Wanted(order, order.text, image, notes=notes)
    text = put_right(order.text)
    found = reader.read(text, instruction=order.edit is not None)
    return Wanted(order, text, image, sure_wishes(found), likely_wishes(found), notes)


def _picture(order: Order) -> tuple[Pixels | None, tuple[str, ...]]:
    if order.image is None:
        return None, ()
    pixels = order.image if isinstance(order.image, np.ndarray) else read_picture(order.image)
    if not order.crop:
        return pixels, ()
    framed = frame_figure(pixels)
    return framed.pixels, _FRAMING_NOTES[framed.framing]


def likely_wishes(found: Sequence[Wish]) -> tuple[Wish, ...]:
    """Wishes that are not sure, only likelier than not, where nothing else is read of the same thing.

    They are cut last, where that costs nothing that is asked for; left undone they are no fault.
    """
    spoken = [w.change.claim.name for w in found if isinstance(w.change, Gain)]
    likely = [
        w
        for w in found
        if w.certainty < LEAST_CERTAINTY
        and isinstance(w.change, Gain)
        and isinstance(w.change.claim.value, str)
    ]
    return tuple(w for w in likely if isinstance(w.change, Gain) and spoken.count(w.change.claim.name) == 1)


def sure_wishes(found: Sequence[Wish]) -> tuple[Wish, ...]:
    """Wishes that are certain enough to cut for, without those that contradict themselves.

    Who reads both that there is to be none of something and how it is to be has misunderstood.
    """
    values: dict[str, set[object]] = {}
    for wish in found:
        if isinstance(wish.change, Gain):
            values.setdefault(wish.change.claim.name, set()).add(wish.change.claim.value)
    confused = {name for name, said in values.items() if _NONE in said and len(said) > 1}
    return tuple(
        wish
        for wish in found
        if wish.certainty >= LEAST_CERTAINTY
        and not (isinstance(wish.change, Gain) and wish.change.claim.name in confused)
    )


def altered(
    pattern: Pattern, changes: Sequence[Change], original: GarmentFacts | None = None
) -> Alteration | None:
    """The pattern altered (`recutting.alter`); None where it cannot be measured."""
    try:
        return alter(pattern, changes, original=original)
    except SwiftTailorError:
        return None


def _facts(pattern: Pattern) -> GarmentFacts | None:
    try:
        return measure_facts(pattern)
    except SwiftTailorError:
        return None
