"""Refitting: a pattern that was drafted for one body, made for another.

The pattern is sewn on the body that it was drafted for, which tells where on it each part of each panel lies.
Each place of the cloth then takes on as many centimetres in width as the body does there, and grows in length
as the body does (`stretch`); the flat panels that come nearest are found as one sheet each (`growing`), and
their outlines are drawn with the same kinds of edges (`outlines`). Seams keep the ratio of their sides, and
what was alike stays alike.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.body import Body
from swifttailor.garment.garment import Garment
from swifttailor.pattern import Pattern
from swifttailor.refitting.alike import Likeness, find_likeness, made_alike
from swifttailor.refitting.body_profile import profile_of
from swifttailor.refitting.even_lengths import keep_seam_ratios
from swifttailor.refitting.growing import PanelSheet
from swifttailor.refitting.outlines import moved_panel
from swifttailor.refitting.placing import placed_on
from swifttailor.refitting.shaped_seams import curved, shaped_seams, straightened
from swifttailor.refitting.stretch import Stretches, ease_scale, places_of, stretches
from swifttailor.refitting.uncrossed import damaged, uncrossed

_EDGE_CM = 2.5
"""Of the mesh on which places are looked up."""
_AMOUNTS_CM, _DIRECTIONS_CM = 2.0, 6.0
"""Over what distances on the cloth amounts and directions are evened out."""
_ROUNDS = 9
"""Of growing the panels and measuring what came of it."""
_BAND_CM = 9.0
"""Panels that are lower are bands."""
_CLEAR = 0.15
"""Where cloth lies flatter than this to the body's length, its neighbours tell the direction."""

Sewing = Callable[[Pattern], Garment]


@dataclass(frozen=True, eq=False)
class Refitted:
    """A pattern for another body, and what it came from."""

    pattern: Pattern
    sewn: Garment
    """The garment of the pattern before, on the body that that was drafted for."""
    flat_positions: Floats
    """(m, 2) where the flat vertices of `sewn` lie in the new panels, cm."""


def refit(
    pattern: Pattern,
    body: Body,
    *,
    drafted_for: Body | None = None,
    sewn: Garment | None = None,
    sew: Sewing | None = None,
) -> Refitted:
    """Refits a pattern to another body and keeps what it was made from; see `fit`.

    Args:
        pattern: Any pattern that can be sewn.
        body: Whom it is made for.
        drafted_for: Whom it was drafted for; the body that the pattern names, or the default body when None.
        sewn: Its garment on that body, where it has been made already.
        sew: What makes that garment; the package's own GarmentSewer when None.

    Raises:
        PatternError: The pattern cannot be sewn.
        InputError: A body cannot be measured.
    """
    from swifttailor.body.wearer import body_of
    from swifttailor.refitting.first_body import sewn_on

    first = body_of(pattern.drafted_for) if drafted_for is None else drafted_for
    garment = sewn if sewn is not None else (sew or sewn_on(first, _EDGE_CM))(pattern)
    start, end = profile_of(first), profile_of(body)
    before = garment.pattern
    likeness = find_likeness(before)
    stretch = stretches(garment, places_of(garment, start), start, end)
    stretch = _bands_kept(garment, stretch, ease_scale(start, end))
    along = places_of(garment, start).along
    sheets = [_Sheet(garment, number, along) for number in range(len(before.panels))]
    shaped = shaped_seams(before, likeness)
    rounds: list[tuple[Pattern, Floats]] = []
    for _ in range(_ROUNDS):
        grown = _grown(garment, sheets, stretch)
        after = made_alike(_with_outlines(garment, grown, shaped), likeness)
        after = made_alike(keep_seam_ratios(before, after), likeness)
        flat = _filled(garment, sheets, grown, after)
        stretch = stretch.corrected(garment.mesh, flat)
        rounds.append((after, flat))
    after, flat = _last_sound(before, rounds, likeness, shaped)
    after = placed_on(before, after, start, end)
    after = made_alike(after, likeness)
    order = {panel.name: panel for panel in after.panels}
    panels = tuple(order[panel.name] for panel in pattern.panels)
    # Edges keep their numbers, so the stitches are those of the pattern that was given.
    result = replace(pattern, panels=panels, drafted_for=body.made_for)
    return Refitted(result, garment, flat)


def fit(
    pattern: Pattern, body: Body, *, drafted_for: Body | None = None, sewn: Garment | None = None
) -> Pattern:
    """Refits a pattern that was drafted for one body to another.

    Ease, style lines and proportions are kept; seams that were equally long stay so, and what is symmetric
    stays symmetric. Panels, edges and stitches keep their names and numbers.

    Args:
        pattern: Any pattern that can be sewn.
        body: Whom it is made for.
        drafted_for: Whom it was drafted for; the body that the pattern names, or the default body when None.
        sewn: Its garment on that body, where it has been made already; made when None.

    Returns:
        The pattern for `body`.

    Raises:
        PatternError: The pattern cannot be sewn.
        InputError: A body cannot be measured.
    """
    return refit(pattern, body, drafted_for=drafted_for, sewn=sewn).pattern


