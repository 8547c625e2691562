"""Puts a panel's edges, as listed in a file, into one closed loop with edge k from vertex k to k + 1."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.errors import PatternError
from swifttailor.pattern.curve import Curve, Line, reverse
from swifttailor.pattern.finding import Finding
from swifttailor.pattern.finding_kinds import found

COINCIDENT_CM = 1e-3
"""End points closer than this are taken as one vertex: no cloth is cut that exactly."""


@dataclass(frozen=True)
class RawEdge:
    """An edge as a file lists it: vertex indices, shape, label."""

    start: int
    end: int
    curve: Curve
    label: str


@dataclass(frozen=True)
class Loop:
    """A closed loop: vertices (n, 2) cm, edge k from vertex k to k + 1, and where each listed edge went."""

    vertices: Floats
    edges: tuple[RawEdge, ...]
    edge_ids: dict[int, int]
    findings: tuple[Finding, ...] = ()


def order_loop(panel: str, vertices: Floats, edges: list[RawEdge]) -> Loop:
    """Orders edges head to tail.

    Files of GarmentCode list them in order; the older formats do not promise it. The loop runs the way most
    edges are listed, since its direction decides the right side of the cloth; the others are reversed. A loop
    with a gap is closed (by joining coincident end points, else by a straight edge) and reported as an error,
    so that a checker can go on and a loader can refuse.

    Args:
        panel: Panel name, for findings and errors.
        vertices: (n, 2) cm.
        edges: As listed; indices must be valid.

    Raises:
        PatternError: The edges cannot form one loop (they branch, or form several).
    """
    n = len(edges)
    if n == len(vertices) and all(e.start == k and e.end == (k + 1) % n for k, e in enumerate(edges)):
        return Loop(vertices, tuple(edges), {k: k for k in range(n)})

    findings: list[Finding] = []
    chain, flipped = _with_the_majority(*_walk(panel, edges), edges)
    ordered = [_flip(edges[k]) if flipped[k] else edges[k] for k in chain]
    corners = [e.start for e in ordered]
    edge_ids = {k: position for position, k in enumerate(chain)}
    first, last = ordered[0].start, ordered[-1].end
    if first != last:
        gap = float(np.hypot(*(vertices[first] - vertices[last])))
        if gap > COINCIDENT_CM:
            corners.append(last)
            ordered.append(RawEdge(last, first, Line(), ""))
        findings.append(_open_loop(panel, gap))
    elif chain != list(range(n)) or any(flipped):
        findings.append(
            found(
                "edge-order",
                "edges are not listed head to tail; they were put in order and stitches renumbered",
                panel=panel,
            )
        )
    unused = len(vertices) - len(set(corners) | {first, last})
    if unused:
        text = f"{unused} vertices belong to no edge and were dropped"
        findings.append(found("unused-vertex", text, panel=panel, value=unused))
    return Loop(vertices[corners], tuple(ordered), edge_ids, tuple(findings))


def _walk(panel: str, edges: list[RawEdge]) -> tuple[list[int], list[bool]]:
    """Order of the edges along the loop or open chain, and which ones run backwards."""
    touching: dict[int, list[int]] = {}
    for k, e in enumerate(edges):
        if e.start == e.end:
            raise PatternError(
                f"panel '{panel}': edge {k} joins vertex {e.start} to itself. "
                "Remove it, or give it two vertices."
            )
        touching.setdefault(e.start, []).append(k)
        touching.setdefault(e.end, []).append(k)
    for vertex, at in touching.items():
        if len(at) > 2:
            raise PatternError(
                f"panel '{panel}': {len(at)} edges meet at vertex {vertex}; in one closed loop exactly 2 do. "
                "Split the panel so that each is a single loop without inner lines."
            )
    loose = sorted(v for v, at in touching.items() if len(at) == 1)
    if len(loose) > 2:
        raise PatternError(
            f"panel '{panel}': the outline has {len(loose) // 2} gaps (loose ends at vertices "
            f"{', '.join(map(str, loose[:6]))}). Join the edges into one closed loop."
        )
    # An open chain starts at its loose end that an edge leaves; a loop at its first listed edge.
    start_edge = 0
    if loose:
        leaving = [k for v in loose for k in touching[v] if edges[k].start == v]
        start_edge = leaving[0] if leaving else touching[loose[0]][0]
    at = edges[start_edge].start
    if loose and at not in loose:
        at = edges[start_edge].end
    origin = at
    chain: list[int] = []
    flipped = [False] * len(edges)
    current = start_edge
    while True:
        flipped[current] = edges[current].start != at
        chain.append(current)
        at = edges[current].start if flipped[current] else edges[current].end
        following = [k for k in touching[at] if k not in chain[-1:] and k != start_edge]
        if not following or at == origin:
            break
        current = following[0]
    if len(chain) != len(edges):
        raise PatternError(
            f"panel '{panel}': the edges form more than one loop ({len(chain)} of {len(edges)} edges "
            "are in the first). A panel is one closed loop without holes; make a panel of each loop."
        )
    return chain, flipped


def _with_the_majority(
    chain: list[int], flipped: list[bool], edges: list[RawEdge]
) -> tuple[list[int], list[bool]]:
    """The same chain travelled the way in which fewer edges are backwards; a loop keeps its first edge."""
    if 2 * sum(flipped) <= len(edges):
        return chain, flipped
    ends = [edges[chain[0]].end if flipped[chain[0]] else edges[chain[0]].start]
    ends.append(edges[chain[-1]].start if flipped[chain[-1]] else edges[chain[-1]].end)
    closed = ends[0] == ends[1]
    turned = [chain[0], *chain[:0:-1]] if closed else chain[::-1]
    return turned, [not f for f in flipped]


def _flip(edge: RawEdge) -> RawEdge:
    return replace(edge, start=edge.end, end=edge.start, curve=reverse(edge.curve))


def _open_loop(panel: str, gap: float) -> Finding:
    how = "closes it with a straight edge" if gap > COINCIDENT_CM else "joins the two ends"
    text = f"the outline is open by {gap:.3g} cm"
    return found("open-loop", text, panel=panel, value=gap, repair=f"--repair {how}")
