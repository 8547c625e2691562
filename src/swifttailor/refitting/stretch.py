"""How much wider and longer each place of a garment becomes, from where it lies on the first body.

Widths take on as many cm as the body does there: what goes around keeps its ease, and what hangs from the
hips becomes as much wider as they do. Lengths follow the body's lengths. Above the armpits widths follow
shoulders and neck, and sleeves the arm.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from scipy.interpolate import PchipInterpolator

from swifttailor.arrays import Bools, Floats
from swifttailor.body.worn import legs_and_skirt
from swifttailor.garment.garment import Garment
from swifttailor.panel_mesh.pattern_mesh import PatternMesh
from swifttailor.pattern.check import panel_regions
from swifttailor.refitting.body_profile import ARM_PLACES, BodyProfile
from swifttailor.refitting.cloth_girths import cloth_around

_WHOLE = 0.6
"""Cloth of less of its usual width is cut into at that height, and is not measured there."""
_STEP_CM = 2.0
"""From one height to the next at which cloth is measured."""
_EVEN_CM = 3.0
"""Over so much height its width is averaged: folds are no more cloth."""
_SIDE_CM = 3.0
"""Front and back change into each other over so much depth at the sides."""
_BLEND_CM = 5.0
_PROFILE_SLICES = 2.0
"""Over so many slices of the trunk its profile is evened out."""
_EAGER, _EASY = 1.6, 0.6
"""How many times what is lacking is made up for: in close cloth more than once, since a sheet gives way to a
short bulge only in part; less where cloth hangs free."""
_LOOSE = 1.3
"""A skirt that is so many times as wide as both legs hangs from the hips."""
_CLOSE_EASE_CM, _FREE_EASE_CM = 10.0, 30.0
"""Up to so much ease cloth follows the body; from so much on it hangs free."""
_FREE_EVEN_CM = 12.0
"""Over so much height the growth of free cloth is averaged."""
_LEAST, _MOST = 0.4, 2.5
"""What cloth can be multiplied by."""
_CROTCH, _HIPS, _BUST, _ARMPIT, _SHOULDER, _NECK, _CROWN = 3, 4, 6, 7, 8, 9, 10


@dataclass(frozen=True, eq=False)
class GarmentPlaces:
    """Where the flat vertices of a garment lie on the body that wears it."""

    points: Floats
    """(m, 3) cm."""
    arm: Bools
    """(m,) in sleeves."""
    leg: Bools
    """(m,) in trouser legs, below the crotch or not."""
    down_arm: Floats
    """(m,) distance from the shoulder along the arm, cm."""

    @property
    def along(self) -> Floats:
        """(m,) which way the body runs there: height, or backward along the arm."""
        return np.where(self.arm, -self.down_arm, self.points[:, 1])


def places_of(garment: Garment, body: BodyProfile) -> GarmentPlaces:
    """Finds out where a garment's cloth lies.

    Args:
        garment: Sewn on the body.
        body: What it was sewn on.
    """
    mesh = garment.mesh
    points = garment.flat_positions
    region = panel_regions(garment.pattern)
    arms = np.array([region[p.name] == "arm" for p in garment.pattern.panels])[mesh.flat_panel]
    on_leg = np.array([region[p.name] == "leg" for p in garment.pattern.panels])[mesh.flat_panel]
    _, skirt = legs_and_skirt(garment.vertices, garment.faces)
    trousers = on_leg & ~skirt[mesh.weld]
    mirrored = points * np.where(points[:, :1] < 0, [-1.0, 1.0, 1.0], 1.0)
    return GarmentPlaces(points, arms, trousers, (mirrored - body.shoulder) @ body.arm_axis)


@dataclass(frozen=True, eq=False)
class Ring:
    """Cloth that goes around one part of the body, and how wide it shall be."""

    along: Floats
    """(m,) of every flat vertex, how far along that part it lies, cm."""
    members: Bools
    """(m,) the flat vertices whose cloth counts."""
    moved: Bools
    """(m,) those whose stretch it decides; each belongs to one ring alone."""
    faces: Bools
    """(f,) the faces that count."""
    places: Floats
    """(p,) where it is measured, along the part."""
    wanted: Floats
    """(p,) cm; 0 where there is no cloth."""
    free: Floats
    """(p,) from 0, cloth close to the body, to 1, cloth that hangs free of it."""


@dataclass(frozen=True, eq=False)
class Stretches:
    """What a garment's cloth is multiplied by for another body."""

    around: Floats
    """(m,) across the body, at every flat vertex."""
    along: Floats
    """(m,) the way the body runs."""
    rings: tuple[Ring, ...]
    """What comes of it, to be measured."""

    def corrected(self, mesh: PatternMesh, flat: Floats) -> Stretches:
        """The stretches that make up for what rings lack.

        Args:
            mesh: Of the garment.
            flat: (m, 2) where the flat vertices came to lie, cm.
        """
        grown = replace(mesh, flat_vertices=flat)
        around = self.around.copy()
        for ring in self.rings:
            got = cloth_around(grown, ring.along, ring.faces, ring.places, (ring.members,))[:, 0]
            there = (got > 0) & (ring.wanted > 0)
            if not there.any():
                continue
            lack = np.clip(ring.wanted[there] / got[there], 0.8, 1.25)
            lack **= _EAGER + (_EASY - _EAGER) * ring.free[there]
            factor = np.interp(ring.along, ring.places[there], lack)
            around = np.where(ring.moved, around * factor, around)
        return replace(self, around=np.clip(around, _LEAST, _MOST))


