"""How a camera looks at the wearer, in the six numbers that a picture reader says."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from swifttailor.picture_reader.units import VIEW_CM
from swifttailor.render import Camera

LOW, HIGH = np.array([0.0, 60.0, 0.0]), np.array([0.0, 140.0, 0.0])
"""Two points on the wearer's axis, cm above the floor: their distance in a picture is its scale."""
assert HIGH[1] - LOW[1] == VIEW_CM
Square = tuple[int, int, int]
_STEEP = 30.0
_USUAL_FIELD = 14.0
"""Degrees; pictures hardly show how far away the camera is."""


def view_of(camera: Camera, size: int) -> NDArray[np.float32]:
    """`labels.VIEW` of a square picture of `size` pixels.

    Sine and cosine of the azimuth; the elevation in units of 30 degrees; the logarithm of how many sides of
    the picture 80 cm are; and where from its middle the middle of both points is, in sides.
    """
    low, high = camera.project(np.stack([LOW, HIGH]), (size, size))[:, :2]
    right, down = (low + high) / 2 / size - 0.5
    turned = np.deg2rad(camera.azimuth)
    scale = np.log(max(float(np.hypot(*(high - low))), 1e-3) / size)
    found = [np.sin(turned), np.cos(turned), camera.elevation / _STEEP, scale, right, down]
    return np.array(found, np.float32)


def camera_of(view: NDArray[np.float32]) -> Camera:
    """The camera that shows the wearer as `view_of` says."""
    sine, cosine, steep, scale, right, down = (float(v) for v in view)
    elevation = float(np.clip(steep * _STEEP, -80, 80))
    azimuth = float(np.rad2deg(np.arctan2(sine, cosine)))
    height = VIEW_CM * np.cos(np.deg2rad(elevation)) / np.exp(scale)
    plain = Camera((0.0, 100.0, 0.0), float(height), azimuth, elevation, _USUAL_FIELD)
    middle = np.array([0.0, 100.0, 0.0]) - plain.axes[0] * right * height + plain.axes[1] * down * height
    x, y, z = (float(v) for v in middle)
    return Camera((x, y, z), float(height), azimuth, elevation, _USUAL_FIELD)


def view_in(view: NDArray[np.float32], old: Square, new: Square) -> NDArray[np.float32]:
    """The view of one square of a picture (left, top, side) as that of another."""
    found = view.copy()
    ratio = old[2] / new[2]
    for axis, place in ((0, 4), (1, 5)):
        middle = old[axis] + old[2] * (0.5 + view[place])
        found[place] = (middle - new[axis]) / new[2] - 0.5
    found[3] += np.log(ratio)
    return found
