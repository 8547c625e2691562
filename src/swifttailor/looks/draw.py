"""A picture of a garment in a given look."""

from __future__ import annotations

from dataclasses import dataclass
from weakref import WeakKeyDictionary

import numpy as np
from scipy.ndimage import zoom

from swifttailor.arrays import Array, Floats, Ints, Pixels
from swifttailor.body import Body
from swifttailor.garment.cloth_surfaces import border_edges
from swifttailor.garment.garment import Garment
from swifttailor.looks.look import Backdrop, Look, Rgb
from swifttailor.panel_mesh.pattern_mesh import PatternMesh
from swifttailor.render import Camera, LineSet, Surface, render_view
from swifttailor.render.view import render_seen

_GREY: Rgb = (0.58, 0.52, 0.47)
_COARSE_CM = 0.8
"""Where a pixel shows more than this, a body needs no more faces than `Body.coarse` has."""


@dataclass(frozen=True, eq=False)
class ClothMesh:
    """A garment as pictures show it."""

    vertices: Floats
    """(v, 3) cm."""
    faces: Ints
    """(f, 3) vertex indices."""
    face_panel: Ints
    """(f,) panel of each face."""
    cloth_at: Array
    """(f, 3, 2) where on their panel the corners of the faces lie, cm."""
    seams: Ints
    """(s, 2) edges along seams."""
    borders: Ints
    """(b, 2) edges that have one face."""

    @staticmethod
    def of(garment: Garment) -> ClothMesh:
        """Of any garment."""
        sewn = _sewn(garment.mesh)
        mesh = garment.mesh
        return ClothMesh(
            garment.vertices, mesh.faces, mesh.face_panel, sewn.cloth_at, sewn.seams, sewn.borders
        )


@dataclass(frozen=True, eq=False)
class Drawn:
    """A picture and what is seen in it."""

    pixels: Pixels
    """(size, size, 3) uint8 sRGB, row 0 at the top."""
    shares: Array
    """(size, size, surfaces) float32 share of each pixel in which a surface is seen: the body first, where
    there is one, then the garment."""
    face: Array
    """(size, size) int32, see `render.view.Seen`."""
    surfaces: tuple[Surface, ...]
    camera: Camera
    """That saw it."""


def draw_look(garment: Garment, body: Body, look: Look, size: int = 256) -> Pixels:
    """Draws a garment as a look wants it.

    Args:
        garment: What to draw.
        body: Who wears it; hidden where the look has no body, but it still says how tall people are.
        look: Everything else.
        size: Pixels along each side.

    Returns:
        (size, size, 3) uint8 sRGB, row 0 at the top.
    """
    surfaces, camera = _placed(ClothMesh.of(garment), body, look, size)
    return _drawing(render_view, surfaces, camera, look, size)


def draw_seen(cloth: ClothMesh, body: Body, look: Look, size: int = 256) -> Drawn:
    """Draws a garment as `draw_look` does, and says where it is seen; the other arguments are the same."""
    surfaces, camera = _placed(cloth, body, look, size)
    seen = _drawing(render_seen, surfaces, camera, look, size)
    return Drawn(seen.pixels, seen.shares, seen.face, tuple(surfaces), camera)


def draw_body(body: Body, look: Look, size: int = 256) -> Pixels:
    """Draws a body without a garment, seen whole, as a look wants it; grey where the look has nobody.

    Args:
        body: What to draw.
        look: Everything else.
        size: Pixels along each side.

    Returns:
        (size, size, 3) uint8 sRGB, row 0 at the top.
    """
    camera = look_camera(body.vertices, body, look)
    surfaces = [_figure(body, look.body or _GREY, camera, size)]
    return _drawing(render_view, surfaces, camera, look, size)


def _placed(cloth: ClothMesh, body: Body, look: Look, size: int) -> tuple[list[Surface], Camera]:
    camera = look_camera(cloth.vertices, body, look)
    surfaces = [_cloth(cloth, look)]
    if look.body is not None:
        surfaces.insert(0, _figure(body, look.body, camera, size))
    return surfaces, camera


def _figure(body: Body, color: Rgb, camera: Camera, size: int) -> Surface:
    fine = camera.height < _COARSE_CM * size
    vertices, faces = (body.vertices, body.faces) if fine else body.coarse
    return Surface(vertices, faces, np.asarray(color), gloss=0.05, trusted=True)


