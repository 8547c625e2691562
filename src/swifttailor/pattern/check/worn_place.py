"""Whether the panels stand where a garment of their kind is worn, and which motion would bring them there.

GarmentCode places its panels around a body that stands on the floor in A-pose. Patterns of other programs may
have their origin in the middle of the body, a body in T-pose, or angles that are meant the other way.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.pattern.check.body_levels import BodyLevels
from swifttailor.pattern.check.covering import (
    Border,
    garment_borders,
    hangs_from_shoulders,
    is_band,
    is_neckwear,
    panel_regions,
    placed_edge,
    said_regions,
)
from swifttailor.pattern.check.limb_pose import LimbPose, judge_limbs
from swifttailor.pattern.check.outline import Outline, trace_outline
from swifttailor.pattern.panel import Placement, RotationReading
from swifttailor.pattern.pattern import EdgeRef, Pattern

_ABOVE_NECK_CM = 10.0
_BELOW_ARMPIT_CM = 24.0
_BELOW_HIPS_CM = 12.0
"""How far from there the top of a garment may be placed. On patterns of GarmentCode the top of a bodice panel
lies from 17 cm below the armpits to the base of the neck, that of skirts and trousers near the waist."""
_HOOD_CM = 45.0
"""How far above the neck a hood may end that is not called one."""
_TRAIN_CM = 15.0
"""How far below the floor cloth may be placed that is on it when worn."""
_SHOULDER_BELOW_NECK_CM = 3.0
_TOP_BELOW_ARMPIT_CM = 8.0
"""Where GarmentCode puts the top of a bodice with and without shoulders."""
_SHOULDER_REGION_CM = 16.0
_SPREAD_CM = 40.0
"""Panels that belong at one height differ by less."""
_ASIDE_CM = 40.0
_STRAY_CM = 75.0
_STRAY_BELOW_CM = 125.0
"""Nearest seam of a panel, above and below the waist; in GarmentCode's patterns it is at most 48 and 98 cm
away, giant flounces aside."""
_GIANT_CM = 250.0
_WORSE_CM = 3.0
_WORSE_SHARE = 0.15


@dataclass(frozen=True)
class Misread:
    """The placement angles fit better when they are read the other way."""

    reading: RotationReading
    """The one that fits."""
    gap: float
    """Mean distance of what is sewn together as the angles are read now, cm."""
    other_gap: float
    """The same, read the other way."""


@dataclass(frozen=True)
class Offset:
    """The whole garment stands beside where it is worn."""

    kind: str
    """What it is, in words: ``a bodice without shoulders``."""
    top: float
    """Height of its top as placed, cm."""
    belongs: float
    """Height where its top belongs, cm."""
    shift: tuple[float, float, float]
    """Motion that brings it there, cm."""


@dataclass(frozen=True)
class Stray:
    """One panel far from the others."""

    panel: str
    text: str
    value: float


@dataclass(frozen=True)
class WornPlace:
    """Everything found about where a pattern's panels stand; empty for one that stands where it is worn."""

    misread: Misread | None = None
    offset: Offset | None = None
    limbs: tuple[LimbPose, ...] = ()
    strays: tuple[Stray, ...] = ()


def judge_worn_place(
    pattern: Pattern, outlines: Mapping[str, Outline], single: Sequence[int], levels: BodyLevels
) -> WornPlace:
    """Compares the placement with where garments are worn.

    Args:
        pattern: Any pattern. One without seams, or whose panels were never placed, is not judged.
        outlines: Outline of each panel by name.
        single: Indices of the stitches that join two different, existing edges, each in no other stitch.
        levels: Of the body that it is placed around.
    """
    placed = any(any(p.placement.translation) or any(p.placement.rotation) for p in pattern.panels)
    if not single or not placed:
        return WornPlace()
    sewn = [k for k in single if len({ref.panel for ref in pattern.stitches[k].sides}) == 2]
    misread = _misread(pattern, sewn)
    if misread is not None:  # the rest is judged, and mended, as if the angles had been read well
        pattern = pattern.with_rotation_reading(misread.reading)
        outlines = {panel.name: trace_outline(panel) for panel in pattern.panels}
    offset, strays = _offset(pattern, outlines, levels)
    lost = {stray.panel for stray in strays}
    strays += [s for s in _far_from_seams(pattern, sewn) if s.panel not in lost]
    shift = (0.0, 0.0, 0.0) if offset is None else offset.shift
    limbs = judge_limbs(pattern, outlines, levels, np.asarray(shift))
    return WornPlace(misread, offset, limbs, tuple(strays))


