"""The preview picture of a garment: front, back and side on the body."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from swifttailor.arrays import Array
from swifttailor.body.mannequin import mannequin
from swifttailor.compiled_loop import CompiledLoop
from swifttailor.garment.cloth_color import cloth_color
from swifttailor.garment.cloth_print import cloth_at
from swifttailor.garment.trim_colors import DARK, DARKEST, GREY, trim_color
from swifttailor.render.backdrop import wall
from swifttailor.render.color import BACKGROUND, BODY, Color, encode_srgb, to_linear
from swifttailor.render.framing import frame_views
from swifttailor.render.scene import Scene
from swifttailor.render.surface import LineSet, Surface
from swifttailor.render.view import draw_figure

if TYPE_CHECKING:
    from PIL.Image import Image

    from swifttailor.body import Body
    from swifttailor.garment.cloth_print import ClothPrint
    from swifttailor.garment.garment import Garment

_SHEEN = {"silk": 0.22, "denim": 0.06, "twill": 0.08, "leather": 0.16, "polyester": 0.16, "swimwear": 0.16}
_GLOSS = {"silk": 0.08, "leather": 0.10, "polyester": 0.04, "swimwear": 0.05}
"""Of cloths that shine otherwise than cotton does."""
_TRIM_GLOSS = {"metal": 0.25, "button": 0.12, "leather": 0.08}
_WOVEN, _REPEATS_CM = ("stripes", "checks", "plaid"), 48.0
"""Prints that go through to the wrong side, and a width over which they repeat."""
_ON_DARK = -1.3
"""How much lighter seams are than dark cloth, in previews."""
_put_before = CompiledLoop("swifttailor.render.shading_kernels", "put_before")


def cloth_surface(
    garment: Garment,
    color: Color | None = None,
    *,
    tint_panels: bool = True,
    lines: bool = True,
    seen_on_dark: bool = False,
) -> Surface:
    """The garment as the renderer draws it.

    Args:
        garment: Any garment.
        color: Right side of the cloth; the inside is a little darker and greyer, as that of dyed cloth is.
            None: the garment's own (`cloth_color`).
        tint_panels: Whether neighbouring panels differ a little in lightness.
        lines: Whether seams and hems are drawn.
        seen_on_dark: Whether they are lighter than dark cloth, on which darker ones would not be seen.
    """
    base = np.maximum(
        to_linear(garment.color or cloth_color(garment.pattern) if color is None else color), DARKEST
    )
    right = np.broadcast_to(base, (len(garment.faces), 3))
    if tint_panels:
        # Golden-ratio steps keep consecutive panels apart whatever their number.
        step = (np.arange(len(garment.pattern.panels)) * 0.618034) % 1.0
        right = base * (0.90 + 0.20 * step)[garment.mesh.face_panel][:, None]
    printed = garment.print if color is None else None
    if printed is not None:
        base = np.maximum(_wrong_side(printed), DARKEST)
    grey = float(base @ GREY)
    inside = 0.78 * (0.75 * base + 0.25 * grey) + 0.002
    drawn = ()
    if lines:
        light = seen_on_dark and grey < DARK
        drawn = (
            LineSet(_seam_edges(garment), strength=_ON_DARK if light else 0.42, width=1.1),
            LineSet(border_edges(garment.faces), strength=0.30, width=1.2),
        )
    return Surface(
        garment.vertices,
        garment.faces,
        np.clip(right, 0, 1),
        inside,
        lines=drawn,
        lift=0.35,
        sheen=_SHEEN.get(garment.cloth or "", 0.10),
        gloss=_GLOSS.get(garment.cloth or "", 0.0),
        print=None if printed is None else printed.drawn(),
        print_at=None if printed is None else cloth_at(garment),
    )


def _wrong_side(printed: ClothPrint) -> Array:
    """(3,) linear light: of what is printed the first colour, of what is woven the mean of all."""
    if printed.kind not in _WOVEN:
        return to_linear(printed.colors[0])
    across = np.linspace(0.0, _REPEATS_CM, 64)
    return printed.drawn().colors(np.stack(np.meshgrid(across, across), axis=-1).reshape(-1, 2)).mean(axis=0)


def trim_surfaces(garment: Garment, color: Color | None = None) -> list[Surface]:
    """Pockets, buttons, belts and the like of a garment, as the renderer draws them.

    Args:
        garment: Any garment.
        color: Of its cloth; None: its own.
    """
    if not garment.pattern.trims:
        return []
    from swifttailor.garment.trim_meshes import trim_meshes

    surfaces = []
    for mesh in trim_meshes(garment):
        look = trim_color(garment, mesh.look, color)
        strength = _ON_DARK if float(trim_color(garment, "cloth", color) @ GREY) < DARK else 0.5
        lines = (LineSet(mesh.lines, strength=strength, width=1.1),) if len(mesh.lines) else ()
        printed = garment.print if color is None and mesh.cloth_at is not None else None
        surfaces.append(
            Surface(
                mesh.vertices,
                mesh.faces,
                look,
                look,
                lines=lines,
                lift=0.35,
                sheen=0.1,
                gloss=_TRIM_GLOSS.get(mesh.look, 0.0),
                print=None if printed is None else printed.drawn(),
                print_at=None if printed is None else mesh.cloth_at,
            )
        )
    return surfaces


def body_surface(body: Body, color: Color = BODY, *, cloth: Array | None = None) -> Surface:
    """The body as a shop's mannequin: smooth, matt, without anatomy.

    Args:
        body: Who wears the garment.
        color: Of the mannequin.
        cloth: (k, 3) vertices of the garment, cm; see `mannequin`.
    """
    vertices, faces = mannequin(body, cloth)
    return Surface(vertices, faces, to_linear(color), gloss=0.02)


def render_preview(
    garment: Garment,
    body: Body | None,
    *,
    size: tuple[int, int] = (1500, 900),
    color: Color | None = None,
    background: Color = BACKGROUND,
) -> Image:
    """What `draw_preview` draws, as a picture of Pillow's."""
    from PIL import Image

    return Image.fromarray(draw_preview(garment, body, size=size, color=color, background=background))


