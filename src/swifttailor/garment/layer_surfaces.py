"""Layers over a skirt and trains as the renderer draws them: of the skirt's cloth, or of tulle."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from swifttailor.garment.cloth_color import cloth_color
from swifttailor.garment.cloth_surfaces import ON_DARK, SeenCloth, inside_of, print_of, shine_of
from swifttailor.garment.trim_colors import DARKEST
from swifttailor.garment.trim_layers import layer_mesh
from swifttailor.pattern.trims.layers import LAYERS
from swifttailor.pattern.trims.shapes import Layer
from swifttailor.render.color import Color, to_linear
from swifttailor.render.surface import LineSet, Surface

if TYPE_CHECKING:
    from swifttailor.garment.garment import Garment
    from swifttailor.garment.trim_pieces import TrimMesh


def layer_surfaces(garment: Garment, color: Color | None = None) -> list[SeenCloth]:
    """What hangs over the skirt of a garment, or lies behind it.

    Args:
        garment: Any garment.
        color: Right side of its cloth; None: its own.
    """
    if LAYERS.isdisjoint(garment.pattern.trims):
        return []
    from swifttailor.pattern.trims.placing import place_trims

    pieces = [piece for piece in place_trims(garment.pattern) if isinstance(piece, Layer)]
    meshes = [mesh for piece in pieces if (mesh := layer_mesh(garment, piece)) is not None]
    return [_seen(garment, mesh, color) for mesh in meshes]


def _seen(garment: Garment, mesh: TrimMesh, color: Color | None) -> SeenCloth:
    from swifttailor.garment.part_looks import looks_of_panels

    look = looks_of_panels(garment)[garment.pattern.panel_index(mesh.panel)]
    own = look.color or garment.color or cloth_color(garment.pattern)
    base = np.maximum(to_linear(own if color is None else color), DARKEST)
    printed = print_of(garment, look, own) if color is None and mesh.opacity >= 1.0 else None
    wrong, is_black = inside_of(base, printed)
    opacity = mesh.opacity if mesh.opacity < 1.0 or look.lace else look.opacity
    sheen, gloss = shine_of(garment, printed)
    surface = Surface(
        mesh.vertices,
        mesh.faces,
        base,
        wrong,
        lines=(LineSet(mesh.lines, strength=ON_DARK if is_black else 0.30, width=1.2),),
        lift=0.35,
        sheen=sheen,
        gloss=gloss,
        print=None if printed is None else printed.drawn(),
        print_at=None if printed is None else mesh.cloth_at,
    )
    return SeenCloth(surface, opacity)
