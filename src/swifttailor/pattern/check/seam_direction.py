"""Seams that run the wrong way and panels that are wound the wrong way round.

Two independent witnesses say how a stitch should run. The stitches themselves: a twisted one joins corners
of a panel that have nothing to do with each other (see `seam_topology`). And the placement: the two edges of
a plain stitch run in opposite directions in space, those of a ``right_wrong`` stitch in the same one.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.pattern.check.outline import Outline
from swifttailor.pattern.check.seam_topology import SeamTopology
from swifttailor.pattern.pattern import EdgeRef, Pattern, Stitch

AGAINST = -0.5
"""Agreement below this (a cosine) counts as the placement speaking against a stitch's direction."""

_MIN_CHORD_CM = 0.5
_MIN_OUTWARD = 0.2
_MAX_TURNS = 100
_MAX_STITCHES_FOR_PAIRS = 500


@dataclass(frozen=True)
class TwistedSeam:
    """A stitch that should run the other way."""

    stitch: int
    collapses: int
    """How many corners it glues together that turning it would set free."""
    agreement: float
    """Cosine between the direction of the stitch and that of the placed edges; -1 is full disagreement."""
    certain: bool
    """Whether the evidence leaves no other explanation, so that it may be turned without asking."""


@dataclass(frozen=True)
class InwardPanel:
    """A panel whose right side faces the body."""

    panel: str
    outward: float
    """Cosine between its normal and the way out from the body axis."""
    reversible: bool
    """Whether travelling its loop the other way agrees with all its stitches."""


@dataclass(frozen=True)
class Directions:
    """Everything found about directions."""

    twisted: tuple[TwistedSeam, ...] = ()
    inward: tuple[InwardPanel, ...] = ()
    turned_panels: tuple[tuple[str, float], ...] = ()
    """Panels all of whose seams the placement contradicts although they sew soundly, with the agreement."""


def judge_directions(pattern: Pattern, outlines: dict[str, Outline], usable: Sequence[int]) -> Directions:
    """Finds twisted stitches and inward panels.

    Args:
        pattern: Any pattern.
        outlines: Outline of each panel by name.
        usable: Indices of the stitches that join two different, existing edges, each in no other stitch.
    """
    topology = SeamTopology(pattern, usable)
    agreement = {s: _agreement(pattern.stitches[s], outlines) for s in usable}
    inward = _inward_panels(pattern, outlines, topology, agreement)
    # Look at the other seams as if the reversible panels and the seams found so far were already mended.
    reversible = {p.panel for p in inward if p.reversible}
    mended = [s for s in usable if _sides_in(pattern.stitches[s], reversible) == 1]
    topology.flip(mended)
    agreement |= {s: -agreement[s] for s in mended}
    twisted: list[TwistedSeam] = []
    for find in (_by_runs, _by_collapses):
        found = find(pattern, topology, agreement)
        agreement |= {t.stitch: -agreement[t.stitch] for t in found}
        twisted += found
    contradicted = _contradicted_panels(pattern, topology, agreement)
    doubtful = {name for name, _ in contradicted} | {p.panel for p in inward if not p.reversible}
    twisted += _by_placement(pattern, topology, agreement, doubtful)
    return Directions(tuple(sorted(twisted, key=lambda t: t.stitch)), tuple(inward), tuple(contradicted))


def outward_cosine(outline: Outline) -> float:
    """Cosine between a placed panel's normal and the horizontal way from the body axis to its middle.

    Zero where the panel lies flat or on the axis, so that neither says anything.
    """
    middle, normal = outline.world.mean(axis=0), outline.normal
    away, facing = middle[[0, 2]], normal[[0, 2]]
    product = float(np.hypot(*away) * np.hypot(*facing))
    if np.hypot(*away) < 1.0 or np.hypot(*facing) < 0.3:
        return 0.0
    return float(away @ facing) / product


def _agreement(stitch: Stitch, outlines: dict[str, Outline]) -> float:
    """Cosine that is 1 where the placed edges run as the stitch says and 0 where they say nothing."""
    if stitch.first.panel == stitch.second.panel:
        return 0.0
    a, b = (_direction(outlines[ref.panel], ref) for ref in stitch.sides)
    if a is None or b is None:
        return 0.0
    return float(a @ b) * (1.0 if stitch.right_wrong else -1.0)


