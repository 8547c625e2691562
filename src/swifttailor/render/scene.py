"""Surfaces put together: once in the world, and once for each camera that looks at them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from swifttailor.arrays import Array
from swifttailor.compiled_loop import CompiledLoop
from swifttailor.render.backdrop import FloorShadow
from swifttailor.render.camera import NEAR, Camera
from swifttailor.render.rasterize import DepthKeys, Triangles, nearest_triangles
from swifttailor.render.surface import Surface

_add_normals = CompiledLoop("swifttailor.render.raster_kernels", "add_normals")


class Scene:
    """Surfaces in the world as one mesh, with what does not depend on the camera."""

    def __init__(self, surfaces: Sequence[Surface]) -> None:
        """Takes the surfaces, in the order in which they are drawn."""
        self.surfaces = tuple(surfaces)
        counts = [len(s.vertices) for s in self.surfaces]
        self.first_vertex = np.cumsum([0, *counts])
        """Where the vertices of each surface begin, and where the last ones end."""
        face_counts = [len(s.faces) for s in self.surfaces]
        self.first_face = np.cumsum([0, *face_counts])
        """Where the faces of each surface begin, and where the last ones end."""
        self.vertices = np.zeros((self.first_vertex[-1], 3))
        """(n, 3) of all surfaces, cm."""
        self.faces = np.zeros((self.first_face[-1], 3), np.int32)
        """(m, 3) of all surfaces."""
        self.face_surface = np.repeat(np.arange(len(counts), dtype=np.int16), face_counts)
        """(m,) which surface each face belongs to."""
        for k, surface in enumerate(self.surfaces):
            self.vertices[self.first_vertex[k] : self.first_vertex[k + 1]] = surface.vertices
            part = self.faces[self.first_face[k] : self.first_face[k + 1]]
            np.add(surface.faces, self.first_vertex[k], out=part, casting="unsafe")
        self._floor_shadows: dict[float, FloorShadow] = {}

    @cached_property
    def rows(self) -> Array:
        """(3, n) float64 coordinates of the vertices: least and most are found several times faster."""
        return np.ascontiguousarray(self.vertices.T)

    @cached_property
    def normals(self) -> Array:
        """(n, 3) float32 unit normals of the vertices; zero where a vertex has no face of any area."""
        normals = np.zeros((len(self.vertices), 3), np.float32)
        _add_normals(self.vertices, self.faces, normals)
        return normals

    @cached_property
    def closed(self) -> Array:
        """(surfaces,) 1.0 where the inside of a surface is not drawn, else 0.0."""
        return np.array([float(s.back_color is None) for s in self.surfaces])

    def floor_shadow(self, pixel: float = 0.0) -> FloorShadow | None:
        """What the scene does to the floor; None without anything to throw a shadow.

        Args:
            pixel: Centimetres that a pixel of the picture shows; larger ones need no fine shadow.
        """
        if not len(self.faces):
            return None
        cell = FloorShadow.cell_for(pixel)
        if cell not in self._floor_shadows:
            self._floor_shadows[cell] = FloorShadow(self.rows, self.seen_from_afar, cell)
        return self._floor_shadows[cell]

    def seen_from_afar(self, points: Array, depth: Array, *, cull: float) -> Triangles:
        """The triangles in another picture: their vertices (n, 2 or more) there, and the depth (n,).

        Args:
            points: x and y in cells.
            depth: Larger farther away.
            cull: The turn, 1 or -1, of triangles of closed surfaces that face away; 0 to keep them.
        """
        return Triangles(points, depth, self.faces, self.face_surface, self.closed * cull)

    @cached_property
    def materials(self) -> Materials:
        """What light meets on each triangle."""
        rows, start, step, count = [], [], [], 0
        for k, s in enumerate(self.surfaces):
            many = s.color.ndim == 2 or (s.back_color is not None and s.back_color.ndim == 2)
            row = np.zeros((len(s.faces) if many else 1, 8), np.float32)
            row[:, 0:3] = s.color
            row[:, 3:6] = s.color if s.back_color is None else s.back_color
            row[:, 6], row[:, 7] = s.sheen, s.gloss
            rows.append(row)
            start.append(count - int(many) * int(self.first_face[k]))
            step.append(int(many))
            count += len(row)
        table = np.concatenate(rows) if rows else np.zeros((0, 8), np.float32)
        return Materials(table, np.array([start, step], np.int32).reshape(2, -1))


@dataclass(frozen=True, eq=False)
class Materials:
    """Rows of colours and how triangles find theirs."""

    table: Array
    """(r, 8) float32: colour, colour of the back, sheen, gloss."""
    place: Array
    """(2, surfaces) int32: the row of triangle t is the first number plus t times the second."""


class Projection:
    """A scene in the picture of a camera."""

    def __init__(self, scene: Scene, camera: Camera, size: tuple[int, int]) -> None:
        """Projects the scene into a picture of `size` (width, height) samples and finds what is nearest."""
        self.scene, self.camera, self.size = scene, camera, size
        self.points = np.zeros((len(scene.vertices), 3))
        """(n, 3) projected vertices, see `Camera.project`."""
        right, up, nearer = camera.axes @ (scene.rows - np.asarray(camera.target)[:, None])
        away = camera.distance - nearer
        lifts = np.repeat([s.lift for s in scene.surfaces], np.diff(scene.first_vertex))
        scale = size[1] / camera.height
        # 1 / distance is affine over a perspective picture, distance over an orthographic one.
        depth = away - lifts
        seen = depth > NEAR
        if camera.perspective:
            scale = scale * camera.distance / np.maximum(away, NEAR * 1e-3)
            depth = -1.0 / np.where(seen, depth, np.nan)
        np.add(right * scale, size[0] / 2, out=self.points[:, 0])
        np.subtract(size[1] / 2, up * scale, out=self.points[:, 1])
        self.points[:, 2] = away
        depths = None
        if not seen.all():
            depth[~seen] = np.nan
            depths = (float(np.nanmin(depth)), float(np.nanmax(depth))) if seen.any() else (1.0, 0.0)
        self.nearest: DepthKeys = nearest_triangles(
            scene.seen_from_afar(self.points, depth, cull=1.0), size, depths
        )
        """Triangles seen at the samples."""
