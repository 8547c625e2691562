"""Photos made like the pictures that networks learn from: the figure in the middle of a square.

Of 120 pictures of random looks as `swifttailor data render` draws them, 69 show a figure whole: half of those
have it 72 to 85 % as large as the square, and 95 in 100 within 5 % of its middle. A photo has its figure
anywhere and at any size; where its background is plain the figure is found by that and the photo cropped.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum
from typing import Any

import numpy as np
from numpy.typing import NDArray

from swifttailor.arrays import Floats, Pixels
from swifttailor.render.pixels import require_picture

MARGIN = 0.11
"""Free space on each side of the figure, as a share of its larger extent: the middle of what renders have."""
_LARGEST, _SMALLEST, _OFF_CENTRE = 0.95, 0.62, 0.08
"""Share of the square that a figure may span, and be off its middle, to be left as it is."""
_ANALYSED = 192
"""Pixels along the longer side in which the figure is looked for."""
_RING = 0.03
"""Width of the border that is taken for background, as a share of the longer side."""
_PLAIN_SHARE = 0.6
"""Least share of the border that must be background; the rest may be a figure that leaves the picture."""
_PLAIN_SPREAD = 7.0
"""Most that a plain background may differ from a smooth one, levels of 255 (median)."""
_MUCH_BETTER = 0.7
_LEAST_CONTRAST = 6.0
_SPECK = 0.03
"""Parts smaller than this share of the largest are dirt, or marks of a photographer."""
_CUT_OFF = 0.25
"""Share of a figure's extent that must lie on the border for it to be cut off there, more than a hand."""
_NOTHING, _EVERYTHING = 0.003, 0.97
"""Shares of the picture below and above which what was found is no figure."""


class Framing(StrEnum):
    """What was done to a picture."""

    KEPT = "kept"
    """It has its figure where it should be."""
    CROPPED = "cropped"
    """Cropped or widened to a square around its figure."""
    BUSY = "busy"
    """Left as it is: the background is not plain."""
    EMPTY = "empty"
    """Left as it is: nothing stands before the background."""


@dataclass(frozen=True, eq=False)
class Framed:
    """A picture, and what was done to it."""

    pixels: Pixels
    framing: Framing
    box: tuple[int, int, int, int] | None = None
    """Of a cropped one: left, top, right, bottom of the square in the picture; may lie outside."""


@dataclass(frozen=True)
class _Backdrop:
    """A smooth background: polynomials of the place, -1 to 1 across the picture."""

    terms: Floats
    """(3 or 6, 3)."""
    spread: float
    """Median distance of background from it, levels."""

    def at(self, x: Floats, y: Floats) -> Floats:
        """(n, 3) colours at places (n,)."""
        return _powers(x.clip(-1, 1), y.clip(-1, 1), len(self.terms)) @ self.terms


def frame_figure(pixels: Pixels) -> Framed:
    """Crops a picture to what stands before its plain background.

    Args:
        pixels: (h, w, 3) sRGB of any size.

    Raises:
        InputError: It is no picture of three colours.
    """
    require_picture(pixels)
    small = _reduced(pixels)
    backdrop = _fit_backdrop(small)
    if backdrop is None:
        return Framed(pixels, Framing.BUSY)
    figure = _find_figure(small, backdrop)
    if figure is None:
        return Framed(pixels, Framing.EMPTY)
    height, width = pixels.shape[:2]
    rows, columns = np.flatnonzero(figure.any(axis=1)), np.flatnonzero(figure.any(axis=0))
    scale = np.array([width / small.shape[1], height / small.shape[0]])
    low = np.array([columns[0], rows[0]]) * scale
    high = np.array([columns[-1] + 1, rows[-1] + 1]) * scale
    border = _on_border(figure) / [len(rows), len(columns)]
    if _is_framed(low, high, border > 0, np.array([width, height])):
        return Framed(pixels, Framing.KEPT)
    left, top, side = _square(low, high, border)
    return Framed(
        _cut(pixels, backdrop, left, top, side), Framing.CROPPED, (left, top, left + side, top + side)
    )


def _reduced(pixels: Pixels) -> Floats:
    """(h, w, 3) with the longer side at most `_ANALYSED`."""
    from PIL import Image

    height, width = pixels.shape[:2]
    shrink = min(1.0, _ANALYSED / max(height, width))
    if shrink == 1.0:
        return pixels.astype(np.float64)
    size = max(1, round(width * shrink)), max(1, round(height * shrink))
    image: Any = Image.fromarray(pixels).resize(size, Image.Resampling.BOX)
    return np.asarray(image, np.float64)


def _powers(x: Floats, y: Floats, count: int) -> Floats:
    return np.stack([np.ones_like(x), x, y, x * x, y * y, x * y][:count], axis=1)


def _places(height: int, width: int) -> tuple[Floats, Floats]:
    """(h, w) x and y of all pixels, -1 to 1."""
    y, x = np.mgrid[0:height, 0:width]
    return (2 * x + 1) / width - 1, (2 * y + 1) / height - 1