def stretches(garment: Garment, places: GarmentPlaces, start: BodyProfile, end: BodyProfile) -> Stretches:
    """What the cloth is multiplied by around and along the body.

    Args:
        garment: On the first body.
        places: Where it lies there.
        start: The body that it was drafted for.
        end: The body that it is refitted to.
    """
    around, along, rings = _trunk(garment, places, start, end)
    if places.leg.any():
        below, leg, more = _legs(garment, places, start, end)
        around = around + below * (leg - around)
        rings += more
    if places.arm.any():
        sleeve, more = _sleeves(garment, places, start, end)
        around = np.where(places.arm, sleeve, around)
        arm_length = end.measurements.arm_length / start.measurements.arm_length
        along = np.where(places.arm, arm_length, along)
        rings += more
    return Stretches(np.clip(around, _LEAST, _MOST), np.clip(along, _LEAST, _MOST), tuple(rings))


def ease_scale(start: BodyProfile, end: BodyProfile) -> float:
    """What ease is multiplied by: a child's is less, as the child is smaller."""
    return end.measurements.height / start.measurements.height


def wanted_width(cloth: Floats, girth: Floats, other: Floats, scale: float) -> Floats:
    """How wide cloth shall be that goes around a body.

    Args:
        cloth: (n,) its width on the first body, cm.
        girth: (n,) of the first body there.
        other: (n,) of the second body there.
        scale: What ease is multiplied by.

    Returns:
        (n,) cm: the second body's girth and the ease; what does not go around keeps its share of the girth.
    """
    return np.where(cloth >= girth, other + scale * (cloth - girth), cloth * other / np.maximum(girth, 1e-6))


def height_map(start: BodyProfile, end: BodyProfile) -> PchipInterpolator:
    """Heights on the first body to heights on the second, each landmark to the same."""
    low, high = start.levels, end.levels
    rise = (high[-1] - high[-2]) / (low[-1] - low[-2])
    return PchipInterpolator(
        np.concatenate([[low[0] - 20.0], low, [low[-1] + 30.0]]),
        np.concatenate([[high[0] - 20.0], high, [high[-1] + 30.0 * rise]]),
    )