def _direction(outline: Outline, ref: EdgeRef) -> Floats | None:
    placement = outline.panel.placement
    if not any(placement.translation) and not any(placement.rotation):
        return None  # never placed
    count = len(outline.world)
    chord = outline.world[(ref.edge + 1) % count] - outline.world[ref.edge]
    length = float(np.linalg.norm(chord))
    return chord / length if length >= _MIN_CHORD_CM else None


def _sides_in(stitch: Stitch, panels: set[str]) -> int:
    return (stitch.first.panel in panels) + (stitch.second.panel in panels)


def _inward_panels(
    pattern: Pattern, outlines: dict[str, Outline], topology: SeamTopology, agreement: dict[int, float]
) -> list[InwardPanel]:
    """Panels facing the body, and whether reversing their loops suits the stitches.

    They are tried all together first: a program that winds every panel the same way gets all its back
    panels wrong, and the seams between two wrong panels are right.
    """
    facing = {name: outward_cosine(outline) for name, outline in outlines.items()}
    inward = {name for name, cosine in facing.items() if cosine < -_MIN_OUTWARD}
    if not inward:
        return []
    reversible = inward if _suits(pattern, topology, agreement, inward) else set()
    if not reversible:
        reversible = {name for name in inward if _suits(pattern, topology, agreement, {name})}
    return [InwardPanel(n, facing[n], n in reversible) for n in outlines if n in inward]


def _suits(pattern: Pattern, topology: SeamTopology, agreement: dict[int, float], panels: set[str]) -> bool:
    """Whether reversing the loops of `panels` makes every seam that leaves them run better than before."""
    changed = [s for s in topology.stitches if _sides_in(pattern.stitches[s], panels) == 1]
    if not changed:
        return True
    before = topology.collapses()
    topology.flip(changed)
    after = topology.collapses()
    topology.flip(changed)
    spoken = [agreement[s] for s in changed if agreement[s] != 0.0]
    against = [a for a in spoken if a < 0]
    if after != before:
        return after < before and len(against) >= len(spoken) / 2
    return bool(spoken) and len(against) == len(spoken)


def _by_runs(pattern: Pattern, topology: SeamTopology, agreement: dict[int, float]) -> list[TwistedSeam]:
    """Judges stitches of neighbouring edges that join the same two panels by the way their edges run on.

    Where edge k and k + 1 of one panel meet edge j and j - 1 of another, the seam is a plain one; where they
    meet j and j + 1, right and wrong side meet.
    """
    wanted: dict[int, set[bool]] = {}
    partner = {ref: (s, other) for s in topology.stitches for ref, other in _both_ways(pattern.stitches[s])}
    for ref, (s, other) in partner.items():
        following = partner.get(_next(pattern, ref))
        if following is None or following[0] == s or following[1].panel != other.panel:
            continue
        ahead = _next(pattern, other) == following[1]
        behind = _next(pattern, following[1]) == other
        if ahead != behind:
            for stitch in (s, following[0]):
                wanted.setdefault(stitch, set()).add(ahead)
    wrong = [s for s, ways in wanted.items() if len(ways) == 1 and topology.start_to_start(s) not in ways]
    twisted = []
    for group in _connected(topology, sorted(wrong)):
        saved = topology.collapses_saved(group)
        if saved is not None and saved > 0:
            twisted += [TwistedSeam(s, saved, agreement[s], agreement[s] < 0.2) for s in group]
    topology.flip(t.stitch for t in twisted)
    return twisted


def _by_collapses(pattern: Pattern, topology: SeamTopology, agreement: dict[int, float]) -> list[TwistedSeam]:
    """Turns single stitches, then pairs that share a corner, while that sets corners free; the best first.

    What the placement contradicts is believed before what it supports.
    """
    twisted: list[TwistedSeam] = []
    for trusting in (False, True):
        for together in (1, 2):
            if together == 1 or len(topology.stitches) <= _MAX_STITCHES_FOR_PAIRS:
                twisted += _turn_while_better(topology, agreement, together, trusting, twisted)
    return twisted