def _fit_backdrop(small: Floats) -> _Backdrop | None:
    """The background by the picture's border; None where that is not smooth."""
    height, width = small.shape[:2]
    ring = np.ones((height, width), bool)
    depth = max(1, round(_RING * max(height, width)))
    ring[depth : height - depth, depth : width - depth] = False
    x, y = (p[ring] for p in _places(height, width))
    colors = small[ring]
    found: _Backdrop | None = None
    for count in (3, 6):
        if len(colors) < 4 * count:
            break
        powers = _powers(x, y, count)
        away = np.abs(colors - np.median(colors, axis=0)).max(axis=1)
        for _ in range(20):
            # What is far off counts for nothing (Geman and McClure), not even where a figure fills one side.
            weighted = powers.T / (1 + (away / _PLAIN_SPREAD) ** 2) ** 2
            terms = np.linalg.lstsq(weighted @ powers, weighted @ colors, rcond=None)[0]
            away = np.abs(colors - powers @ terms).max(axis=1)
        near = np.sort(away)[: int(_PLAIN_SHARE * len(away)) + 1]
        spread = float(np.median(near))
        plain = near[-1] <= 3 * _PLAIN_SPREAD and spread <= _PLAIN_SPREAD
        # A bent background follows the border more easily, and the figure in it: only where that says much.
        if plain and (found is None or spread < _MUCH_BETTER * found.spread):
            found = _Backdrop(terms, spread)
    return found


def _find_figure(small: Floats, backdrop: _Backdrop) -> NDArray[np.bool_] | None:
    """(h, w) where something stands before the background; None where nothing does, or everything."""
    from scipy import ndimage  # takes a twentieth of a second to load

    height, width = small.shape[:2]
    x, y = _places(height, width)
    behind = backdrop.at(x.ravel(), y.ravel()).reshape(small.shape)
    away = ndimage.uniform_filter(np.abs(small - behind).max(axis=2), 3, mode="nearest")
    # A median distance is 0.67 deviations of what is spread normally.
    mask = away > max(_LEAST_CONTRAST, 4 * backdrop.spread / 0.67)
    padded = np.pad(mask, 2, mode="edge")  # what leaves the picture goes on outside
    mask = ndimage.binary_opening(padded, iterations=1)[2:-2, 2:-2]
    parts, count = ndimage.label(mask, np.ones((3, 3)))
    if not count:
        return None
    areas = np.bincount(parts.ravel(), minlength=count + 1)
    areas[0] = 0
    figure = (areas >= _SPECK * areas.max())[parts] & mask
    return figure if _NOTHING <= figure.mean() <= _EVERYTHING else None


def _on_border(figure: NDArray[np.bool_]) -> Floats:
    """(2, 2) how many pixels of each border a figure has: left and top, right and bottom."""
    ends = [figure[:, 0], figure[0], figure[:, -1], figure[-1]]
    return np.array([end.sum() for end in ends], np.float64).reshape(2, 2)


def _is_framed(low: Floats, high: Floats, touched: NDArray[np.bool_], size: NDArray[Any]) -> bool:
    """Whether a figure is where pictures to learn from have theirs."""
    if abs(size[0] - size[1]) > 0.03 * size.max():
        return False
    if touched.any():  # a close view, cut where it leaves the picture
        return bool(((high - low) > _SMALLEST * size).any())
    spans = float(((high - low) / size).max())
    off = np.abs((high + low) / 2 / size - 0.5).max()
    return _SMALLEST <= spans <= _LARGEST and bool(off <= _OFF_CENTRE)


def _square(low: Floats, high: Floats, border: Floats) -> tuple[int, int, int]:
    """Left, top and side of the square around a figure: space on its free sides, none where it is cut off.

    Args:
        low: (2,) left and top of the figure.
        high: (2,) right and bottom.
        border: (2, 2) share of the figure's extent that lies on the border, by side.
    """
    space = MARGIN * float((high - low).max())
    low = low - space * (border[0] == 0)
    high = high + space * (border[1] == 0)
    side = max(1, round(float((high - low).max())))
    lack = side - (high - low)
    # Away from where much is cut off: past it there is more of the figure, and nobody knows what.
    cut = border > _CUT_OFF
    before = np.select([cut[0] & ~cut[1], cut[1] & ~cut[0]], [0.0, 1.0], 0.5)
    left, top = np.round(low - lack * before).astype(int)
    return int(left), int(top), side


def _cut(pixels: Pixels, backdrop: _Backdrop, left: int, top: int, side: int) -> Pixels:
    """(side, side, 3) of a picture, its background continued where the square leaves it."""
    height, width = pixels.shape[:2]
    y, x = np.mgrid[top : top + side, left : left + side]
    inside = (x >= 0) & (x < width) & (y >= 0) & (y < height)
    made = np.zeros((side, side, 3), np.uint8)
    made[inside] = pixels[y[inside], x[inside]]
    outside = ~inside
    if outside.any():
        colors = backdrop.at((2 * x[outside] + 1) / width - 1, (2 * y[outside] + 1) / height - 1)
        made[outside] = np.round(colors).clip(0, 255)
    return made