def _bands_kept(garment: Garment, stretch: Stretches, scale: float) -> Stretches:
    """Waistbands, cuffs and collars stay as high as they are; on a smaller person they are lower."""
    mesh = garment.mesh
    along = stretch.along.copy()
    for number, panel in enumerate(mesh.pattern.panels):
        if np.ptp(panel.outline(), axis=0).min() < _BAND_CM:
            along[mesh.flat_panel == number] = scale
    return replace(stretch, along=along)


def _last_sound(
    before: Pattern,
    rounds: list[tuple[Pattern, Floats]],
    likeness: Likeness,
    shaped: frozenset[tuple[int, int]],
) -> tuple[Pattern, Floats]:
    """The last round after which no panel is `damaged`; the last one where some panel is after each."""
    settled = []
    for after, flat in reversed(rounds):
        even = made_alike(keep_seam_ratios(before, straightened(after, shaped)), likeness)
        settled.append((uncrossed(before, even, likeness), flat))
        if not damaged(before, settled[-1][0]):
            return settled[-1]
    return settled[0]


class _Sheet:
    """A panel of a garment as a sheet, and the directions in which it runs along the body."""

    def __init__(self, garment: Garment, number: int, along: Floats) -> None:
        mesh = garment.mesh
        self.own = np.flatnonzero(mesh.flat_panel == number)
        faces = mesh.flat_faces[mesh.face_panel == number]
        self.sheet = PanelSheet(mesh.flat_vertices[self.own], np.searchsorted(self.own, faces))
        direction = _directions(self.sheet, along[self.own])
        self.down = np.einsum("fa,fb->fab", direction, direction)


def _grown(garment: Garment, sheets: list[_Sheet], stretch: Stretches) -> Floats:
    """(m, 2) where the flat vertices lie in the grown panels."""
    result = np.array(garment.mesh.flat_vertices, np.float64)
    for one in sheets:
        sheet, own = one.sheet, one.own
        both = np.stack([stretch.around[own], stretch.along[own]], axis=1)
        amounts = sheet.smoothed(both, _AMOUNTS_CM)
        across, down = (amounts[sheet.faces, k].mean(axis=1) for k in (0, 1))
        wanted = across[:, None, None] * (np.eye(2) - one.down) + down[:, None, None] * one.down
        result[own] = sheet.grown(wanted)
    return result


def _filled(garment: Garment, sheets: list[_Sheet], grown: Floats, after: Pattern) -> Floats:
    """(m, 2) of the flat vertices once the outlines are settled: the inner ones go along with the border."""
    result = grown.copy()
    for number, (one, panel) in enumerate(zip(sheets, after.panels, strict=True)):
        moved = np.zeros_like(grown)
        border = np.zeros(len(grown), np.bool_)
        for k, edge in enumerate(garment.mesh.edge_vertices[number]):
            moved[edge] = panel.sample_edge(k, len(edge)) - grown[edge]
            border[edge] = True
        result[one.own] += one.sheet.spread(moved[one.own], border[one.own])
    return result


def _directions(sheet: PanelSheet, along: Floats) -> Floats:
    """(f, 2) unit directions in which the cloth runs along the body."""
    slope = sheet.slopes(along)
    steep = np.linalg.norm(slope, axis=1)
    # Steep cloth hangs along the body; what lies flat, as on a shoulder, says little.
    weight = sheet.area * np.clip(steep - _CLEAR, 0.0, 1.0) / np.maximum(steep, 1e-9) ** 2
    tensor = np.einsum("fa,fb,f->fab", slope, slope, weight).reshape(-1, 4)
    at_vertices = np.stack(
        [np.bincount(sheet.faces.ravel(), np.repeat(t / 3, 3), len(sheet.vertices)) for t in tensor.T], axis=1
    )
    even = sheet.smoothed(at_vertices / sheet.mass[:, None] + 1e-6 * np.array([0, 0, 0, 1]), _DIRECTIONS_CM)
    _, vectors = np.linalg.eigh(even[sheet.faces].mean(axis=1).reshape(-1, 2, 2))
    return vectors[:, :, 1]


def _with_outlines(garment: Garment, grown: Floats, shaped: frozenset[tuple[int, int]]) -> Pattern:
    """The pattern whose edges run where the edges' vertices went."""
    pattern = garment.pattern
    panels = []
    for number, panel in enumerate(pattern.panels):
        traces = [grown[edge] for edge in garment.mesh.edge_vertices[number]]
        free = curved(panel, frozenset(k for own, k in shaped if own == number))
        panels.append(moved_panel(free, traces))
    return replace(pattern, panels=tuple(panels))
