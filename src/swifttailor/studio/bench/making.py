"""Tasks of the main job: words and pictures to garments, edits, sewing with care."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from swifttailor.arrays import Pixels
from swifttailor.body import Body
from swifttailor.errors import SwiftTailorError
from swifttailor.pattern.drafted_for import DraftedFor
from swifttailor.studio.bench.documents import Work, read_pattern, tailored_document
from swifttailor.studio.bench.part_looks import in_cloth, looks_read, print_read
from swifttailor.studio.bench.tasks import tailor
from swifttailor.studio.bench.wearers import wearing
from swifttailor.studio.worker.link import Link
from swifttailor.studio.worker.refusal import refusal_of
from swifttailor.tailor.all_parts import orders_of_parts
from swifttailor.tailor.order import Order, Part
from swifttailor.tailor.tailored import Tailored
from swifttailor.wishes.wearers.wearer_words import hear_wearer


def generate(
    link: Link,
    *,
    text: str,
    pictures: list[Pixels],
    part: Part | None,
    seed: int,
    variants: int,
    finish: bool,
    wearer: dict[str, Any] | None = None,
) -> Work:
    """Garments of a description, pictures, or both, one for each seed from `seed` on.

    Of a description of two garments that are worn together both are made, with every seed.
    """
    order = Order(
        text,
        pictures or None,
        part=part,
        samples=variants,
        seed=seed,
        finish=finish,
        body=_body_for(text, wearer),
    )
    parts: dict[Part, Order] = {"whole": order} if pictures else orders_of_parts(order, tailor())
    return _made(link, parts, origin="generate", prompt=text)


def edit(
    link: Link,
    *,
    pattern: dict[str, Any],
    instruction: str,
    color: str | None,
    seed: int,
    finish: bool,
    looks: Sequence[dict[str, Any]] = (),
    print: dict[str, Any] | None = None,
) -> Work:
    """A pattern changed as words say, and its garment."""
    original = read_pattern(pattern).pattern.canonical()
    named = original.drafted_for
    # A mesh is known here alone; whom the words name outranks it.
    own = named is not None and named.mesh is not None
    own = own and hear_wearer(instruction, instruction=True).wearer is None
    body = wearing(named).body if own else None
    order = Order(
        instruction,
        edit=original,
        color=color,
        looks=looks_read(looks),
        print=print_read(print),
        seed=seed,
        finish=finish,
        body=body,
    )
    return _made(link, {"whole": order}, origin="edit", prompt=instruction)


def sew(
    link: Link,
    *,
    pattern: dict[str, Any],
    edge_length: float,
    repair: bool,
    color: str | None,
    looks: Sequence[dict[str, Any]] = (),
    print: dict[str, Any] | None = None,
) -> Work:
    """The garment of a pattern."""
    original = read_pattern(pattern).pattern.canonical()
    link.stage("sewing", 0.0)
    made = wearing(original.drafted_for).tailor.sew(
        original, edge_length=edge_length, repair=repair, progress=link.stage
    )
    made = replace(made, garment=in_cloth(made.garment, color, looks, print))
    work = tailored_document(made, origin="sew", prompt="", edge_length=edge_length, seed=None)
    return Work({"documents": [work.answer], "failures": []}, work.meshes)


def _body_for(text: str, wearer: dict[str, Any] | None) -> Body | None:
    """Who wears what is made: the one that the words name, else the one that was chosen."""
    named = DraftedFor.from_json(wearer)
    if named is None or hear_wearer(text, instruction=False).wearer is not None:
        return None
    return wearing(named).body


def _made(link: Link, orders: dict[Part, Order], *, origin: str, prompt: str) -> Work:
    documents, failures, meshes = [], [], []
    for part, order in orders.items():
        for k, outcome in enumerate(_outcomes(link, order, alone=len(orders) == 1)):
            if isinstance(outcome, Tailored):
                link.stage("describing", k / order.samples)
                named = {"part": "whole" if part == "beside" else part} if len(orders) > 1 else {}
                work = tailored_document(
                    outcome, origin=origin, prompt=prompt, edge_length=order.edge_length, **named
                )
                documents.append(work.answer)
                meshes += work.meshes
            else:
                failures.append({"seed": order.seed + k, "error": refusal_of(outcome)})
    if not documents:
        raise _first_error(failures)
    return Work({"documents": documents, "failures": failures}, tuple(meshes))


def _outcomes(link: Link, order: Order, *, alone: bool) -> list[Tailored | SwiftTailorError]:
    """What comes of an order; that of two cannot be carried out does not take the other with it."""
    try:
        return tailor().make(order, progress=link.stage)
    except SwiftTailorError as error:
        if alone:
            raise
        return [error]


class NoneMadeError(SwiftTailorError):
    """None of the variants could be made."""


def _first_error(failures: list[dict[str, Any]]) -> SwiftTailorError:
    return NoneMadeError(failures[0]["error"]["message"])