def _turn_while_better(
    topology: SeamTopology,
    agreement: dict[int, float],
    together: int,
    against_placement: bool,
    done: Sequence[TwistedSeam],
) -> list[TwistedSeam]:
    """One round of `_by_collapses`: moves of `together` stitches, among those the placement allows."""
    allowed = {s for s in topology.stitches if against_placement or agreement[s] < -AGAINST}
    allowed -= {t.stitch for t in done}

    def gains_of(stitches: set[int]) -> dict[tuple[int, ...], int]:
        moves: set[tuple[int, ...]] = {(s,) for s in stitches & allowed}
        if together == 2:
            near = {s: topology.touching([s]) & allowed for s in stitches & allowed}
            moves = {(min(s, t), max(s, t)) for s, others in near.items() for t in others if s != t}
        return {move: topology.collapses_saved(move) or 0 for move in moves}

    def placed(move: tuple[int, ...]) -> float:
        return sum(agreement[s] for s in move) / len(move)

    if together == 2 and topology.collapses() <= topology.dart_count():
        return []
    turned: list[TwistedSeam] = []
    gains = gains_of(allowed)
    while len(turned) < _MAX_TURNS and max(gains.values(), default=0) > 0:
        best = max(gains.values())
        rivals = sorted((m for m, gain in gains.items() if gain == best), key=lambda m: (placed(m), m))
        chosen = rivals[0]
        near = topology.touching(chosen)
        close = [m for m in rivals[1:] if near & set(m) and placed(m) - placed(chosen) < 0.5]
        certain = placed(chosen) < 0.2 and not close
        turned += [TwistedSeam(s, best, agreement[s], certain) for s in chosen]
        topology.flip(chosen)
        allowed -= set(chosen)
        changed = near | topology.touching(chosen)
        gains = {m: g for m, g in gains.items() if not changed & set(m) and not set(m) & set(chosen)}
        gains |= gains_of(changed)
    return turned


def _by_placement(
    pattern: Pattern, topology: SeamTopology, agreement: dict[int, float], doubtful: set[str]
) -> list[TwistedSeam]:
    """Stitches on which the topology is silent and the placement is not, such as the two sides of a tube.

    Certain only where the placement of both panels is borne out by another of their seams.
    """
    against = [s for s in topology.stitches if agreement[s] < AGAINST]
    twisted = [s for s in against if topology.collapses_saved([s]) == 0]
    borne_out = {
        ref.panel for s in topology.stitches if agreement[s] > -AGAINST for ref in pattern.stitches[s].sides
    } - doubtful
    return [
        TwistedSeam(
            s, 0, agreement[s], agreement[s] < -0.8 and _sides_in(pattern.stitches[s], borne_out) == 2
        )
        for s in twisted
    ]


def _contradicted_panels(
    pattern: Pattern, topology: SeamTopology, agreement: dict[int, float]
) -> list[tuple[str, float]]:
    """Panels with two or more seams whose placement contradicts every one of them."""
    spoken: dict[str, list[float]] = {}
    for s in topology.stitches:
        if agreement[s] != 0.0:
            for ref in pattern.stitches[s].sides:
                spoken.setdefault(ref.panel, []).append(agreement[s])
    return [(n, float(np.mean(a))) for n, a in spoken.items() if len(a) >= 2 and max(a) < AGAINST]


def _connected(topology: SeamTopology, stitches: list[int]) -> list[list[int]]:
    """Groups of stitches that share corners, directly or through others of `stitches`."""
    groups: list[list[int]] = []
    left = set(stitches)
    while left:
        group, border = [], {min(left)}
        while border:
            left -= border
            group += sorted(border)
            border = topology.touching(border) & left
        groups.append(group)
    return groups


def _both_ways(stitch: Stitch) -> tuple[tuple[EdgeRef, EdgeRef], ...]:
    return (stitch.first, stitch.second), (stitch.second, stitch.first)


def _next(pattern: Pattern, ref: EdgeRef) -> EdgeRef:
    return EdgeRef(ref.panel, (ref.edge + 1) % len(pattern.panel(ref.panel).edges))