def _trunk(
    garment: Garment, places: GarmentPlaces, start: BodyProfile, end: BodyProfile
) -> tuple[Floats, Floats, list[Ring]]:
    y, z = places.points[:, 1], places.points[:, 2]
    levels = start.levels
    depth = np.interp(y, start.heights, start.side)
    ahead = _ramp((z - depth) / _SIDE_CM)
    counted = ~places.arm
    heights = np.arange(y[counted].min(), y[counted].max() + _STEP_CM, _STEP_CM) if counted.any() else y[:1]
    is_front = counted & (ahead > 0.5)
    faces = np.asarray(counted[garment.mesh.flat_faces].all(axis=1))
    parts = (is_front, counted & ~is_front)
    own = ~(places.leg & (y < levels[_CROTCH]))
    raw = cloth_around(garment.mesh, y, faces, heights, parts)
    cloth = _evened(raw, _EVEN_CM, raw > 0)
    # What hangs below the hips grows as the hips do, and up to the armhole all grows as the chest does: side
    # seams are straight there, and it is the fullest place that has to fit.
    at = np.clip(heights, levels[_HIPS], levels[_BUST])
    more, rings, scale = [], [], ease_scale(start, end)
    # A narrow skirt goes around the legs and not down from the hips.
    both = np.interp(heights, start.heights, start.girth)
    tight = (heights < levels[_HIPS]) * np.clip(
        (_LOOSE - cloth.sum(axis=1) / both) / (_LOOSE - 1.0), 0.0, 1.0
    )
    ringed = (heights > levels[_CROTCH]) if places.leg.any() else np.ones(len(heights), np.bool_)
    ringed &= heights < levels[_ARMPIT] - 1.0
    # It goes around where front and back together do, wherever the side seams lie.
    ease = cloth.sum(axis=1) - np.interp(at, start.heights, start.girth)
    goes = ease >= 0.0
    # What hangs free of the body does not follow its every curve: its seams would wave.
    free = _freedom(ease)
    for k, name in enumerate(("front", "back")):
        hanging, close = (
            _wider(
                cloth[:, k],
                *(np.interp(h, start.heights, getattr(b, name)) for b in (start, end)),
                scale,
                goes,
            )
            for h in (at, np.minimum(heights, at[-1]))
        )
        there = cloth[:, k] > 0
        growth = (1 - tight) * hanging + tight * close
        growth += free * (_evened(growth, _FREE_EVEN_CM, there) - growth)
        wanted = cloth[:, k] + growth
        ratio = wanted / np.maximum(cloth[:, k], 1e-6)
        ratio = np.where(there, ratio, np.interp(at, start.heights, end.girth / start.girth))
        more.append(np.interp(y, heights, ratio))
        # Widths that were evened out would give the waist too little, and the seat too much.
        exact = np.where(goes, raw[:, k] + wanted - cloth[:, k], raw[:, k] * ratio)
        full = raw[:, k] > _WHOLE * cloth[:, k]
        wide = np.where(full, exact, 0.0)[ringed]
        rings.append(Ring(y, parts[k], parts[k] & own, faces, heights[ringed], wide, free[ringed]))
    around = ahead * more[0] + (1 - ahead) * more[1]
    around = _shoulders(places, start, end, around)
    rising = height_map(start, end).derivative()(np.clip(y, -5.0, levels[-1] + 20.0))
    return around, rising * _over_the_middle(places, start, end), rings


def _wider(cloth: Floats, girth: Floats, other: Floats, scale: float, goes: Bools) -> Floats:
    """How much wider (n,) part of the cloth becomes, cm: as the body there, or by its share of the girth."""
    more = other + scale * (cloth - girth) - cloth
    return np.where(goes, more, cloth * (other / girth - 1.0))


def _shoulders(places: GarmentPlaces, start: BodyProfile, end: BodyProfile, around: Floats) -> Floats:
    """Above the armpits widths go over to those of shoulders, neck and head."""
    y, across = places.points[:, 1], np.abs(places.points[:, 0])
    a, b = start.measurements, end.measurements
    neck = b.neck_w / a.neck_w
    shoulder = (b.shoulder_w - b.neck_w) / (a.shoulder_w - a.neck_w)
    out = _ramp((across - a.neck_w / 2) / 2.0)
    upper = out * shoulder + (1 - out) * neck
    levels = start.levels
    rise = np.clip((y - levels[_ARMPIT]) / (levels[_SHOULDER] - levels[_ARMPIT]), 0.0, 1.0)
    widths = (1 - rise) * around + rise * upper
    head = np.clip((y - levels[_NECK]) / (levels[_CROWN] - levels[_NECK]) * 3.0, 0.0, 1.0)
    return (1 - head) * widths + head * (b.head_l / a.head_l)


def _over_the_middle(places: GarmentPlaces, start: BodyProfile, end: BodyProfile) -> Floats:
    """(m,) how much more chest, belly and back lengthen the middle than the body is longer there.

    Cloth lies over them as over a drum: along the convex hull of the profile. Side seams hang straight down.
    """
    x, y, z = places.points.T
    half = np.interp(y, start.heights, start.half_width)
    front = _ramp((z - np.interp(y, start.heights, start.side)) / _SIDE_CM)
    middle = np.clip(2.0 - 2.0 * np.abs(x) / np.maximum(half, 1.0), 0.0, 1.0)
    longer = [
        np.interp(y, start.heights, _slant(end, name) / _slant(start, name), right=1.0)
        for name in ("ahead", "behind")
    ]
    both = front * longer[0] + (1 - front) * longer[1]
    return 1.0 + (both - 1.0) * middle * ~places.arm


