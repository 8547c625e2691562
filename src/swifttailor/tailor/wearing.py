"""Patterns for the body that is to wear them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from swifttailor.body import Body
from swifttailor.errors import SwiftTailorError
from swifttailor.pattern import Pattern
from swifttailor.tailor.answer import Answer
from swifttailor.tailor.lengths_kept import with_lengths_kept
from swifttailor.tailor.order import Order
from swifttailor.tailor.refitted import refitted
from swifttailor.tailor.sewing import SewingOptions, prepare
from swifttailor.wishes.wearers.wearer_words import hear_wearer

if TYPE_CHECKING:
    from swifttailor.tailor.protocols import Sewer


def body_wanted(order: Order, usual: Body | None) -> Body | None:
    """Whom the patterns of an order are refitted to; None where they are left as they are drafted.

    Args:
        order: What is wanted.
        usual: The tailor's body, where patterns are refitted to it.

    Raises:
        InputError: The text names a body that there is not.
    """
    if order.body is not None:
        return order.body
    if order.alter and order.text.strip():
        wearer = hear_wearer(order.text, instruction=order.edit is not None).wearer
        if wearer is not None:
            return replace(wearer, before=None if order.edit is None else order.edit.drafted_for).body()
    if usual is None and order.edit is not None and order.edit.drafted_for is not None:
        from swifttailor.body.wearer import body_of

        return body_of(order.edit.drafted_for)
    return usual


def named_as(answer: Answer | SwiftTailorError, edit: Pattern | None) -> Answer | SwiftTailorError:
    """An answer to an edit, whose pattern is for the body of the pattern to edit."""
    if edit is None or edit.drafted_for is None or not isinstance(answer, Answer):
        return answer
    return replace(answer, pattern=replace(answer.pattern, drafted_for=edit.drafted_for))


def all_refitted(
    answers: Sequence[Answer | SwiftTailorError], body: Body, sewer: Sewer, options: SewingOptions
) -> list[Answer | SwiftTailorError]:
    """Refits patterns to a body and prepares them to be sewn on it; what is wrong with one concerns no other.

    Args:
        answers: Patterns, or why there is none.
        body: Who wears them.
        sewer: What sews on that body.
        options: How they are sewn.
    """
    done: list[Answer | SwiftTailorError] = []
    for answer in answers:
        if isinstance(answer, Answer):
            try:
                answer = prepare(sewer, with_lengths_kept(refitted(answer, body), body), options)
            except SwiftTailorError as error:
                answer = error
        done.append(answer)
    return done
