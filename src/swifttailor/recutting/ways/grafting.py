"""Sewing parts of two patterns together: along edges that run across the body, joint by joint."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from swifttailor.pattern import EdgeRef, Pattern
from swifttailor.recutting.table.workbench import Workbench

_SAME_JOINT = 0.02
"""Joints that lie this near each other, as a part of the whole length, are one."""


def lay_pattern(bench: Workbench, pattern: Pattern) -> dict[EdgeRef, int] | None:
    """Lays the panels of another pattern, sewn as they are; its edges' sides, None where a name is taken."""
    if any(p.name in bench.pieces for p in pattern.panels):
        return None
    sides = {EdgeRef(p.name, k): id for p in pattern.panels for k, id in enumerate(bench.add(p))}
    for s in pattern.stitches:
        bench.sew(sides[s.first], sides[s.second], right_wrong=s.right_wrong)
    return sides


def sew_across(bench: Workbench, upper: Sequence[int], lower: Sequence[int]) -> bool:
    """Sews sides of one face to others below them, from one side of the body to the other.

    Both are cut where the other has a joint; where one is longer, its fullness is spread evenly.

    Args:
        bench: Where they lie.
        upper: Free sides, in any order.
        lower: What is to hang from them.

    Returns:
        False, with the bench spoilt, where a face is turned wrong side out or one of them is empty.
    """
    chains = [_across(bench, ids) for ids in (upper, lower)]
    if not all(chains):
        return False
    if len({forward for _, forward in chains[0]}) != 1 or {f for _, f in chains[0]} == {
        f for _, f in chains[1]
    }:
        return False
    stops = [_stops(bench, chain) for chain in chains]
    for chain, own, other in ((chains[0], *stops), (chains[1], *stops[::-1])):
        _cut(bench, chain, own, [s for s in other if np.abs(np.array(own) - s).min() > _SAME_JOINT])
    if len(chains[0]) != len(chains[1]):
        return False
    for (one, _), (another, _) in zip(*chains, strict=True):
        bench.sew(one, another)
    return True


def _across(bench: Workbench, ids: Sequence[int]) -> list[tuple[int, bool]]:
    """Sides from the wearer's right to the left, and whether their loops go that way."""
    placed = []
    for id in ids:
        piece = bench.piece_of(id)
        x = piece.panel.to_world(piece.chord(id))[:, 0]
        placed.append((float(x.mean()), id, bool(x[1] > x[0])))
    return [(id, forward) for _, id, forward in sorted(placed)]


def _stops(bench: Workbench, chain: Sequence[tuple[int, bool]]) -> list[float]:
    """Joints of a chain as parts of its length, 0 and 1 included."""
    lengths = np.array([bench.piece_of(id).length(id) for id, _ in chain])
    return [0.0, *map(float, np.cumsum(lengths)[:-1] / lengths.sum()), 1.0]


def _cut(
    bench: Workbench, chain: list[tuple[int, bool]], own: Sequence[float], cuts: Sequence[float]
) -> None:
    """Cuts the sides of a chain at parts of its length; the chain then holds all of them."""
    for k in reversed(range(len(chain))):
        low, high = own[k], own[k + 1]
        id, forward = chain[k]
        inside = sorted((c - low) / (high - low) for c in cuts if low < c < high)
        inside = inside if forward else sorted(1.0 - c for c in inside)
        parts, rest = [id], 1.0
        for fraction in reversed(inside):
            parts.insert(1, bench.split(id, fraction / rest))
            rest = fraction
        chain[k : k + 1] = [(p, forward) for p in (parts if forward else parts[::-1])]
