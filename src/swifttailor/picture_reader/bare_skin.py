"""Whether pieces of somebody's arms and legs are bare, by the colours of their face and of their clothes.

Networks for clothes look at a whole person in 192 pixels, in which a sleeve that ends at the elbow is one
edge among many. The joints say where a forearm is; it is bare if it looks like the face, and covered if it
looks like what is on the chest.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from swifttailor.arrays import Array, Pixels
from swifttailor.picture_reader.body_joints import (
    ANKLES,
    ELBOWS,
    EYES,
    HIPS,
    KNEES,
    LEAST_SEEN,
    MOUTH,
    NOSE,
    SHOULDERS,
    WRISTS,
    BodyJoints,
)
from swifttailor.render.lab import lab_of_linear, linear_of_srgb

UPPER_ARM, FOREARM, HAND_END = (0.3, 0.45, 0.6), (1.15, 1.3, 1.45), (1.5, 1.65, 1.8, 1.95)
"""Where arms are looked at: 0 is the shoulder, 1 the elbow, 2 the wrist."""
SHIN = (1.15, 1.3, 1.45, 1.6)
"""Where legs are: 0 is the hip, 1 the knee, 2 the ankle."""
_LIGHTNESS = 0.3
"""Weight of lightness in distances of colours: pieces of one skin are lit differently."""
_SOFT = 3.0
"""Distances of Lab below this are about the same."""
_RADIUS_ARM, _RADIUS_LEG, _RADIUS_CHEST, _RADIUS_FACE = 0.1, 0.08, 0.06, 0.45
"""Of discs: in upper arms, thighs, torsos and from the eyes to the mouth."""
_LEAST_FACE, _LEAST_RADIUS, _LEAST_PIXELS = 2.0, 2.0, 4
_CHEST_DOWN, _CHEST_OUT = (0.25, 0.45, 0.65), 0.65
"""Where the torso is looked at: down from the shoulders to the hips, and out from the middle to a side."""


@dataclass(frozen=True)
class LimbColours:
    """How the pieces of one limb, or the mean of those that are seen of it, look.

    Logarithms of distances of Lab, `_SOFT` added: to the face and to what is nearest on the torso.
    """

    to_face: float
    to_cloth: float


@dataclass(frozen=True, eq=False)
class BareSkin:
    """Looks at the limbs of somebody in a photograph."""

    pixels: Pixels
    """(h, w, 3) sRGB."""
    mask: NDArray[np.bool_]
    """(h, w) which show somebody."""
    joints: BodyJoints
    face: Array
    """(3,) Lab."""
    cloth: Array
    """(n, 3) Lab of what is on the torso, at least one."""

    @staticmethod
    def of(pixels: Pixels, mask: NDArray[np.bool_], joints: BodyJoints) -> BareSkin | None:
        """Looks for the colours of face and clothes; None where no face is seen, or no torso."""
        eyes, mouth = joints.middle(EYES), joints.middle(MOUTH)
        size = float(np.hypot(*(eyes - mouth)))
        if joints.least_sure((*EYES, *MOUTH)) < LEAST_SEEN or size < _LEAST_FACE:
            return None
        cheeks = [
            (joints.places[eye] + joints.places[corner]) / 2 for eye, corner in zip(EYES, MOUTH, strict=True)
        ]
        middles = (joints.places[NOSE[0]], (eyes + mouth) / 2, *cheeks)
        face = _colours(pixels, mask, middles, _RADIUS_FACE * size)
        neck, seat = joints.middle(SHOULDERS), joints.middle(HIPS)
        down = float(np.hypot(*(joints.places[SHOULDERS[0]] - joints.places[HIPS[0]])))
        torso = [
            (1 - _CHEST_OUT) * (neck + t * (seat - neck))
            + _CHEST_OUT * (joints.places[shoulder] + t * (joints.places[hip] - joints.places[shoulder]))
            for shoulder, hip in zip(SHOULDERS, HIPS, strict=True)
            for t in _CHEST_DOWN
        ]
        cloth = _colours(pixels, np.ones_like(mask), torso, _RADIUS_CHEST * down)
        face, cloth = (some[np.isfinite(some).all(axis=1)] for some in (face, cloth))
        if not len(face) or not len(cloth):
            return None
        return BareSkin(pixels, mask, joints, np.median(face, axis=0), cloth)

    def arms(self, at: tuple[float, ...]) -> tuple[LimbColours, ...]:
        """Those arms that are seen, at places of `UPPER_ARM`, `FOREARM` or `HAND_END`."""
        return self._limbs((SHOULDERS, ELBOWS, WRISTS), at, _RADIUS_ARM)

    def legs(self, at: tuple[float, ...]) -> tuple[LimbColours, ...]:
        """Those legs that are seen, at places of `SHIN`."""
        return self._limbs((HIPS, KNEES, ANKLES), at, _RADIUS_LEG)

    def _limbs(
        self, joints: tuple[tuple[int, ...], ...], at: tuple[float, ...], radius: float
    ) -> tuple[LimbColours, ...]:
        found = []
        for start, bend, end in zip(*joints, strict=True):
            first, second = (start, bend) if at[0] < 1 else (bend, end)
            needed = (first,) if at is UPPER_ARM else (first, second)
            if self.joints.least_sure(needed) < LEAST_SEEN:
                continue
            a, b = self.joints.places[first], self.joints.places[second]
            size = float(np.hypot(*(self.joints.places[start] - self.joints.places[bend])))
            colours = _colours(self.pixels, self.mask, [a + (t % 1) * (b - a) for t in at], radius * size)
            colours = colours[np.isfinite(colours).all(axis=1)]
            if len(colours) > 1:
                nearest = _apart(colours[:, None], self.cloth[None]).min(axis=1)
                found.append(LimbColours(_mean_log(_apart(colours, self.face)), _mean_log(nearest)))
        return tuple(found)


def _apart(a: Array, b: Array) -> Array:
    return np.asarray(np.linalg.norm((a - b) * (_LIGHTNESS, 1, 1), axis=-1))


def _mean_log(apart: Array) -> float:
    return float(np.log(apart + _SOFT).mean())


def _colours(
    pixels: Pixels, mask: NDArray[np.bool_], middles: list[Array] | tuple[Array, ...], radius: float
) -> Array:
    """(n, 3) Lab of the median pixel of discs; not a number where hardly anything of them is shown."""
    height, width = mask.shape
    radius = max(radius, _LEAST_RADIUS)
    found = np.full((len(middles), 3), np.nan)
    for k, (x, y) in enumerate(middles):
        rows, columns = _span(y, radius, height), _span(x, radius, width)
        down, right = np.mgrid[rows, columns]
        inside = ((right - x) ** 2 + (down - y) ** 2 <= radius**2) & mask[rows, columns]
        if inside.sum() >= _LEAST_PIXELS:
            some = pixels[rows, columns][inside]
            found[k] = np.median(lab_of_linear(linear_of_srgb(some)), axis=0)
    return found


def _span(middle: float, radius: float, size: int) -> slice:
    start = min(max(int(middle - radius), 0), size)
    return slice(start, max(min(int(middle + radius) + 1, size), start))
