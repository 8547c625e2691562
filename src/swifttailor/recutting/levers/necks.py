"""Levers of necklines: depth, width, shape, of the front and the back, whole or half."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Literal

from swifttailor.describing.facts import GarmentFacts, NeckHalf, Neckline
from swifttailor.describing.measuring.parts import Face
from swifttailor.pattern import Pattern
from swifttailor.recutting.amounts.neck_cuts import recut_under
from swifttailor.recutting.levers.lever import Lever, Trick, fixed
from swifttailor.recutting.table.cutter import Cutter
from swifttailor.recutting.ways.neck_width import widen_neckline
from swifttailor.recutting.ways.necklines import NewShape, recut_neckline

Half = Literal["left", "right"]

_SHAPED = ("neckline", "left_neckline", "right_neckline")
_SLOPE = 0.93
"""Way across for 1 cm along a shoulder seam, about."""
_CUT: dict[NewShape, str] = {
    "round": "round",
    "v": "to a V",
    "square": "square",
    "trapezoid": "to a trapezoid",
    "s-curve": "in an S-curve",
    "pointed": "to a leaf's point",
}


_OR_SHALLOWER = (0.8, 0.65, 0.5)
"""A deep neckline leaves no room for the corners of another shape; then it is cut less deep."""
_BOAT_CM = 9.0
"""As deep as a boat neckline is cut before it is widened."""


def plain_neck(facts: GarmentFacts, face: Face) -> Neckline | None:
    """A neckline with two shoulders."""
    neck = facts.front_neck if face == "front" else facts.back_neck
    return None if neck is None or neck.left is None or neck.right is None else neck


def _with_neck(facts: GarmentFacts, face: Face, change: Callable[[NeckHalf], NeckHalf]) -> GarmentFacts:
    neck = facts.front_neck if face == "front" else facts.back_neck
    if neck is None:
        return facts
    neck = Neckline(neck.left and change(neck.left), neck.right and change(neck.right))
    return replace(facts, front_neck=neck) if face == "front" else replace(facts, back_neck=neck)


def _depth_lever(face: Face, shape: NewShape | None) -> Lever:
    def of(facts: GarmentFacts) -> float | None:
        neck = plain_neck(facts, face)
        return neck.depth if neck else None

    def imagine(facts: GarmentFacts, depth: float) -> GarmentFacts:
        by = depth - (of(facts) or 0.0)

        def recut(half: NeckHalf) -> NeckHalf:
            return NeckHalf(shape or half.shape, half.depth + by, half.width)

        return _with_neck(facts, face, recut) if plain_neck(facts, face) else facts

    def cut(cutter: Cutter, amount: float) -> Pattern | None:
        def recut(bare: Cutter) -> Pattern | None:
            edges = bare.neckline(face)
            return recut_neckline(bare.pattern, edges, amount, shape) if edges else None

        return recut_under(cutter, recut)

    return Lever(
        name=f"{face} neckline" if shape is None else f"{face} neckline cut {_CUT[shape]},",
        serves=("neck depth" if face == "front" else "back depth",),
        stage=4,
        of=of,
        imagine=imagine,
        cut=cut,
        span=fixed(3.5, 50.0),
        step=0.5,
        words=("deeper", "shallower"),
        or_less=() if shape is None else _OR_SHALLOWER,
    )


def _half_shape(side: Half, shape: NewShape) -> Trick:
    def imagine(facts: GarmentFacts) -> GarmentFacts | None:
        neck = plain_neck(facts, "front")
        if neck is None or neck.left is None or neck.right is None:
            return None
        half = replace(neck.left if side == "left" else neck.right, shape=shape)
        neck = Neckline(half, neck.right) if side == "left" else Neckline(neck.left, half)
        return replace(facts, front_neck=neck)

    def cut(cutter: Cutter) -> Pattern | None:
        edges = cutter.neckline("front")
        return recut_neckline(cutter.pattern, edges, 0.0, shape, side) if edges else None

    return Trick(
        name=f"{side} half of the front neckline cut {_CUT[shape]}",
        stage=4,
        imagine=imagine,
        cut=cut,
        only_for=_SHAPED,
    )


def _for_a_boat(facts: GarmentFacts) -> GarmentFacts | None:
    neck = plain_neck(facts, "front")
    if neck is None or neck.left is None or neck.right is None:
        return None
    depth = min(neck.depth or _BOAT_CM, _BOAT_CM)
    if neck.left.shape == neck.right.shape == "round" and (neck.depth or 0.0) <= _BOAT_CM:
        return None
    halves = [NeckHalf("round", depth, half.width) for half in (neck.left, neck.right)]
    return replace(facts, front_neck=Neckline(*halves))


def _cut_for_a_boat(cutter: Cutter) -> Pattern | None:
    neck = plain_neck(cutter.facts, "front")
    by = min(_BOAT_CM - (neck.depth or _BOAT_CM), 0.0) if neck else 0.0

    def recut(bare: Cutter) -> Pattern | None:
        edges = bare.neckline("front")
        return recut_neckline(bare.pattern, edges, by, "round") if edges else None

    return recut_under(cutter, recut)


def _width(facts: GarmentFacts) -> float | None:
    neck = plain_neck(facts, "front")
    return neck.width if neck else None


def _set_width(facts: GarmentFacts, width: float) -> GarmentFacts:
    by = width - (_width(facts) or 0.0)

    def widened(half: NeckHalf) -> NeckHalf:
        return replace(half, width=half.width + by)

    torso = facts.torso
    if torso is not None and torso.left_shoulder is not None and torso.right_shoulder is not None:
        left, right = (s - by / _SLOPE for s in (torso.left_shoulder, torso.right_shoulder))
        facts = replace(facts, torso=replace(torso, left_shoulder=left, right_shoulder=right))
    return _with_neck(_with_neck(facts, "front", widened), "back", widened)


def _cut_width(cutter: Cutter, amount: float) -> Pattern | None:
    def recut(bare: Cutter) -> Pattern | None:
        front, back = bare.neckline("front"), bare.neckline("back")
        return widen_neckline(bare.pattern, front, back, amount) if front and back else None

    return recut_under(cutter, recut)


def _width_span(facts: GarmentFacts) -> tuple[float, float]:
    torso = facts.torso
    shoulders = [s for s in (torso.left_shoulder, torso.right_shoulder) if s is not None] if torso else []
    return 6.0, (_width(facts) or 0.0) + _SLOPE * (min(shoulders, default=0.0) - 2.5)


_SHAPES: tuple[NewShape, ...] = ("round", "v", "square", "trapezoid", "s-curve", "pointed")
NECK_LEVERS: tuple[Lever, ...] = (
    *(_depth_lever(face, shape) for face in ("front", "back") for shape in (None, *_SHAPES)),
    Lever(
        name="neckline",
        serves=("neck width",),
        stage=3,
        of=_width,
        imagine=_set_width,
        cut=_cut_width,
        span=_width_span,
        step=0.5,
        rate=_SLOPE,
        words=("wider on each side", "narrower on each side"),
    ),
)
NECK_TRICKS: tuple[Trick, ...] = (
    *(_half_shape(side, shape) for side in ("left", "right") for shape in _SHAPES),
    Trick(
        name="front neckline cut shallow and round",
        stage=4,
        imagine=_for_a_boat,
        cut=_cut_for_a_boat,
        only_for=("neckline: boat",),
        opens=("neckline: boat",),
    ),
)
