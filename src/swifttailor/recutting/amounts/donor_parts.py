"""The upper or lower half of a garment exchanged for that of another pattern."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from swifttailor.describing.measuring.parts import LOWER_PARTS, UPPER_PARTS, Face, Part
from swifttailor.describing.measuring.skirts import upper_edges
from swifttailor.pattern import EdgeRef, Panel, Pattern, Stitch
from swifttailor.recutting.table.cutter import Cutter
from swifttailor.recutting.table.workbench import Workbench
from swifttailor.recutting.ways.fullness import widen_panels
from swifttailor.recutting.ways.grafting import lay_pattern, sew_across
from swifttailor.recutting.ways.removal import WAIST_LABEL

_FACES: tuple[Face, Face] = ("front", "back")
_HOLDERS = frozenset({Part.TORSO, Part.WAISTBAND})
_FITS = 0.01
"""Widths that differ by less, as a part of the whole, are the same."""
_MOST_STRETCHED = 1.3
"""So much wider or narrower a half may be cut to fit the other; its own shape is lost beyond that."""
_EASED = 0.12
_BELOW_CM = 2.0
"""From what holds a lower half down to it, as placed."""

_Edges = dict[Face, list[EdgeRef]]


def lower_from(cutter: Cutter, donor: Cutter) -> Pattern | None:
    """Skirt or trousers taken off, and those of another pattern sewn to what held them.

    They are cut wider or narrower, so that they are gathered as much as they were.
    """
    holder = _by_face(cutter, cutter.anatomy.seam(_HOLDERS, LOWER_PARTS).own)
    part = Part.TROUSER if donor.anatomy.has(Part.TROUSER) else Part.SKIRT
    tops, seam = upper_edges(donor.anatomy, part)
    own = _by_face(donor, tops)
    if holder is None or own is None:
        return None
    names = donor.names(*LOWER_PARTS)
    held = seam.other_length if seam.pairs else _length(donor, own)
    half = _cut_to(_only(donor.pattern, names), _length(cutter, holder) / max(held, 1.0))
    if half is None:
        return None
    bench = Workbench(cutter.pattern)
    upper = {face: [bench.at[r] for r in refs] for face, refs in holder.items()}
    bench.remove(cutter.names(*LOWER_PARTS))
    return _joined(bench, half, own, upper, cutter, new_is_lower=True)


def upper_from(cutter: Cutter, donor: Cutter) -> Pattern | None:
    """Bodice with all that is sewn to it taken off, and that of another pattern sewn to skirt or trousers."""
    below = _HOLDERS - {Part.TORSO} | LOWER_PARTS
    holder = _by_face(cutter, cutter.anatomy.seam(below, Part.TORSO).own)
    own = _by_face(donor, donor.anatomy.seam(Part.TORSO, below).own)
    if holder is None or own is None:
        return None
    held = donor.anatomy.seam(Part.TORSO, below).other_length
    half = _cut_to(_only(donor.pattern, donor.names(*UPPER_PARTS)), _length(cutter, holder) / max(held, 1.0))
    # A bodice that was made wider is another bodice: only one that fits nearly as it is will do.
    if half is None or abs(_length(cutter, holder) / max(held, 1.0) - 1.0) > _FITS * 8:
        return None
    bench = Workbench(cutter.pattern)
    lower = {face: [bench.at[r] for r in refs] for face, refs in holder.items()}
    bench.remove(cutter.names(*UPPER_PARTS))
    return _joined(bench, half, own, lower, cutter, new_is_lower=False)


def _joined(
    bench: Workbench,
    half: Pattern,
    own: _Edges,
    kept: dict[Face, list[int]],
    cutter: Cutter,
    *,
    new_is_lower: bool,
) -> Pattern | None:
    laid = lay_pattern(bench, half)
    if laid is None:
        return None
    new = {face: [laid[r] for r in refs] for face, refs in own.items()}
    upper, lower = (kept, new) if new_is_lower else (new, kept)
    rise = _level(bench, upper) - _BELOW_CM - _level(bench, lower)
    below = (
        [p.name for p in half.panels]
        if new_is_lower
        else [n for n in bench.pieces if n not in {p.name for p in half.panels}]
    )
    bench.shift(below, [0.0, rise, 0.0])
    band = cutter.anatomy.has(Part.WAISTBAND)
    for face in _FACES:
        for side in new[face]:
            bench.relabel(side, WAIST_LABEL if new_is_lower and not band else "")
        if not sew_across(bench, upper[face], lower[face]):
            return None
    return bench.pattern()


def _only(pattern: Pattern, names: Sequence[str]) -> Pattern:
    """Some of the panels, sewn to each other as they are."""
    kept = set(names)
    panels: list[Panel] = [p for p in pattern.panels if p.name in kept]
    stitches: list[Stitch] = [s for s in pattern.stitches if s.first.panel in kept and s.second.panel in kept]
    return replace(pattern, panels=tuple(panels), stitches=tuple(stitches))


def _cut_to(half: Pattern, factor: float) -> Pattern | None:
    if not 1 / _MOST_STRETCHED <= factor <= _MOST_STRETCHED:
        return None
    if abs(factor - 1.0) <= _FITS:
        return half
    wider = widen_panels(half, [p.name for p in half.panels], factor)
    # Arcs that sweep far cannot be stretched: the fullness is eased into the seam.
    return half if wider is None and abs(factor - 1.0) <= _EASED else wider


def _by_face(cutter: Cutter, refs: Sequence[EdgeRef]) -> _Edges | None:
    """Edges by face; None where a face has none."""
    found: _Edges = {face: [] for face in _FACES}
    for ref in refs:
        found[cutter.anatomy.parts[ref.panel].face].append(ref)
    return found if all(found.values()) else None


def _length(cutter: Cutter, edges: _Edges) -> float:
    return sum(cutter.anatomy.edge_length(r) for refs in edges.values() for r in refs)


def _level(bench: Workbench, sides: dict[Face, list[int]]) -> float:
    heights = [
        float(bench.piece_of(s).panel.to_world(bench.piece_of(s).chord(s))[:, 1].mean())
        for own in sides.values()
        for s in own
    ]
    return sum(heights) / len(heights)
