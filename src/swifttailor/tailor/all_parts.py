"""The garments that an order asks for together: both of a text, or of a picture of somebody in two."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, get_args

from swifttailor.tailor.order import Order, Part

if TYPE_CHECKING:
    from swifttailor.tailor.tailor import Tailor

_HALVES: tuple[Part, ...] = get_args(Part)[:2]


def orders_of_parts(order: Order, tailor: Tailor) -> dict[Part, Order]:
    """An order for each garment that one asks for, by where it is worn.

    Args:
        order: Where it says which part, or changes a pattern, it is left as it is.
        tailor: Who looks at pictures.

    Returns:
        ``upper`` and ``lower``, and ``beside`` where a text names a third; of a picture that which covers
        most of it first. ``whole``, or the part that is chosen, where there is but one.

    Raises:
        InputError: A picture cannot be read.
    """
    alone: Part = order.part or "whole"
    if order.edit is not None:
        return {alone: order}
    if not order.images:
        if order.part is not None or order.outfit is None:
            return {alone: order}
        parts: tuple[Part, ...] = (*_HALVES, "beside") if order.outfit.third else _HALVES
        return {part: replace(order, part=part) for part in parts}
    if not order.alter or tailor.picture_reader is None:
        return {alone: order}
    from swifttailor.tailor.looking import look_at, parts_seen

    pictures = tuple(look_at(image, tailor.picture_reader) for image in order.images)
    order = replace(order, image=pictures)
    seen = parts_seen(pictures)
    if order.part is not None or len(seen) < 2 or order.text.strip():
        return {alone: order}
    return {part: replace(order, part=part) for part in seen}
