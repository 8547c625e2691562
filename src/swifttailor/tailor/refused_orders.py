"""Orders that ask for no garment, among others that do: each is answered by why."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from swifttailor.errors import NothingAskedError, SwiftTailorError
from swifttailor.tailor.answer import Answer
from swifttailor.tailor.order import Order
from swifttailor.tailor.reading import Wanted

Asked = Wanted | NothingAskedError


def read_or_refused(read: Callable[[Order], Wanted], order: Order) -> Asked:
    """What an order asks for, or why nothing is made of it.

    Args:
        read: Reads an order.
        order: What is wanted.
    """
    try:
        return read(order)
    except NothingAskedError as refused:
        return refused


def with_refused(
    asked: Sequence[Asked], orders: Sequence[Order], written: Sequence[Answer | SwiftTailorError]
) -> list[Answer | SwiftTailorError]:
    """The answers of all samples of all orders, in their order.

    Args:
        asked: Of each order.
        orders: As many.
        written: The answers of those that are not refused.
    """
    rest = iter(written)
    return [
        one if isinstance(one, NothingAskedError) else next(rest)
        for one, order in zip(asked, orders, strict=True)
        for _ in range(order.samples)
    ]
