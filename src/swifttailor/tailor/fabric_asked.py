"""Fabrics that a text names: only physics obeys them, since the network knows how one of them hangs."""

from __future__ import annotations

from typing import TYPE_CHECKING

from swifttailor.wording.lexicon import read_words

if TYPE_CHECKING:
    from swifttailor.tailor.reading import Wanted

SEWN_FABRIC = "cotton"
"""What GarmentSewer learnt from hangs like this."""


def fabric_unmet(wanted: Wanted) -> str | None:
    """The fabric that the garment does not hang like, though the text names it; None where there is none.

    One that is chosen beside the text outranks it, and what it is used for is said. A fabric that only
    the name of a garment implies, such as that of jeans, is not one that was asked for.
    """
    heard = wanted.heard
    if (
        wanted.order.finish
        or wanted.order.fabric is not None
        or heard.cloth in (None, SEWN_FABRIC)
        or heard.words is None
    ):
        return None
    # The lexicon knows "satin skirt" as one name, with the fabric that it usually has.
    names = [
        mark.word for mark in heard.words.marks if not mark.denied and any(e.cloth for e in mark.entries)
    ]
    named = heard.words.cloths or any(read_words(word).cloths for name in names for word in name.split())
    return heard.cloth if named else None


def fabric_warning(fabric: str) -> str:
    """The same for a person, and how it is met."""
    return (
        f"The fabric, {fabric}, is not met: without --finish (finish=True) a garment hangs like "
        f"{SEWN_FABRIC}, and only weighs and shines like what was asked for. Add --finish."
    )
