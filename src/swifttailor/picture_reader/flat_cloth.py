"""The cloth of a garment in a photograph, evenly lit: what is printed on it, without folds and shadows."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from swifttailor.arrays import Array, Pixels
from swifttailor.picture_reader.light import under_white_light
from swifttailor.render.lab import lab_of_linear, linear_of_srgb

_LONGEST = 256
"""Pixels along the longer side of the garment: thin stripes are two or three of these wide."""
_INSIDE = 0.6
_AROUND = 0.1
"""How much of what is around the garment is looked at for its light, in its longer sides."""
_BORDER, _MOST_BORDER = 0.025, 0.35
"""What is so near the edge of the mask may be another thing: in longer sides, and of the deepest cloth."""
_EVEN = 0.09
"""Width of the blur that tells shade from print, in longer sides."""
_BOXES = 2.45
"""Side of each of two boxes that blur as a Gaussian does, in its standard deviations."""
_LEAST = 200
"""Pixels; fewer tell nothing."""


@dataclass(frozen=True, eq=False)
class FlatCloth:
    """A garment cut out of a photograph."""

    lab: Array
    """(h, w, 3) as it is seen, in white light, CIE Lab."""
    flat: Array
    """(h, w, 3) the same without its mean around each pixel; 0 where the garment is not."""
    inside: NDArray[np.bool_]
    """(h, w) where it is."""
    pixel: float
    """Pixels of the photograph along each side of one of these."""

    @staticmethod
    def of(pixels: Pixels, mask: NDArray[np.float32]) -> FlatCloth | None:
        """Cuts out a garment; None where hardly any of it is seen.

        Args:
            pixels: (h, w, 3) sRGB.
            mask: (h, w) 0 to 1: where it is.
        """
        from PIL import Image
        from scipy.ndimage import distance_transform_edt

        rows, columns = (np.flatnonzero((mask > _INSIDE).any(axis=k)) for k in (1, 0))
        if len(rows) < 2 or len(columns) < 2:
            return None
        longer = max(int(np.ptp(rows)), int(np.ptp(columns))) + 1
        more = round(_AROUND * longer)
        top, bottom = max(rows[0] - more, 0), rows[-1] + more + 1
        left, right = max(columns[0] - more, 0), columns[-1] + more + 1
        shown, share = pixels[top:bottom, left:right], mask[top:bottom, left:right].astype(np.float32)
        shrunk = max(longer / _LONGEST, 1.0)
        size = max(round(shown.shape[1] / shrunk), 1), max(round(shown.shape[0] / shrunk), 1)
        small, share = (
            np.asarray(Image.fromarray(one).resize(size, Image.Resampling.BOX))
            for one in (np.ascontiguousarray(shown), share)
        )
        depth = np.asarray(distance_transform_edt(np.pad(share > _INSIDE, 1)))[1:-1, 1:-1]
        longest = longer / shrunk
        inside = depth > min(_BORDER * longest, _MOST_BORDER * float(depth.max()))
        if np.count_nonzero(inside) < _LEAST:
            return None
        lab = lab_of_linear(under_white_light(linear_of_srgb(small), share))
        weights, width = inside.astype(np.float64), _EVEN * longest
        near = np.maximum(blurred(weights, width), 1e-6)[..., None]
        even = blurred(lab * weights[..., None], width) / near
        return FlatCloth(lab, (lab - even) * weights[..., None], inside, float(shrunk))

    @cached_property
    def main(self) -> Array:
        """(h, w) how far each pixel is along the line in Lab on which most colours lie; 0 outside."""
        seen = self.flat[self.inside]
        _, axes = np.linalg.eigh(np.cov(seen.T))
        found: Array = (self.flat - seen.mean(axis=0)) @ axes[:, -1] * self.inside
        return found


def blurred(values: Array, width: float) -> Array:
    """Values of pixels, (h, w) or (h, w, n), each the mean of those around it.

    Args:
        values: Of pixels.
        width: Standard deviation of the blur, pixels. Two boxes, which cost little, are near a Gaussian.
    """
    from scipy.ndimage import uniform_filter

    side = 2 * round(_BOXES * width / 2) + 1
    size = (side, side, *(1 for _ in values.shape[2:]))
    found: Array = uniform_filter(uniform_filter(values, size), size)
    return found
