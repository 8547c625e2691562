"""Where a picture is taken from, and where a point of the world lands in it."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from swifttailor.arrays import Array
from swifttailor.errors import InputError

NEAR = 1.0
"""Nothing closer to a perspective camera than this is drawn, cm."""


@dataclass(frozen=True)
class Camera:
    """A view of the world frame (cm, Y up, wearer's left at +X): docs/conventions.md."""

    target: tuple[float, float, float] = (0.0, 90.0, 0.0)
    """Point in the middle of the picture, cm."""
    height: float = 190.0
    """Centimetres seen from the bottom to the top of the picture, at the target's distance."""
    azimuth: float = 0.0
    """Degrees around the wearer: 0 sees the front, 90 the wearer's left side, 180 the back."""
    elevation: float = 0.0
    """Degrees above the horizon from which the camera looks down, -89 to 89."""
    field_of_view: float = 0.0
    """Vertical opening in degrees; 0 is an orthographic camera."""

    def __post_init__(self) -> None:
        numbers = (*self.target, self.height, self.azimuth, self.elevation, self.field_of_view)
        if len(self.target) != 3 or not np.isfinite(numbers).all():
            raise InputError(f"A camera is described by finite numbers, got {self!r}.")
        if self.height <= 0.0:
            raise InputError(f"A camera's height must be more than 0 cm, got {self.height:g}.")
        if not 0.0 <= self.field_of_view <= 120.0:
            raise InputError(
                f"A camera's field_of_view is 0 (orthographic) to 120 degrees, got {self.field_of_view:g}."
            )
        if not -89.0 <= self.elevation <= 89.0:
            raise InputError(f"A camera's elevation is -89 to 89 degrees, got {self.elevation:g}.")

    @cached_property
    def axes(self) -> Array:
        """(3, 3) rows: the picture's right, its up, and the direction towards the camera."""
        a, e = np.deg2rad([self.azimuth, self.elevation])
        back = np.array([np.sin(a) * np.cos(e), np.sin(e), np.cos(a) * np.cos(e)])
        right = np.array([np.cos(a), 0.0, -np.sin(a)])
        return np.array([right, np.cross(back, right), back])

    @cached_property
    def distance(self) -> float:
        """From the camera to the target, cm."""
        if self.field_of_view == 0.0:
            return 10.0 * max(self.height, 1000.0)
        return self.height / 2 / float(np.tan(np.deg2rad(self.field_of_view) / 2))

    @property
    def perspective(self) -> bool:
        """Whether near things look larger."""
        return self.field_of_view > 0.0

    def to_view(self, points: Array) -> Array:
        """Carries world points (n, 3) into the camera's frame: right, up, distance from the camera; cm."""
        view = (points - np.asarray(self.target)) @ self.axes.T
        view[:, 2] = self.distance - view[:, 2]
        return view

    def project(self, points: Array, size: tuple[int, int]) -> Array:
        """Where world points (n, 3) cm land in a picture of `size` (width, height) pixels.

        Returns:
            (n, 3): x to the right and y down in pixels, (0, 0) the picture's upper left corner; and the
            distance from the camera along its axis, cm.
        """
        return self.view_to_pixels(self.to_view(points), size)

    def view_to_pixels(self, view: Array, size: tuple[int, int]) -> Array:
        """The second half of `project`: from `to_view` (n, 3) to pixels and distance (n, 3)."""
        width, height = size
        scale = height / self.height
        if self.perspective:
            scale = scale * self.distance / np.maximum(view[:, 2], NEAR * 1e-3)
        return np.stack([width / 2 + view[:, 0] * scale, height / 2 - view[:, 1] * scale, view[:, 2]], axis=1)

    def rays(self, x: Array, y: Array, size: tuple[int, int]) -> tuple[Array, Array]:
        """Origin and unit direction, both (n, 3) cm, of the sight lines through pixel positions (n,)."""
        width, height = size
        scale = self.height / height
        right, up, back = self.axes
        offset = np.multiply.outer((x - width / 2) * scale, right) + np.multiply.outer(
            (height / 2 - y) * scale, up
        )
        eye = np.asarray(self.target) + self.distance * back
        if not self.perspective:
            return eye + offset, np.broadcast_to(-back, offset.shape)
        direction = offset - self.distance * back
        direction /= np.linalg.norm(direction, axis=1, keepdims=True)
        return np.broadcast_to(eye, offset.shape), direction

    def floor_points(self, x: Array, y: Array, size: tuple[int, int]) -> Array:
        """Where the sight lines through pixel columns x (w,) and rows y (h,) meet the floor y = 0.

        Returns:
            (h, w, 2): x and z in cm; very far away for lines that do not go down.
        """
        width, height = size
        scale = self.height / height
        right, up, back = self.axes
        # The picture's right lies level, so a whole row of sight lines goes equally far.
        across = np.multiply.outer((x - width / 2) * scale, right)[None]
        along_row = np.multiply.outer((height / 2 - y) * scale, up)
        eye = np.asarray(self.target) + self.distance * back
        if self.perspective:
            down = along_row - self.distance * back
            reach = -eye[1] / np.minimum(down[:, 1], -1e-6 * self.distance)
            points = eye + reach[:, None, None] * (across + down[:, None])
        else:
            start = eye + along_row
            reach = start[:, 1] / max(back[1], 1e-6)
            points = across + (start - reach[:, None] * back)[:, None]
        return points[:, :, [0, 2]]
