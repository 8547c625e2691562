"""Which colour the cloth of a garment has in a picture, whatever lies in shadow or shines there."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from swifttailor.arrays import Array, Pixels
from swifttailor.picture_reader.light import under_white_light
from swifttailor.picture_reader.lit_cloth import hex_of, lit
from swifttailor.render.lab import lab_of_linear, linear_of_srgb

_LONGEST = 256
"""Pixels: what is smaller than one of these is weave, and noise."""
_INSIDE = 0.6
_BORDER = 0.02
"""Of the longest side: so near the edge of the mask skin and wall may be what is seen."""
_LEAST = 24
"""Pixels; fewer tell no colour."""
_SAMPLE, _GROUPS, _ROUNDS, _SEED = 2000, 8, 12, 0
_SAME = 0.25
"""Mean squared distance below which there is one group."""
_LIGHTNESS = 0.35
"""How much a difference in lightness counts beside one in hue: folds make it."""
_DARK = 45.0
"""Below this lightness hues are not trusted as much as they say."""
_ALIKE = 18.0
"""Groups that are nearer are one colour in more and less light."""
_TOLD_APART = 20.0
_SECOND = 0.12
"""Share from which another colour is worth saying."""
_BEHIND = 0.5
"""How much of what looks like it close around the garment speaks against a colour."""
_CLOSE = 0.08
"""Of the longest side: how far that is."""


@dataclass(frozen=True)
class SeenColor:
    """The colour of a garment in a picture."""

    rgb: str
    """Of most of its cloth, ``#rrggbb``."""
    share: float
    """How much of the cloth has it, 0 to 1."""
    others: tuple[str, ...] = ()
    """Colours of a good deal of the rest, that of most of it first."""


def seen_color(pixels: Pixels, mask: NDArray[np.float32]) -> SeenColor | None:
    """The colour of the cloth within a mask; None where too little of it is seen.

    Args:
        pixels: (h, w, 3) sRGB.
        mask: (h, w) 0 to 1: where the garment is.
    """
    small, share = _smaller(pixels, mask)
    weights = _within(share)
    if weights is None:
        return None
    light = under_white_light(linear_of_srgb(small), share)
    inside = weights > 0
    lab, weights = lab_of_linear(light[inside]), weights[inside]
    features = _without_shade(lab)
    groups = _groups(features, weights)
    summed = np.stack([np.bincount(groups, of_each) for of_each in features.T], axis=1)
    middles = summed / np.bincount(groups)[:, None]
    shares = np.bincount(groups, weights) / weights.sum()
    behind = _shares_of(_without_shade(lab_of_linear(light[_around(share)])), middles)
    order = np.argsort(_BEHIND * behind - shares, kind="stable")
    main = order[0]
    apart = _distances(middles, middles[main]) >= _TOLD_APART
    others = tuple([hex_of(lit(lab[groups == k])) for k in order[1:] if apart[k] and shares[k] >= _SECOND])
    return SeenColor(hex_of(lit(lab[groups == main])), float(1 - shares[apart].sum()), others)


def _smaller(pixels: Pixels, mask: NDArray[np.float32]) -> tuple[Array, Array]:
    from PIL import Image

    height, width = mask.shape
    shrunk = max(height, width) / _LONGEST
    if shrunk <= 1:
        return pixels, mask
    size = max(round(width / shrunk), 1), max(round(height / shrunk), 1)
    image = Image.fromarray(pixels).resize(size, Image.Resampling.BOX)
    inside = Image.fromarray(mask.astype(np.float32)).resize(size, Image.Resampling.BOX)
    return np.asarray(image), np.asarray(inside)


def _within(mask: Array) -> Array | None:
    """How much each pixel counts: more away from the border, and none at it."""
    from scipy.ndimage import distance_transform_edt

    inside = np.pad(mask > _INSIDE, 1)
    depth = np.asarray(distance_transform_edt(inside))[1:-1, 1:-1]
    border = min(_BORDER * max(mask.shape), 0.4 * float(depth.max()))
    weights = np.where(depth > border, np.minimum(depth, 4 * border), 0.0)
    return weights if np.count_nonzero(weights) >= _LEAST else None


def _around(mask: Array) -> NDArray[np.bool_]:
    """Pixels close to the garment that are none of it."""
    from scipy.ndimage import distance_transform_edt

    away = np.asarray(distance_transform_edt(mask < 0.3))
    return (away > _BORDER * max(mask.shape)) & (away <= _CLOSE * max(mask.shape))


def _without_shade(lab: Array) -> Array:
    """Lightness and hue (n, 3), so that cloth in more and less light is alike.

    Less light makes all of L + 16, a and b smaller by one factor.
    """
    lightness = lab[:, :1]
    return np.hstack([_LIGHTNESS * lightness, lab[:, 1:] * (70 + 16) / (np.maximum(lightness, _DARK) + 16)])


def _groups(features: Array, weights: Array) -> NDArray[np.intp]:
    """Number of the colour of each pixel: by k-means, of whose middles those near each other are one."""
    from scipy.cluster.hierarchy import fcluster, linkage
    from scipy.cluster.vq import vq

    rng = np.random.default_rng(_SEED)
    drawn = features[rng.choice(len(features), _SAMPLE, p=weights / weights.sum())]
    middles = _spread(drawn, rng)
    if len(middles) == 1:
        return np.zeros(len(features), np.intp)
    for _ in range(_ROUNDS):
        numbers = vq(drawn, middles)[0]
        middles = np.array([drawn[numbers == k].mean(axis=0) for k in np.unique(numbers)])
    joined = fcluster(linkage(middles, "complete"), _ALIKE, "distance") if len(middles) > 1 else np.ones(1)
    return np.unique(joined[vq(features, middles)[0]], return_inverse=True)[1]


def _spread(drawn: Array, rng: np.random.Generator) -> Array:
    """To begin with: some of the features, rather such as are far from those chosen before (k-means++)."""
    middles = drawn[:1]
    while len(middles) < _GROUPS:
        apart = ((drawn[:, None] - middles) ** 2).sum(axis=2).min(axis=1)
        if apart.sum() < _SAME * len(drawn):
            break
        middles = np.vstack([middles, drawn[rng.choice(len(drawn), p=apart / apart.sum())]])
    return middles


def _shares_of(features: Array, middles: Array) -> Array:
    """Which share of some pixels looks like each colour."""
    from scipy.cluster.vq import vq

    if not len(features):
        return np.zeros(len(middles))
    numbers, apart = vq(features, middles)
    return np.bincount(numbers[apart < _TOLD_APART], minlength=len(middles)) / len(features)


def _distances(middles: Array, main: Array) -> Array:
    """How far other colours are from one; that they are paler or stronger counts half: shadows are."""
    away = middles - main
    hue = main[1:] / max(float(np.hypot(*main[1:])), 1e-9)
    along = away[:, 1:] @ hue
    return np.sqrt((away**2).sum(axis=1) - 0.75 * along**2)
