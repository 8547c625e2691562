"""Pictures of cloth that one can see through: the figure with and without it, blended by what it hides.

Three pictures are drawn of each view: all cloth; without the sheer cloth that faces the camera, so that the
far side of a sleeve or skirt is seen through the near one; and without any sheer cloth. Opaque cloth is taken
from the first, with the shadows that fall on it.
"""

from __future__ import annotations

from collections.abc import Sequence
from copy import copy
from dataclasses import replace

import numpy as np

from swifttailor.arrays import Array
from swifttailor.garment.cloth_surfaces import SeenCloth
from swifttailor.render.camera import Camera
from swifttailor.render.printing import paint_prints
from swifttailor.render.scene import Projection, Scene
from swifttailor.render.surface import Surface
from swifttailor.render.view import light_figure, project

_SAMPLES = 2


class SheerFigure:
    """A figure of which some cloth is sheer."""

    def __init__(self, opaque: Sequence[Surface], cloth: Sequence[SeenCloth]) -> None:
        """Puts the surfaces together.

        Args:
            opaque: What is seen besides the cloth: who wears it, what is put on it.
            cloth: All of it.
        """
        self._sheer = [part for part in cloth if part.opacity < 1.0]
        self._opaque = [*opaque, *[part.surface for part in cloth if part.opacity >= 1.0]]
        self.scene = self._scene([None] * len(self._sheer))
        """All of it, as opaque things cast shadows."""

    def draw(self, camera: Camera, size: tuple[int, int]) -> tuple[Array, Array]:
        """Draws it before nothing; arguments and result are those of `render.view.draw_figure`."""
        towards = [_faces_towards(part.surface, camera) for part in self._sheer]
        light, coverage, _ = self._seen(self._scene([np.zeros(len(t), bool) for t in towards]), camera, size)
        for kept in ([~t for t in towards], [None] * len(towards)):
            scene = self.scene if kept[0] is None else self._scene(kept)
            nearer, covered, share = self._seen(scene, camera, size, kept)
            light += share * (nearer - light)
            coverage += share * (covered - coverage)
        return light, coverage

    def _scene(self, kept: Sequence[Array | None]) -> Scene:
        """The scene with some faces (m,) bool of each sheer surface; None: with all of them."""
        sheer = [_part_of(part.surface, faces) for part, faces in zip(self._sheer, kept, strict=True)]
        return Scene([*self._opaque, *sheer])

    def _seen(
        self,
        scene: Scene,
        camera: Camera,
        size: tuple[int, int],
        kept: Sequence[Array | None] = (),
    ) -> tuple[Array, Array, Array]:
        """Light and coverage of a scene, and which share (h, w, 1) of each pixel hides what lies behind."""
        projection = project(scene, camera, size, _SAMPLES)
        light, coverage = light_figure(projection, size, samples=_SAMPLES)
        share = (
            self._opacity(projection, kept) if kept else np.ones(projection.nearest.keys.shape, np.float32)
        )
        width, height = size
        mean = share.reshape(height, _SAMPLES, width, _SAMPLES).mean(axis=(1, 3))
        return light, coverage, mean[:, :, None]

    def _opacity(self, projection: Projection, kept: Sequence[Array | None]) -> Array:
        """(H, W) float32 share that each sample hides of what lies behind it; 1 where nothing is seen."""
        first = len(self._opaque)
        shares = np.ones(len(projection.scene.surfaces) + 1, np.float32)
        shares[first : first + len(self._sheer)] = [part.opacity for part in self._sheer]
        face = projection.nearest.face
        surface = np.where(face >= 0, projection.scene.face_surface[face], len(shares) - 1)
        opacity = shares[surface]
        with_figures = [k for k, part in enumerate(self._sheer) if part.figures is not None]
        if not with_figures:
            return opacity
        painted = list(projection.scene.surfaces)
        for k in with_figures:
            part, faces = self._sheer[k], kept[k]
            at = part.figures_at if faces is None or part.figures_at is None else part.figures_at[faces]
            painted[first + k] = replace(painted[first + k], print=part.figures, print_at=at, trusted=True)
        for k, each in enumerate(painted[:first]):
            painted[k] = replace(each, print=None, print_at=None, trusted=True)
        shown = copy(projection)
        shown.scene = copy(projection.scene)
        shown.scene.surfaces = tuple(painted)
        paint = paint_prints(shown, _SAMPLES, few=False).paint[:, :, 0]
        # The wrong side has no print: there what the net hides stands for all.
        for k in with_figures:
            mine = (surface == first + k) & (paint > 0.0)
            opacity[mine] = paint[mine]
        return opacity


def _part_of(surface: Surface, faces: Array | None) -> Surface:
    """Some faces (m,) bool of a surface; None: all of them."""
    if faces is None:
        return surface

    def some(values: Array | None) -> Array | None:
        return (
            values[faces] if values is not None and len(values) == len(faces) and values.ndim > 1 else values
        )

    color = some(surface.color)
    assert color is not None
    return replace(
        surface,
        faces=surface.faces[faces],
        color=color,
        back_color=some(surface.back_color),
        print_at=some(surface.print_at),
        trusted=True,
    )


def _faces_towards(surface: Surface, camera: Camera) -> Array:
    """(m,) bool: whether the right side of each face is seen, by its turn towards the camera."""
    a, b, c = (surface.vertices[surface.faces[:, k]] for k in range(3))
    normal = np.cross(b - a, c - a)
    eye = np.asarray(camera.target) + camera.distance * camera.axes[2]
    to_camera = eye - (a + b + c) / 3 if camera.perspective else np.broadcast_to(camera.axes[2], normal.shape)
    return (normal * to_camera).sum(axis=1) > 0.0
