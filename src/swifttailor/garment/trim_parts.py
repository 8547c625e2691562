"""What is put on a garment, joined where trim and colour are one: what files and the studio hold."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from swifttailor.arrays import Array
from swifttailor.garment.trim_colors import trim_color
from swifttailor.garment.trim_meshes import TrimMesh, trim_meshes
from swifttailor.render.color import encode_srgb

if TYPE_CHECKING:
    from swifttailor.garment.garment import Garment


@dataclass(frozen=True, eq=False)
class TrimPart:
    """What is put on the cloth in one place and one colour: pockets, buttons, a belt."""

    name: str
    vertices: Array
    """(n, 3) cm."""
    faces: Array
    """(m, 3) vertex indices."""
    color: str
    """``#rrggbb``."""
    look: str
    """As `TrimMesh.look`."""
    lines: Array
    """(k, 2) edges that show, as vertex indices."""
    flat: Array | None = None
    """As `TrimMesh.flat`; None where a piece has none."""
    panel: Array | None = None
    """(n,) indices of the panels on which that is; goes with `flat`."""
    is_own_color: bool = False
    """Whether it is of another colour than such trims have on the cloth of the garment."""
    opacity: float = 1.0
    """As `TrimMesh.opacity`."""


def trim_parts(garment: Garment) -> tuple[TrimPart, ...]:
    """The trims of a garment, fewer and larger than `trim_meshes`."""
    own: dict[tuple[str, str, str], bool] = {}
    joined: dict[tuple[str, str, str], list[TrimMesh]] = {}
    for mesh in trim_meshes(garment):
        light = trim_color(garment, mesh.look, trim=mesh.trim, panel=mesh.panel)
        color = "#" + "".join(f"{part:02x}" for part in encode_srgb(light))
        joined.setdefault((mesh.trim, mesh.look, color), []).append(mesh)
        own[mesh.trim, mesh.look, color] = not np.array_equal(light, trim_color(garment, mesh.look))
    parts = []
    for (trim, look, color), meshes in joined.items():
        first = np.cumsum([0, *[len(mesh.vertices) for mesh in meshes]])[:-1]
        flats = [mesh.flat for mesh in meshes if mesh.flat is not None]
        on = [(garment.pattern.panel_index(m.panel), len(m.flat)) for m in meshes if m.flat is not None]
        parts.append(
            TrimPart(
                f"{trim} ({look})",
                np.concatenate([mesh.vertices for mesh in meshes]),
                np.concatenate([mesh.faces + start for mesh, start in zip(meshes, first, strict=True)]),
                color,
                look,
                np.concatenate([mesh.lines + start for mesh, start in zip(meshes, first, strict=True)]),
                np.concatenate(flats) if len(flats) == len(meshes) else None,
                np.repeat(*np.transpose(on)) if len(flats) == len(meshes) else None,
                own[trim, look, color],
                meshes[0].opacity,
            )
        )
    return tuple(parts)
