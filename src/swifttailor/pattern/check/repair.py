"""Mends the faults of a sewing pattern that have one safe remedy, and says what it did."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from functools import partial

import numpy as np

from swifttailor.pattern.check.body_levels import BodyLevels
from swifttailor.pattern.check.change import Change
from swifttailor.pattern.check.checker import check_pattern
from swifttailor.pattern.check.crossing_repair import MAX_MOVE_CM, Effort, mend_crossings
from swifttailor.pattern.check.crossings import find_crossing
from swifttailor.pattern.check.judgements import directions_of
from swifttailor.pattern.check.outline import trace_outline
from swifttailor.pattern.check.panel_checks import SLIVER_EDGE_CM, ZERO_LENGTH_CM, radius_needed
from swifttailor.pattern.check.placement_checks import BodyProbe, SignedDistance, body_probe
from swifttailor.pattern.check.placement_repair import move_to_body, reread_angles, turn_limbs
from swifttailor.pattern.check.stitch_checks import usable_stitches
from swifttailor.pattern.curve import Arc
from swifttailor.pattern.finding import Finding
from swifttailor.pattern.finding_kinds import found
from swifttailor.pattern.panel import Panel
from swifttailor.pattern.pattern import EdgeRef, Pattern, Stitch

_MAX_ROUNDS = 4
_READER_CHANGES = {
    "open-loop": "closed the outline",
    "edge-order": "put the edges in order, head to tail",
    "unused-vertex": "dropped vertices that belong to no edge",
    "dangling-stitch": "removed the stitch",
    "panel-order": "wrote panel_order anew",
    "other-units": "converted all lengths to cm",
    "unknown-key": "left out an unknown key",
}


@dataclass(frozen=True)
class Repair:
    """What a repair came to."""

    pattern: Pattern
    changes: tuple[Change, ...]
    """In the order in which they were made; empty when nothing had to be, or could be, mended."""
    remaining: tuple[Finding, ...]
    """What a check still finds in `pattern`."""


def repair_pattern(
    pattern: Pattern,
    reader_findings: Iterable[Finding] = (),
    *,
    body: BodyProbe | SignedDistance | None = None,
    largest_move: float = MAX_MOVE_CM,
    largest_share: float = 0.0,
    keep_places: bool = False,
) -> Repair:
    """Mends what is safe to mend and leaves alone what would need a guess.

    Removes stitches to nowhere, of an edge with itself, and repeats; drops edges without length where the
    seam partner is as short; raises arc radii to half the chord; rewrites angles meant the other way,
    moves a garment that stands elsewhere to the body and turns sleeves and legs of another pose; reverses
    inside-out panels and turns twisted seams where all evidence agrees; moves corners and curves out of
    overlaps. A pattern without such findings comes back as it is.

    Args:
        pattern: As the reader returned it.
        reader_findings: `Reading.findings`; the reader has already mended what they name, so they are listed
            as changes.
        body: As for `check_pattern`.
        largest_move: How far a point of an outline may be moved, cm: as far as it may be off.
        keep_places: Whether panels are known to stand where they are worn, and stay there.
        largest_share: The same as a share of the panel's size; whichever is more counts.
    """
    changes = [_reader_change(f) for f in reader_findings]
    probe = body_probe(body)
    levels = BodyLevels() if probe is None else probe.levels
    place = [partial(step, levels=levels) for step in (reread_angles, move_to_body, turn_limbs)]
    place = [] if keep_places else place
    effort, tried = Effort(), {}
    free = partial(
        _free_crossings, largest_move=largest_move, largest_share=largest_share, effort=effort, tried=tried
    )
    for _ in range(_MAX_ROUNDS):
        made: list[Change] = []
        for step in (*_STEPS, *place, _reverse_panels, _turn_seams, free):
            pattern, done = step(pattern)
            made += done
        changes += made
        if not made:
            break
    remaining = check_pattern(pattern, body=body)
    if effort.edges < 0:
        text = "the outlines overlap themselves in so many ways that not all of them were tried to be mended"
        remaining = (*remaining, found("unfinished-repair", text))
    return Repair(pattern, tuple(changes), remaining)


def _reader_change(finding: Finding) -> Change:
    done = _READER_CHANGES.get(finding.code, "mended while reading")
    return Change(finding.code, f"{done}: {finding.message}", finding.panel, finding.edge, finding.stitch)


def _remove_stitches(pattern: Pattern) -> tuple[Pattern, list[Change]]:
    usable = set(usable_stitches(pattern))
    changes = []
    for k, s in enumerate(pattern.stitches):
        if k in usable:
            continue
        missing = [ref for ref in s.sides if not pattern.has_edge(ref)]
        if missing:
            code, why = "dangling-stitch", f"'{missing[0].panel}' has no edge {missing[0].edge}"
        elif s.first == s.second:
            code, why = "self-stitched-edge", "it joined an edge to itself"
        else:
            code, why = "duplicate-stitch", "it repeated another"
        place = missing[0] if missing else s.first
        changes.append(Change(code, f"removed the stitch: {why}", place.panel, place.edge, k))
    if not changes:
        return pattern, []
    return replace(pattern, stitches=tuple(pattern.stitches[k] for k in sorted(usable))), changes


def _raise_radii(pattern: Pattern) -> tuple[Pattern, list[Change]]:
    changes: list[Change] = []
    panels = []
    for panel in pattern.panels:
        edges = list(panel.edges)
        for k, edge in enumerate(panel.edges):
            half = radius_needed(panel, k)
            if half is None:
                continue
            assert isinstance(edge.curve, Arc)
            edges[k] = replace(edge, curve=replace(edge.curve, radius=half))
            text = f"raised the arc's radius from {edge.curve.radius:.6g} to {half:.6g} cm"
            changes.append(Change("short-radius", text, panel.name, k))
        panels.append(replace(panel, edges=tuple(edges)) if tuple(edges) != panel.edges else panel)
    return (replace(pattern, panels=tuple(panels)), changes) if changes else (pattern, [])


def _drop_zero_edges(pattern: Pattern) -> tuple[Pattern, list[Change]]:
    lengths = {p.name: trace_outline(p).lengths for p in pattern.panels}
    partners: dict[EdgeRef, list[EdgeRef]] = {}
    for s in pattern.stitches:
        partners.setdefault(s.first, []).append(s.second)
        partners.setdefault(s.second, []).append(s.first)
    drop: dict[str, set[int]] = {}
    changes: list[Change] = []
    for panel in pattern.panels:
        for k in np.flatnonzero(lengths[panel.name] < ZERO_LENGTH_CM).tolist():
            ref = EdgeRef(panel.name, k)
            if k in drop.get(panel.name, ()):
                continue  # went with its partner
            sewn = partners.get(ref, [])
            gone = {ref, *sewn}
            alone = len(sewn) <= 1 and all(partners.get(other) == [ref] for other in sewn)
            short = all(pattern.has_edge(r) and lengths[r.panel][r.edge] < SLIVER_EDGE_CM for r in gone)
            planned = {r.panel: set(drop.get(r.panel, ())) for r in gone}
            for r in gone:
                planned[r.panel].add(r.edge)
            if not (alone and short) or any(len(lengths[n]) - len(d) < 3 for n, d in planned.items()):
                continue
            drop |= planned
            partner = f" and its partner {sewn[0].panel}.{sewn[0].edge}" if sewn else ""
            changes.append(Change("zero-length-edge", f"dropped the edge{partner}", panel.name, k))
    return (_without_edges(pattern, drop), changes) if changes else (pattern, [])


def _without_edges(pattern: Pattern, drop: dict[str, set[int]]) -> Pattern:
    """The pattern without some edges: each takes its start corner with it, the edge before goes on."""
    renumbered: dict[EdgeRef, EdgeRef] = {}
    panels = []
    for panel in pattern.panels:
        keep = [k for k in range(len(panel.edges)) if k not in drop.get(panel.name, ())]
        renumbered |= {EdgeRef(panel.name, k): EdgeRef(panel.name, i) for i, k in enumerate(keep)}
        if len(keep) < len(panel.edges):
            edges = tuple(panel.edges[k] for k in keep)
            panel = replace(panel, vertices=panel.vertices[keep], edges=edges)
        panels.append(panel)
    stitches = [s for s in pattern.stitches if s.first in renumbered and s.second in renumbered]
    return replace(pattern, panels=tuple(panels), stitches=_renumber(stitches, renumbered))


def _renumber(stitches: Iterable[Stitch], renumbered: dict[EdgeRef, EdgeRef]) -> tuple[Stitch, ...]:
    return tuple(
        Stitch(renumbered.get(s.first, s.first), renumbered.get(s.second, s.second), s.right_wrong)
        for s in stitches
    )


def _reverse_panels(pattern: Pattern) -> tuple[Pattern, list[Change]]:
    reversible = [p.panel for p in directions_of(pattern).inward if p.reversible]
    if not reversible:
        return pattern, []
    renumbered: dict[EdgeRef, EdgeRef] = {}
    panels = []
    for panel in pattern.panels:
        if panel.name in reversible:
            last = len(panel.edges) - 1
            renumbered |= {EdgeRef(panel.name, k): EdgeRef(panel.name, last - k) for k in range(last + 1)}
            panel = panel.reversed()
        panels.append(panel)
    text = "reversed the loop, so that the right side faces outward (its edges are numbered the other way)"
    changes = [Change("inside-out-panel", text, name) for name in reversible]
    return replace(pattern, panels=tuple(panels), stitches=_renumber(pattern.stitches, renumbered)), changes


def _turn_seams(pattern: Pattern) -> tuple[Pattern, list[Change]]:
    certain = [t.stitch for t in directions_of(pattern).twisted if t.certain]
    stitches = list(pattern.stitches)
    changes = []
    for k in certain:
        s = stitches[k]
        stitches[k] = replace(s, right_wrong=not s.right_wrong)
        verb = "removed 'right_wrong' from" if s.right_wrong else "added 'right_wrong' to"
        text = f"{verb} the stitch to {s.second.panel}.{s.second.edge}, which was twisted"
        changes.append(Change("twisted-seam", text, s.first.panel, s.first.edge, k))
    return (replace(pattern, stitches=tuple(stitches)), changes) if changes else (pattern, [])


def _free_crossings(
    pattern: Pattern,
    largest_move: float,
    largest_share: float,
    effort: Effort,
    tried: dict[Panel, tuple[Panel, float] | None],
) -> tuple[Pattern, list[Change]]:
    changes = []
    panels: list[Panel] = []
    for panel in pattern.panels:
        crossing = find_crossing(trace_outline(panel))
        if crossing is not None and crossing.kind != "touch":
            if panel not in tried and effort.edges >= 0:
                tried[panel] = mend_crossings(panel, largest_move, largest_share, effort)
            mended = tried.get(panel)
            if mended is not None:
                panel, moved = mended
                text = f"moved the outline by up to {moved:.2g} cm, so that it no longer overlaps itself"
                code = "self-crossing" if crossing.kind == "crossing" else "near-crossing"
                changes.append(Change(code, text, panel.name, min(crossing.edges)))
        panels.append(panel)
    return (replace(pattern, panels=tuple(panels)), changes) if changes else (pattern, [])


_STEPS: tuple[Callable[[Pattern], tuple[Pattern, list[Change]]], ...] = (
    _remove_stitches,
    _raise_radii,
    _drop_zero_edges,
)