def _slant(body: BodyProfile, name: str) -> Floats:
    """(n,) length of the profile's convex hull over a centimetre of height, from the hips to the armpits."""
    from scipy.ndimage import gaussian_filter1d
    from scipy.spatial import ConvexHull

    above = np.flatnonzero(body.heights >= body.levels[_HIPS])
    points = np.stack([body.heights[above], getattr(body, name)[above]], axis=1)
    neck = [body.levels[_NECK], 0.35 * points[-1, 1]]
    closed = np.concatenate([points, [neck, [neck[0], -20.0], [points[0, 0], -20.0]]])
    corners = closed[[k for k in ConvexHull(closed).vertices if closed[k, 1] > -19.0]]
    corners = corners[np.argsort(corners[:, 0])]
    out = np.interp(points[:, 0], *corners.T)
    slope = np.gradient(out, points[:, 0])
    result = np.ones(len(body.heights))
    result[above] = gaussian_filter1d(np.sqrt(1.0 + slope**2), _PROFILE_SLICES, mode="nearest")
    return result


def _legs(
    garment: Garment, places: GarmentPlaces, start: BodyProfile, end: BodyProfile
) -> tuple[Floats, Floats, list[Ring]]:
    """How far the vertices belong to legs by themselves (m,), and what their cloth is multiplied by (m,)."""
    y, x = places.points[:, 1], places.points[:, 0]
    crotch = start.levels[_CROTCH]
    # The legs of the shortest shorts end above the crotch.
    heights = np.arange(min(y[places.leg].min(), crotch), crotch + _STEP_CM, _STEP_CM)
    faces = np.asarray(places.leg[garment.mesh.flat_faces].all(axis=1))
    parts = places.leg & (x > 0), places.leg & (x <= 0)
    raw = cloth_around(garment.mesh, y, faces, heights, parts)
    cloth = _evened(raw, _EVEN_CM, raw > 0)
    # The same place of the other leg: as many slices between two landmarks.
    girth, other = (np.interp(heights, start.leg_heights, body.leg) for body in (start, end))
    sides, rings = [], []
    ringed = heights < crotch - _BLEND_CM
    for k in (0, 1):
        wanted = wanted_width(cloth[:, k], girth, other, ease_scale(start, end))
        ratio = np.where(cloth[:, k] > 0, wanted / np.maximum(cloth[:, k], 1e-6), other / girth)
        sides.append(np.interp(y, heights, ratio))
        members = parts[k] & (y < crotch)
        wide, free = (raw[:, k] * ratio)[ringed], _freedom(cloth[:, k] - girth)[ringed]
        rings.append(Ring(y, members, members, faces, heights[ringed], wide, free))
    leg = np.where(x > 0, sides[0], sides[1])
    below = places.leg * _ramp((crotch - y) / _BLEND_CM)
    return below, leg, rings


def _sleeves(
    garment: Garment, places: GarmentPlaces, start: BodyProfile, end: BodyProfile
) -> tuple[Floats, list[Ring]]:
    """What the cloth of sleeves is multiplied by around the arm (m,)."""
    down, x = places.down_arm, places.points[:, 0]
    faces = np.asarray(places.arm[garment.mesh.flat_faces].all(axis=1))
    along = ARM_PLACES * start.measurements.arm_length
    parts = places.arm & (x > 0), places.arm & (x <= 0)
    cloth = cloth_around(garment.mesh, down, faces, along, parts)
    sides, rings = [], []
    for k in (0, 1):
        wanted = wanted_width(cloth[:, k], start.arm, end.arm, ease_scale(start, end))
        ratio = np.where(cloth[:, k] > 0, wanted / np.maximum(cloth[:, k], 1e-6), end.arm / start.arm)
        reached = np.flatnonzero(cloth[:, k] > 0)
        # Short sleeves end before the first place; there they are as wide as the arm.
        last = reached[-1] + 1 if len(reached) else 1
        sides.append(np.interp(down, along[:last], ratio[:last]))
        free = _freedom(cloth[:, k] - start.arm)
        rings.append(Ring(down, parts[k], parts[k], faces, along, wanted, free))
    return np.where(x > 0, sides[0], sides[1]), rings


def _freedom(ease: Floats) -> Floats:
    """From 0, close to the body, to 1, free of it."""
    return np.clip((ease - _CLOSE_EASE_CM) / (_FREE_EASE_CM - _CLOSE_EASE_CM), 0.0, 1.0)


def _evened(widths: Floats, reach: float, there: Bools) -> Floats:
    """Widths (h, g) averaged over so many cm of height; where there is no cloth nothing counts."""
    from scipy.ndimage import gaussian_filter1d

    known, weight = (
        gaussian_filter1d(values, reach / _STEP_CM, axis=0, mode="constant")
        for values in (np.where(there, widths, 0.0), there.astype(float))
    )
    return known / np.maximum(weight, 1e-3)


def _ramp(value: Floats) -> Floats:
    """From 0 at -1 to 1 at 1, without a kink."""
    t = np.clip(value / 2 + 0.5, 0.0, 1.0)
    return t * t * (3 - 2 * t)
