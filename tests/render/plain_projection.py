"""What a camera sees of a scene in plain numpy, triangle by triangle, to hold the compiled loops against."""

from __future__ import annotations

import numpy as np

from swifttailor.arrays import Array
from swifttailor.render.camera import NEAR, Camera
from swifttailor.render.scene import Scene


def triangles(scene: Scene) -> Array:
    """(m, 3, 3) float32 corners of all triangles, cm."""
    return _join([s.vertices.astype(np.float32)[s.faces] for s in scene.surfaces], (3, 3))


def materials(scene: Scene) -> Array:
    """(m, 8) float32 values of each triangle: colour, colour of the back, sheen, gloss."""
    rows = []
    for s in scene.surfaces:
        row = np.zeros((len(s.faces), 8), np.float32)
        row[:, 0:3] = s.color
        row[:, 3:6] = s.color if s.back_color is None else s.back_color
        row[:, 6], row[:, 7] = s.sheen, s.gloss
        rows.append(row)
    return _join(rows, (8,))


class Projection:
    """The triangles of a scene that a camera could see, in its picture."""

    def __init__(self, scene: Scene, camera: Camera, size: tuple[int, int]) -> None:
        """Projects the scene into a picture of `size` (width, height) samples."""
        self.scene, self.camera, self.size = scene, camera, size
        self.pixels: list[Array] = []
        """Projected vertices (n, 3) of each surface, see `Camera.project`."""
        corners, normals, lifts, kept, print_at = [], [], [], [], []
        before = 0
        for surface in scene.surfaces:
            pixels = camera.project(surface.vertices, size)
            self.pixels.append(pixels)
            drawn = pixels[surface.faces]
            ahead = pixels[:, 2] > NEAR + surface.lift
            keep = ahead[surface.faces[:, 0]] & ahead[surface.faces[:, 1]] & ahead[surface.faces[:, 2]]
            if surface.back_color is None:
                keep &= _from_right_side(drawn)
            index = np.flatnonzero(keep)
            corners.append(drawn[index])
            in_view = (surface.vertex_normals @ camera.axes.T).astype(np.float32)
            normals.append(in_view[surface.faces[index]])
            lifts.append(np.full(len(index), surface.lift))
            kept.append(index + before)
            if surface.print is not None and surface.print_at is not None:
                print_at.append(np.asarray(surface.print_at, np.float32)[index])
            else:
                print_at.append(np.zeros((len(index), 3, 2), np.float32))
            before += len(surface.faces)
        corners_all = _join(corners, (3, 3))
        self.normals = _join(normals, (3, 3)).astype(np.float32)
        """(k, 3, 3) vertex normals in the camera's frame."""
        self.front = _from_right_side(corners_all)
        """(k,) whether the right side is seen."""
        self.materials = materials(scene)[_join(kept, ()).astype(np.int64)]
        """(k, 8) see `materials`."""
        self.surface = np.repeat(np.arange(len(kept), dtype=np.int16), [len(index) for index in kept])
        """(k,) which surface of the scene."""
        self.print_at = None
        """(k, 3, 2) see `Surface.print_at`; None where nothing has a print."""
        if any(s.print is not None for s in scene.surfaces):
            self.print_at = _join(print_at, (3, 2))
        self.distance = corners_all[:, :, 2].copy()
        """(k, 3) distance from the camera, cm."""
        near = self.distance - _join(lifts, ())[:, None]
        # 1 / distance is affine over a perspective picture, distance over an orthographic one.
        corners_all[:, :, 2] = -1.0 / near if camera.perspective else near
        self.corners = corners_all
        """(k, 3, 3) as `rasterize` takes them."""


def _from_right_side(corners: Array) -> Array:
    """(m,) whether triangles turn anticlockwise in a picture whose rows run down."""
    a, b, c = corners[:, 0], corners[:, 1], corners[:, 2]
    turn = (b[:, 0] - a[:, 0]) * (c[:, 1] - a[:, 1]) - (b[:, 1] - a[:, 1]) * (c[:, 0] - a[:, 0])
    return turn < 0.0


def _join(parts: list[Array], shape: tuple[int, ...]) -> Array:
    return np.concatenate(parts) if parts else np.zeros((0, *shape), np.float32)
