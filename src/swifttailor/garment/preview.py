"""The preview picture of a garment: front, back and side on the body."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from swifttailor.arrays import Array
from swifttailor.body.mannequin import mannequin
from swifttailor.compiled_loop import CompiledLoop
from swifttailor.garment.cloth_print import CUSHIONS
from swifttailor.garment.cloth_surfaces import ON_DARK, cloth_surfaces
from swifttailor.garment.layer_surfaces import layer_surfaces
from swifttailor.garment.part_looks import color_of_panel
from swifttailor.garment.puffed_cloth import with_puffs
from swifttailor.garment.sheer_figure import SheerFigure
from swifttailor.garment.trim_colors import is_dark, trim_color
from swifttailor.garment.trunk_cloth import around_trunk
from swifttailor.pattern.trims.layers import LAYERS
from swifttailor.pattern.trims.quilting import QUILTING
from swifttailor.render.backdrop import wall
from swifttailor.render.color import BACKGROUND, BODY, Color, encode_srgb, to_linear
from swifttailor.render.framing import frame_views
from swifttailor.render.scene import Scene
from swifttailor.render.surface import LineSet, Surface
from swifttailor.render.view import draw_figure

if TYPE_CHECKING:
    from PIL.Image import Image

    from swifttailor.body import Body
    from swifttailor.garment.garment import Garment

_TRIM_GLOSS = {"metal": 0.25, "button": 0.12, "leather": 0.08}
_put_before = CompiledLoop("swifttailor.render.shading_kernels", "put_before")


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
        if mesh.trim in LAYERS:
            continue  # cloth, see `layer_surfaces`
        look = trim_color(garment, mesh.look, color, trim=mesh.trim, panel=mesh.panel)
        strength = ON_DARK if is_dark(trim_color(garment, "cloth", color)) else 0.5
        lines = (LineSet(mesh.lines, strength=strength, width=1.1),) if len(mesh.lines) else ()
        own = not np.array_equal(look, trim_color(garment, mesh.look, color))
        cushions = color is None and not own and garment.print is not None and garment.print.motif == CUSHIONS
        if mesh.trim == QUILTING and cushions:
            continue  # the print has its lines; these would lie beside them, ragged where cloth folds
        printed = garment.print if color is None and mesh.cloth_at is not None and not own else None
        on_parts = any(one.printed for one in garment.looks)
        if on_parts and (not mesh.panel or color_of_panel(garment, mesh.panel) is not None):
            printed = None
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


def body_surface(
    body: Body, color: Color = BODY, *, cloth: Array | None = None, sleeves: Array | None = None
) -> Surface:
    """The body as a shop's mannequin: smooth, matt, without anatomy.

    Args:
        body: Who wears the garment.
        color: Of the mannequin.
        cloth: (k, 3) vertices of the garment, cm; see `mannequin`.
        sleeves: (s, 3) those of its sleeves, cm.
    """
    vertices, faces = mannequin(body, cloth, sleeves)
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
    garment = with_puffs(garment)
    layers = layer_surfaces(garment, color)
    cloth = [*cloth_surfaces(garment, color), *layers]
    others = trim_surfaces(garment, color)
    if body is not None:
        sleeves = garment.flat_positions[~around_trunk(garment)]
        others.insert(0, body_surface(body, cloth=garment.vertices, sleeves=sleeves))
    if any(part.opacity < 1.0 for part in cloth):
        figure = SheerFigure(others, cloth)
        scene, draw = figure.scene, figure.draw
    else:
        first = others[:1] if body is not None else []
        scene = Scene([*first, *[part.surface for part in cloth], *others[len(first) :]])
        draw = partial(draw_figure, scene)
    picture = wall(size, to_linear(background))
    shown = np.concatenate([garment.vertices, *[part.surface.vertices for part in layers]])
    for view in frame_views(shown, None if body is None else body.vertices, size):
        part = view.width, size[1]
        light, coverage = draw(view.camera, part)
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