def draw_preview(
    garment: Garment,
    body: Body | None,
    *,
    size: tuple[int, int] = (1500, 900),
    color: Color | None = None,
    background: Color = BACKGROUND,
) -> Array:
    """Draws a garment from the front, the back and the wearer's left side by side.

    Args:
        garment: What to show.
        body: Who wears it; None draws the garment alone.
        size: Width and height of the whole picture in pixels.
        color: Right side of the cloth; None: the garment's own (`cloth_color`).
        background: Backdrop.

    Returns:
        (height, width, 3) uint8 sRGB.
    """
    surfaces = [cloth_surface(garment, color, seen_on_dark=True), *trim_surfaces(garment, color)]
    if body is not None:
        surfaces.insert(0, body_surface(body, cloth=garment.vertices))
    scene = Scene(surfaces)
    picture = wall(size, to_linear(background))
    for view in frame_views(garment.vertices, None if body is None else body.vertices, size):
        part = view.width, size[1]
        light, coverage = draw_figure(scene, view.camera, part)
        floor = np.ones(coverage.shape, np.float32)
        shadow = scene.floor_shadow(view.camera.height / size[1])
        if shadow is not None:
            floor = shadow.light(view.camera, part)
        _put_before(picture, view.first, light, coverage, floor, _fade(view.width))
    return encode_srgb(picture)


def _fade(width: int) -> Array:
    """(width,) share of the figure drawn in each column of a view: what a frame cuts off ends softly."""
    from_border = np.minimum(np.arange(width), np.arange(width)[::-1]) + 0.5
    t = np.clip(from_border / min(28.0, width / 8), 0.0, 1.0)
    return (t * t * (3 - 2 * t)).astype(np.float32)


def _seam_edges(garment: Garment) -> Array:
    parts = [
        np.stack([s.vertices[:-1], s.vertices[1:]], axis=1) for s in garment.seams if len(s.vertices) > 1
    ]
    return np.concatenate(parts) if parts else np.zeros((0, 2), np.int32)


def border_edges(faces: Array) -> Array:
    """(n, 2) vertex indices of the edges that only one of the faces (m, 3) has."""
    edges = np.sort(faces[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1).astype(np.int64)
    key = edges[:, 0] * (int(faces.max(initial=0)) + 1) + edges[:, 1]
    _, first, count = np.unique(key, return_index=True, return_counts=True)
    return edges[first[count == 1]].astype(np.int32)
