"""How much of the figure the preview shows, and how its width is shared between the views."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from swifttailor.arrays import Array
from swifttailor.render.camera import Camera

_ELEVATION = 5.0
_FIELD_OF_VIEW = 16.0
_CHEST = 0.70
"""A top reaches above this share of the stature."""
_WHOLE = 0.78
"""A frame higher than this share of the stature shows the whole figure instead."""


@dataclass(frozen=True)
class PlacedView:
    """One view of the preview."""

    camera: Camera
    first: int
    """First pixel column."""
    width: int
    """Pixel columns."""


def frame_views(garment: Array, body: Array | None, size: tuple[int, int]) -> list[PlacedView]:
    """Frames the front, the back and the wearer's left side, all at one scale.

    A top is shown with the head and part of the legs. Everything else, and a top so wide that there is room
    for it, is shown with the whole figure.

    Args:
        garment: (n, 3) vertices, cm.
        body: (m, 3) vertices, cm, or None.
        size: Width and height of the whole picture in pixels.
    """
    width = size[0]
    if not len(garment):
        garment = np.array([[-20.0, 60, -20], [20, 140, 20]])
    frame = _frame(garment, body, whole=False)
    if body is not None:
        stature = float(body[:, 1].max())
        is_top = garment[:, 1].max() > _CHEST * stature
        if not is_top or _seen(frame, size) > _WHOLE * stature:
            frame = _frame(garment, body, whole=True)
    seen = _seen(frame, size)
    shares = np.cumsum([0.0, frame.half_width, frame.half_width, frame.half_depth])
    columns = np.round(shares * width / shares[-1]).astype(int)
    middle = (frame.top + frame.bottom) / 2
    views = []
    for k, azimuth in enumerate((0.0, 180.0, 90.0)):
        target = (frame.middle_x, middle, 0.0) if azimuth != 90.0 else (0.0, middle, frame.middle_z)
        camera = Camera(target, seen, azimuth, _ELEVATION, _FIELD_OF_VIEW)
        views.append(PlacedView(camera, int(columns[k]), max(int(columns[k + 1] - columns[k]), 1)))
    return views


@dataclass(frozen=True)
class _Frame:
    """The part of the world to show, cm."""

    bottom: float
    top: float
    middle_x: float
    half_width: float
    middle_z: float
    half_depth: float


def _seen(frame: _Frame, size: tuple[int, int]) -> float:
    """Height that the picture shows, cm: the frame's, or more where its width decides."""
    across = 2 * (2 * frame.half_width + frame.half_depth)
    return max(frame.top - frame.bottom, across * size[1] / size[0])


def _frame(garment: Array, body: Array | None, *, whole: bool) -> _Frame:
    low, high = garment.min(axis=0), garment.max(axis=0)
    bottom, top = float(low[1]), float(high[1])
    if body is not None:
        stature = float(body[:, 1].max())
        if whole:
            bottom, top = min(bottom, 0.0), max(top, stature)
        else:
            bottom, top = bottom - 0.12 * stature, max(top, stature)
        worn = body[(body[:, 1] >= bottom) & (body[:, 1] <= top)]
        if len(worn):
            low[2], high[2] = min(low[2], worn[:, 2].min()), max(high[2], worn[:, 2].max())
            reach = float(np.abs(worn[:, 0]).max())
            if not whole:  # hands may leave the picture
                reach = min(reach, float(np.abs(garment[:, 0]).max()) + 6.0)
            low[0], high[0] = min(low[0], -reach), max(high[0], reach)
    margin = 0.03 * (top - bottom) + 1.0
    half = (high - low) / 2 + margin
    middle = (high + low) / 2
    # The camera looks down a little: what is near the feet needs more room below them.
    return _Frame(
        bottom - 1.8 * margin,
        top + margin,
        float(middle[0]),
        float(half[0]),
        float(middle[2]),
        float(half[2]) + margin,
    )
