"""Pictures of flat patterns, small ones to compare at a glance; the exact drawing is `pattern.svg`."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
import shapely

from swifttailor.pattern import EdgeRef, Pattern
from swifttailor.pattern.svg.drawing import PALETTE
from swifttailor.pattern.svg.placing import PlacedPanel, place_panel, shelves

if TYPE_CHECKING:
    from PIL.Image import Image

    Array = np.ndarray[Any, np.dtype[np.float64]]
    ToPixels = Callable[[Array], Array]

MM_PER_CM = 10.0
_PAPER, _CLOTH, _INK, _FREE = "#ffffff", "#f4f1ec", "#3a3835", "#55524e"
_MARGIN = 8
_SMOOTH = 3
"""Drawn so many times larger, then made smaller."""
_NAMES, _NOTE = (10, 8), 11
"""Heights of letters, pixels."""
_OVERHANG = 3
_BARS_CM = (1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10_000, 20_000, 50_000)


@dataclass(frozen=True, eq=False)
class _Sheet:
    """Panels side by side, right side up."""

    panels: list[PlacedPanel]
    corners: Array
    """(n, 2) upper left corner of each, mm, y down."""
    size: Array
    """(2,) mm."""


def fitting_scale(pattern: Pattern, size: tuple[int, int]) -> float:
    """The largest scale, in pixels per cm, at which a pattern fits in a picture of `pattern_picture`.

    Args:
        pattern: Any; for one without panels, or without extent, it is 1.
        size: Width and height in pixels.
    """
    sheet = _lay_out(pattern)
    width, height = size[0] - 2 * _MARGIN, size[1] - 2 * _MARGIN - 2 * _NOTE
    if not sheet.panels or sheet.size.max() < 1e-6:
        return 1.0
    return float(min(width / max(sheet.size[0], 1e-6), height / max(sheet.size[1], 1e-6)) * MM_PER_CM)


def pattern_picture(pattern: Pattern, size: tuple[int, int], scale: float | None = None) -> Image:
    """Draws a pattern: panels right side up with their names, seams in pairs of one colour, a scale bar.

    Args:
        pattern: Any.
        size: Width and height in pixels, from 60.
        scale: Pixels per cm, so that several pictures can have one scale; what does not fit is cut off.
            `fitting_scale` when None.
    """
    from PIL import Image, ImageDraw

    scale = fitting_scale(pattern, size) if scale is None else scale
    sheet, per_mm = _lay_out(pattern), scale / MM_PER_CM
    picture = Image.new("RGB", (size[0] * _SMOOTH, size[1] * _SMOOTH), _PAPER)
    draw = ImageDraw.Draw(picture)
    colors = {side: PALETTE[k % len(PALETTE)] for k, s in enumerate(pattern.stitches) for side in s.sides}
    start = np.array([max((size[0] - sheet.size[0] * per_mm) / 2, _MARGIN), float(_MARGIN)])
    names: list[tuple[Array, str, Array]] = []
    for item, corner in zip(sheet.panels, sheet.corners, strict=True):
        upper_left = np.array([item.low[0], item.low[1] + item.size[1]])

        def to_pixels(points: Array, corner: Array = corner, origin: Array = upper_left) -> Array:
            return start + ((points - origin) * [1.0, -1.0] + corner) * per_mm

        _draw_panel(draw, item, to_pixels, colors, scale)
        names.append((to_pixels(_middle(item)), item.panel.name, item.size * per_mm))
    small = picture.resize(size, Image.Resampling.LANCZOS)
    _write(small, names, scale, pattern)
    return small


def _lay_out(pattern: Pattern) -> _Sheet:
    placed = [place_panel(k, p, 0.1) for k, p in enumerate(pattern.panels)]
    if not placed:
        return _Sheet([], np.zeros((0, 2)), np.zeros(2))
    sizes = np.array([p.size for p in placed])
    gap = max(0.04 * float(np.sqrt(sizes.prod(axis=1).sum())), 1.0)
    corners, size = shelves(sizes, gap)
    return _Sheet(placed, corners, size)


def _middle(item: PlacedPanel) -> Array:
    """Where the name goes, mm: the middle of the panel's box, where that is within, or else deep inside."""
    center, outline = item.low + item.size / 2, item.panel.outline(0.2) * MM_PER_CM
    if len(outline) > 2 and shapely.contains_xy(shapely.Polygon(outline), *center):
        return center
    return np.array([item.caption.x, item.caption.y])


def _draw_panel(
    draw: Any, item: PlacedPanel, to_pixels: Any, colors: dict[EdgeRef, str], scale: float
) -> None:
    panel, tolerance = item.panel, 0.2 / scale
    outline = to_pixels(panel.outline(tolerance) * MM_PER_CM) * _SMOOTH
    draw.polygon([tuple(p) for p in outline], fill=_CLOTH)
    for k in range(len(panel.edges)):
        color = colors.get(EdgeRef(panel.name, k))
        line = to_pixels(panel.flatten_edge(k, tolerance) * MM_PER_CM) * _SMOOTH
        width = _SMOOTH if color is None else round(2.2 * _SMOOTH)
        draw.line([tuple(p) for p in line], fill=color or _FREE, width=width, joint="curve")


def _write(picture: Image, names: list[tuple[Array, str, Array]], scale: float, pattern: Pattern) -> None:
    from PIL import ImageDraw, ImageFont

    draw, width, height = ImageDraw.Draw(picture), picture.width, picture.height
    note = ImageFont.load_default(_NOTE)
    for (x, y), name, room in names:
        # A name that does not fit its panel would hide those beside it.
        fonts = (ImageFont.load_default(size) for size in _NAMES if room[1] >= 0.7 * size)
        font = next((f for f in fonts if draw.textlength(name, f) <= room[0] + 2 * _OVERHANG), None)
        if font is None or not 0 <= y < height:
            continue
        half = draw.textlength(name, font) / 2
        x = min(max(x, half + 1), max(width - half - 1, half + 1))
        draw.text((x, y), name, fill=_INK, font=font, anchor="mm", stroke_width=1, stroke_fill=_CLOTH)
    bar = max((b for b in _BARS_CM if b * scale <= width / 3), default=_BARS_CM[0])
    y = height - _MARGIN - _NOTE / 2
    draw.line([(_MARGIN, y), (_MARGIN + bar * scale, y)], fill=_INK, width=2)
    text = f"{bar} cm" if bar < 1000 else f"{bar / 100:g} m"
    about = f"{text}    {len(pattern.panels)} panels, {len(pattern.stitches)} stitches"
    draw.text((_MARGIN + bar * scale + 6, y), about, fill=_INK, font=note, anchor="lm")
