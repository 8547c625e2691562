"""Findings about where the panels stand: distance, facing, inside the body; and the pattern's whole size."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np
import shapely

from swifttailor.arrays import Floats
from swifttailor.errors import PatternError
from swifttailor.pattern.check.body_levels import BodyLevels
from swifttailor.pattern.check.outline import Outline
from swifttailor.pattern.check.seam_direction import Directions
from swifttailor.pattern.check.worn_place import WornPlace, height_in_words
from swifttailor.pattern.finding import Finding, Severity
from swifttailor.pattern.finding_kinds import found
from swifttailor.pattern.pattern import Pattern

SignedDistance = Callable[[Floats], Floats]
"""Takes points (n, 3) in cm, gives distances (n,) in cm to the body, negative inside."""

TINY_CM = 5.0
ABSURDLY_TINY_CM = 1.0
FAR_CM = 300.0
DEEP_CM = 1.0
INSIDE_SHARE = 0.25

_GRID = 10


@dataclass(frozen=True)
class BodyProbe:
    """What the checks need to know of a body."""

    signed_distance: SignedDistance
    bottom: float = 0.0
    """Height of the soles, cm."""
    top: float = 180.0
    """Height of the crown, cm."""
    levels: BodyLevels = field(default_factory=BodyLevels)
    """Where garments are worn on it."""


def body_probe(body: BodyProbe | SignedDistance | None) -> BodyProbe | None:
    """What is known of a body whose signed distance may be all that was given."""
    return body if body is None or isinstance(body, BodyProbe) else BodyProbe(body)


def check_placement(
    outlines: dict[str, Outline], directions: Directions, place: WornPlace, probe: BodyProbe | None
) -> list[Finding]:
    """All findings about placements."""
    findings = [*_facing(directions), *_worn(outlines, place)]
    for outline in outlines.values():
        findings += _far(outline, probe)
        if probe is not None:
            findings += _inside(outline, probe)
    return findings


def check_size(pattern: Pattern, outlines: dict[str, Outline]) -> list[Finding]:
    """A finding when even the largest panel is too small for any garment."""
    largest = max((o.size for o in outlines.values()), default=0.0)
    if not pattern.panels or largest >= TINY_CM:
        return []
    text = f"the largest panel is only {largest:.2g} cm long"
    severity = Severity.ERROR if largest < ABSURDLY_TINY_CM else Severity.WARNING
    return [found("tiny-pattern", text, value=largest, severity=severity)]


def _facing(directions: Directions) -> list[Finding]:
    findings = [
        found(
            "inside-out-panel",
            "the right side of the cloth faces the body",
            panel=p.panel,
            value=round(p.outward, 3),
            repair="--repair reverses the loop, which also sets its seams right"
            if p.reversible
            else "turn the panel's placement, or reverse its loop if its seams are wrong too",
        )
        for p in directions.inward
    ]
    findings += [
        found(
            "turned-panel",
            "every seam of the panel runs against the placement, though the seams fit each other",
            panel=name,
            value=round(agreement, 3),
        )
        for name, agreement in directions.turned_panels
    ]
    return findings


def _worn(outlines: dict[str, Outline], place: WornPlace) -> list[Finding]:
    findings = []
    if place.misread is not None:
        other = place.misread.reading
        text = (
            f"read as {other} angles, the panels would stand {place.misread.other_gap:.0f} cm apart at their "
            f"seams on average instead of {place.misread.gap:.0f}"
        )
        repair = f"--repair writes the angles anew; --rotation {other} reads them so"
        findings.append(found("misread-angles", text, value=other, repair=repair))
    if place.offset is not None:
        where = place.offset
        text = f"the garment's top is {height_in_words(where.top)}; that of {where.kind} belongs at about "
        text += f"{where.belongs:.0f} cm"
        if any(where.shift[::2]):
            text += f". It stands {np.hypot(where.shift[0], where.shift[2]):.0f} cm beside the body"
        repair = f"--repair moves the whole pattern by {motion_in_words(where.shift)}"
        value = round(where.top, 1)
        findings += [
            found("misplaced-panel", text, panel=name, value=value, repair=repair) for name in outlines
        ]
    findings += [found("misplaced-panel", s.text, panel=s.panel, value=s.value) for s in place.strays]
    for pose in place.limbs:
        code = "high-sleeve" if pose.limb == "sleeve" else "spread-leg"
        body = "arm" if pose.limb == "sleeve" else "leg"
        text = f"the {pose.limb} points {pose.angle:.0f} degrees below the horizontal, "
        text += f"the body's {body} {pose.body_angle:.0f}"
        findings += [found(code, text, panel=name, value=round(pose.angle, 1)) for name in pose.panels]
    return findings


def motion_in_words(shift: tuple[float, float, float]) -> str:
    """A motion in words, such as ``113.8 cm up``."""
    x, y, z = shift
    ways = [(y, "up", "down"), (x, "to the left", "to the right"), (z, "forward", "back")]
    return ", ".join(f"{abs(d):.1f} cm {plus if d > 0 else minus}" for d, plus, minus in ways if d)


def _far(outline: Outline, probe: BodyProbe | None) -> list[Finding]:
    bottom, top = (probe.bottom, probe.top) if probe else (0.0, 180.0)
    heights = outline.world[:, 1]
    sideways = float(np.hypot(outline.world[:, 0], outline.world[:, 2]).min())
    distance = max(sideways, float(heights.min()) - top, bottom - float(heights.max()))
    if distance <= FAR_CM:
        return []
    text = f"the panel is placed {distance:.0f} cm away from the body"
    return [found("far-placement", text, panel=outline.panel.name, value=distance)]


def _inside(outline: Outline, probe: BodyProbe) -> list[Finding]:
    points = outline.panel.to_world(_spread_points(outline))
    distances = np.asarray(probe.signed_distance(points), float)
    if distances.shape != (len(points),):
        raise PatternError(
            f"check_pattern(body=...): the signed distance of {len(points)} points must have the shape "
            f"({len(points)},), got {distances.shape}. Pass a callable that gives one distance per point."
        )
    share = float((distances < -DEEP_CM).mean())
    if share <= INSIDE_SHARE:
        return []
    text = f"{share:.0%} of the panel is placed inside the body, up to {-distances.min():.1f} cm deep"
    return [found("inside-body", text, panel=outline.panel.name, value=share)]


def _spread_points(outline: Outline) -> Floats:
    """Corners and a grid of inner points (n, 2), panel-local cm."""
    low, high = outline.points.min(axis=0), outline.points.max(axis=0)
    steps = [np.linspace(a, b, _GRID + 2)[1:-1] for a, b in zip(low, high, strict=True)]
    grid = np.stack(np.meshgrid(*steps), axis=-1).reshape(-1, 2)
    corners = outline.panel.vertices
    if len(outline.points) < 3:
        return corners
    polygon = shapely.polygons(outline.points)
    return np.concatenate([corners, grid[shapely.contains_xy(polygon, grid[:, 0], grid[:, 1])]])
