"""The colour of a garment of which a text tells those of its body and its sleeves, and no other."""

from __future__ import annotations

from collections.abc import Iterable

from swifttailor.wording.lexicon.said_looks import SaidLook


def color_of_body(looks: Iterable[SaidLook]) -> str | None:
    """The body's, ``rrggbb``: collar, cuffs and bands are of it, too; None where not both are told."""
    told = {look.part: look.color.rgb for look in looks if look.said and look.color is not None}
    return told.get("bodice") if "sleeves" in told else None