def _seam_gaps(pattern: Pattern, sewn: Sequence[int]) -> Floats:
    """(k,) mean distance between the corners that each of some stitches joins, as placed, cm."""
    placed = {p.name: p.to_world(p.vertices) for p in pattern.panels}
    ends = np.array(
        [
            [placed[ref.panel][[ref.edge, (ref.edge + 1) % len(placed[ref.panel])]] for ref in stitch.sides]
            for stitch in (pattern.stitches[k] for k in sewn)
        ]
    ).reshape(-1, 2, 2, 3)
    together = np.array([pattern.stitches[k].right_wrong for k in sewn], bool)
    second = np.where(together[:, None, None], ends[:, 1], ends[:, 1, ::-1])
    return np.linalg.norm(ends[:, 0] - second, axis=2).mean(axis=1)


def _misread(pattern: Pattern, sewn: Sequence[int]) -> Misread | None:
    if not sewn or not any(_depends_on_reading(p.placement) for p in pattern.panels):
        return None
    reading = pattern.panels[0].placement.reading
    other: RotationReading = "extrinsic" if reading == "intrinsic" else "intrinsic"
    gap = float(_seam_gaps(pattern, sewn).mean())
    other_gap = float(_seam_gaps(pattern.with_rotation_reading(other), sewn).mean())
    worse = gap - other_gap
    return Misread(other, gap, other_gap) if worse > max(_WORSE_CM, _WORSE_SHARE * gap) else None


def _depends_on_reading(placement: Placement) -> bool:
    if sum(angle % 360.0 != 0.0 for angle in placement.rotation) < 2:
        return False
    intrinsic, extrinsic = (replace(placement, reading=r).matrix() for r in ("intrinsic", "extrinsic"))
    return not np.allclose(intrinsic, extrinsic, atol=1e-6)


def _offset(
    pattern: Pattern, outlines: Mapping[str, Outline], levels: BodyLevels
) -> tuple[Offset | None, list[Stray]]:
    """Where the top of the garment stands; the panels that make it, where they are apart from each other."""
    upper = hangs_from_shoulders(pattern)
    tops = _bodice_tops(pattern, outlines) if upper else _lower_tops(pattern, outlines)
    if not tops:
        return None, []
    if upper:
        lowest, highest = levels.armpit - _BELOW_ARMPIT_CM, levels.neck + _ABOVE_NECK_CM
        belongs, kind = _top_of_bodice(pattern, outlines, tops, levels)
    else:
        lowest, highest, belongs = levels.hips - _BELOW_HIPS_CM, levels.armpit, levels.waist
        kind = "a skirt or trousers"
    guessed = _kind_is_guessed(pattern, upper)
    bottom = min(float(outline.world[:, 1].min()) for outline in outlines.values())
    if guessed and bottom > -_TRAIN_CM:  # what could be worn there as either is right, hood and all
        lowest, highest = levels.hips - _BELOW_HIPS_CM, levels.neck + _HOOD_CM
    around = np.concatenate([outlines[name].world[:, [0, 2]] for name in tops])
    low, high = around.min(axis=0), around.max(axis=0)
    aside = (low + high) / 2 * ((low > _ASIDE_CM) | (high < -_ASIDE_CM))
    off = {name: not lowest <= top <= highest for name, top in tops.items()}
    together = max(tops.values()) - min(tops.values()) <= _SPREAD_CM
    if all(off.values()) or (together and aside.any()):
        top = max(tops.values()) if upper else float(np.mean(list(tops.values())))
        up = belongs - top if all(off.values()) else 0.0
        return Offset(kind, top, belongs, (-float(aside[0]), up, -float(aside[1]))), []
    if together or guessed:  # at its edge, some a little beyond; or panels of several kinds
        return None, []
    strays = [
        Stray(
            name,
            f"its top is {height_in_words(tops[name])}; that of {kind} belongs at about {belongs:.0f} cm",
            round(tops[name], 1),
        )
        for name, is_off in off.items()
        if is_off
    ]
    return None, strays