def _drawing(render, surfaces: list[Surface], camera: Camera, look: Look, size: int):
    return render(
        surfaces,
        camera,
        (size, size),
        background=_backdrop(look.backdrop, size),
        lighting=look.lighting,
        shadows=look.shadows,
        floor=look.shadows and look.view.whole_body and look.body is not None,
        samples=2,
    )


def _cloth(cloth: ClothMesh, look: Look) -> Surface:
    lines: tuple[LineSet, ...] = ()
    if look.seams:
        lines = (
            LineSet(cloth.seams, strength=look.seams, width=0.8),
            LineSet(cloth.borders, strength=look.seams * 0.7, width=0.8),
        )
    tones = np.asarray(look.panel_colors or [(1.0, 1.0, 1.0)])
    plain = not look.panel_colors
    return Surface(
        cloth.vertices,
        cloth.faces,
        tones[0] if len(tones) == 1 else tones[cloth.face_panel % len(tones)],
        np.asarray(look.inside),
        lines=lines,
        lift=0.35,
        sheen=0.08,
        print=look.print if plain else None,
        print_at=cloth.cloth_at if plain else None,
        trusted=True,
    )


@dataclass(frozen=True, eq=False)
class _Sewn:
    """What all pictures of a mesh have in common."""

    seams: Ints
    borders: Ints
    cloth_at: Array


_SEWN: WeakKeyDictionary[PatternMesh, _Sewn] = WeakKeyDictionary()


def _sewn(mesh: PatternMesh) -> _Sewn:
    if mesh not in _SEWN:
        seams = [np.stack([s.vertices[:-1], s.vertices[1:]], axis=1) for s in mesh.seams]
        along = np.concatenate(seams) if seams else np.zeros((0, 2))
        _SEWN[mesh] = _Sewn(
            along.astype(np.int32),
            border_edges(mesh.faces),
            mesh.flat_vertices[mesh.flat_faces].astype(np.float32),
        )
    return _SEWN[mesh]


def look_camera(shown: Floats, body: Body, look: Look) -> Camera:
    """Shows vertices (n, 3) that the body wears as a look wants it."""
    view = look.view
    if view.camera is not None:
        return view.camera
    rows = np.ascontiguousarray(shown.T)  # least and most are found several times faster
    low, high = rows.min(axis=1), rows.max(axis=1)
    if view.whole_body and look.body is not None:
        low = np.minimum(low, body.extent[0] * (0, 1, 0) + (-40, 0, -20))
        high = np.maximum(high, body.extent[1] * (0, 1, 0) + (40, 0, 20))
    middle = (low + high) / 2
    # What is seen is as wide as it is high: a turned box needs the room of its diagonal.
    across = float(np.hypot(high[0] - low[0], high[2] - low[2]))
    seen = max(float(high[1] - low[1]), across) * (1 + 2 * view.margin)
    turned = np.deg2rad(view.azimuth)
    right, up = seen * view.shift[0], seen * view.shift[1]
    x, y, z = middle + np.array([right * np.cos(turned), up, -right * np.sin(turned)])
    return Camera((float(x), float(y), float(z)), seen, view.azimuth, view.elevation, view.field_of_view)


def _backdrop(backdrop: Backdrop, size: int) -> np.ndarray:
    """(size, size, 3) linear light."""
    if backdrop.top == backdrop.bottom and not backdrop.cloudy:
        even = np.zeros((size, size, 3), np.float32)
        for k in range(3):
            even[:, :, k] = min(max(backdrop.top[k], 0.0), 1.0)
        return even
    down = np.linspace(0, 1, size)[:, None, None]
    light = (1 - down) * np.asarray(backdrop.top) + down * np.asarray(backdrop.bottom)
    light = np.broadcast_to(light, (size, size, 3))
    if backdrop.cloudy:
        blots = np.random.default_rng(backdrop.seed).uniform(-1, 1, (6, 6))
        fine = zoom(blots, size / 6, order=2, mode="nearest", grid_mode=True)[:size, :size]
        light = light * (1 + 0.5 * backdrop.cloudy * fine[:, :, None])
    return np.clip(light, 0, 1).astype(np.float32)