def _kind_is_guessed(pattern: Pattern, upper: bool) -> bool:
    """Whether no panel says that this is a bodice, or not all say that it is none."""
    said = {name: region for name, region in said_regions(pattern).items() if not is_band(name)}
    if upper:
        return set(said.values()) <= {"leg"}
    return any(p.name not in said and not is_band(p.name) for p in pattern.panels)


def height_in_words(y: float) -> str:
    """Such as ``5 cm below the floor``."""
    return f"{abs(y):.0f} cm {'above' if y >= 0 else 'below'} the floor"


def _bodice_tops(pattern: Pattern, outlines: Mapping[str, Outline]) -> dict[str, float]:
    """Height of the highest corner of every panel of the bodice, cm."""
    regions = panel_regions(pattern)
    return {
        name: float(outlines[name].world[:, 1].max())
        for name, region in regions.items()
        if region == "body" and not is_band(name) and not is_neckwear(name)
    }


def _lower_tops(pattern: Pattern, outlines: Mapping[str, Outline]) -> dict[str, float]:
    """Mean height of the upper border on every panel that is part of it, cm."""
    borders = garment_borders(pattern)
    if not borders:
        return {}
    top: Border = max(borders, key=lambda b: b.middle[1])
    if len(borders) == 1:  # the hem runs on into it: only its upper part is meant
        return _highest_edges(top, outlines)
    own: dict[str, list[EdgeRef]] = {}
    for ref in top.edges:
        own.setdefault(ref.panel, []).append(ref)
    return {
        name: float(np.concatenate([placed_edge(outlines[name], r.edge) for r in refs])[:, 1].mean())
        for name, refs in own.items()
    }


def _highest_edges(border: Border, outlines: Mapping[str, Outline]) -> dict[str, float]:
    """For each panel at a border the height of its highest edge there, cm."""
    highest: dict[str, float] = {}
    for ref in border.edges:
        height = float(placed_edge(outlines[ref.panel], ref.edge)[:, 1].mean())
        highest[ref.panel] = max(height, highest.get(ref.panel, height))
    return highest


def _top_of_bodice(
    pattern: Pattern, outlines: Mapping[str, Outline], tops: Mapping[str, float], levels: BodyLevels
) -> tuple[float, str]:
    """Where the highest corner of a bodice belongs, cm, and what it is called."""
    highest = max(tops.values())
    for stitch in pattern.stitches:
        if not all(ref.panel in tops and pattern.has_edge(ref) for ref in stitch.sides):
            continue
        faces = {bool(outlines[ref.panel].normal[2] > 0) for ref in stitch.sides}
        ends = placed_edge(outlines[stitch.first.panel], stitch.first.edge)[[0, -1]]
        flat = abs(ends[1, 0] - ends[0, 0]) > abs(ends[1, 1] - ends[0, 1])
        if len(faces) == 2 and flat and ends[:, 1].mean() > highest - _SHOULDER_REGION_CM:
            return levels.neck - _SHOULDER_BELOW_NECK_CM, "a bodice with shoulders"
    return levels.armpit - _TOP_BELOW_ARMPIT_CM, "a bodice without shoulders"


def _far_from_seams(pattern: Pattern, sewn: Sequence[int]) -> list[Stray]:
    nearest: dict[str, float] = {}
    for k, gap in zip(sewn, _seam_gaps(pattern, sewn).tolist(), strict=True):
        for ref in pattern.stitches[k].sides:
            nearest[ref.panel] = min(gap, nearest.get(ref.panel, gap))
    regions = panel_regions(pattern)
    found = []
    for panel in pattern.panels:
        limit = _STRAY_BELOW_CM if regions[panel.name] == "leg" else _STRAY_CM
        gap = nearest.get(panel.name, 0.0)
        if gap > limit and float(np.ptp(panel.vertices, axis=0).max()) < _GIANT_CM:
            text = f"even its nearest seam starts {gap:.0f} cm away from what it is sewn to"
            found.append(Stray(panel.name, text, round(gap, 1)))
    return found
