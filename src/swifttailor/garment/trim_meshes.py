"""The trims of a garment as small meshes that lie on its cloth: for pictures and files (`trim_parts`)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np
from scipy.spatial import KDTree

from swifttailor.arrays import Array, Floats, Ints
from swifttailor.garment.cloth_print import flat_places
from swifttailor.garment.trim_belts import belt_meshes, on_a_belt, under_a_belt
from swifttailor.garment.trim_decorations import bow_meshes, frill_meshes
from swifttailor.garment.trim_layers import laid_over, layer_mesh
from swifttailor.garment.trim_pieces import AROUND, TrimMesh
from swifttailor.garment.trim_stirrups import stirrup_mesh
from swifttailor.pattern.trims.knit_bands import KNIT_BANDS
from swifttailor.pattern.trims.names import COUNTED
from swifttailor.pattern.trims.placing import place_trims
from swifttailor.pattern.trims.rips import threads_across
from swifttailor.pattern.trims.shapes import Belt, Bow, Button, Frill, Layer, Patch, Stirrup, Trim

if TYPE_CHECKING:
    from swifttailor.garment.garment import Garment

STEP = 1.3
"""Distance of the points of a patch, cm."""
_LIFT = {"cloth": 0.30, "dark": 0.42, "metal": 0.36, "hole": 0.24, "thread": 0.44}
"""How far pieces lie above the cloth, cm."""
_FINE_STEP, _HANGING, _FOLD_LIFT = 0.5, 1.6, 0.05
"""Distance of the points across a fold, cm; a power of the way down it, by which it is fullest low down; and
how far its edges lie above the cloth, cm."""
_QUILTING_LIFT = 0.14
"""Stitches through wadding lie deeper than those on top of pockets."""
_BUTTON_LIFT, _ON_BANDS, _BUTTON_HEIGHT = 0.34, 0.7, 0.22
_NO_AREA = 1e-5
"""Triangles of less than half of this are left out, cm²."""
_NEAR = 12
"""Faces around a point, one of which it lies in, nearly always."""
_INSIDE = 1e-6
"""Least weight, below 0, of points that count as inside of a face."""
_MOST_AT_ONCE = 4_000_000


@dataclass(frozen=True, eq=False)
class _OnCloth:
    """Places on the sewn cloth, n of them."""

    points: Floats
    """(n, 3) cm."""
    normals: Floats
    """(n, 3) unit vectors."""
    corners: Ints
    """(n, 3) flat vertices around each."""
    weights: Floats
    """(n, 3) of the corners."""


def trim_meshes(garment: Garment) -> list[TrimMesh]:
    """The trims that the garment's pattern names; none where it names none."""
    pattern = garment.pattern
    if not pattern.trims:
        return []
    found: list[TrimMesh] = []
    layers: list[TrimMesh] = []
    places = flat_places(garment)
    pieces = _seen(place_trims(pattern))
    belts = {piece.trim: piece for piece in pieces if isinstance(piece, Belt)}
    for piece in pieces:
        if isinstance(piece, Belt):
            found += belt_meshes(garment, piece)
        elif isinstance(piece, Button):
            button = _button(garment, piece)
            found += [] if under_a_belt(belts, garment, button) else [button]
        elif isinstance(piece, Stirrup):
            strap = stirrup_mesh(garment, piece)
            found += [] if strap is None else [strap]
        elif isinstance(piece, Layer):
            cloth = layer_mesh(garment, piece)
            layers += [] if cloth is None else [cloth]
        elif isinstance(piece, Frill):
            found += frill_meshes(garment, piece)
        elif isinstance(piece, Bow):
            on = _on_cloth(garment, piece.panel, np.array([piece.at]))
            at = on_a_belt(garment, belts[piece.trim], on.points[0]) if piece.trim in belts else on.points[0]
            bow = bow_meshes(garment, piece, at, on.normals[0])
            found += [replace(mesh, panel=piece.panel) for mesh in bow]  # whose colour it has
        else:
            found.append(_patch(garment, piece, places))
            if piece.look == "hole" and "rip" in piece.trim:
                found += [_patch(garment, thread, places) for thread in threads_across(piece)]
    return [*laid_over(layers, found), *layers] if layers else found


def _seen(pieces: Sequence[Trim]) -> list[Trim]:
    """Those that no apron lies over."""
    under = {piece.panel for piece in pieces if isinstance(piece, Patch) and piece.trim == "apron"}
    hidden = [p for p in pieces if isinstance(p, Button | Patch) and p.panel in under and p.trim in COUNTED]
    return [piece for piece in pieces if piece not in hidden]


def _patch(garment: Garment, patch: Patch, places: Array) -> TrimMesh:
    """A ruled piece: its points lifted off the cloth, its border brought down to it.

    Args:
        garment: What it is on.
        patch: What lies on the panel.
        places: (m, 2) where on the cloth the flat vertices lie, cm.
    """
    lengths = np.linalg.norm(np.diff(patch.first, axis=0), axis=1)
    along = np.concatenate(
        [
            np.linspace(k, k + 1, max(int(np.ceil(length / STEP)), 1), endpoint=False)
            for k, length in enumerate(lengths)
        ]
        + [[float(len(lengths))]]
    )
    first, second = (_at(line, along) for line in (patch.first, patch.second))
    widths = np.linalg.norm(second - first, axis=1)
    across = max(int(np.ceil(widths.max() / (_FINE_STEP if patch.swell else STEP))), 1)
    share = np.linspace(0, 1, across + 1)[:, None, None]
    flat = (1 - share) * first + share * second
    rows, columns = flat.shape[:2]
    flat = flat.reshape(-1, 2)
    on = _on_cloth(garment, patch.panel, flat)
    points, normals = on.points, on.normals
    lift = _QUILTING_LIFT if patch.trim == "quilting" else _LIFT[patch.look]
    count = rows * columns
    grid = np.arange(count).reshape(rows, columns)
    ring = np.concatenate([grid[0, :-1], grid[:-1, -1], grid[-1, :0:-1], grid[:0:-1, 0]])
    if patch.swell:
        lift = _FOLD_LIFT + patch.swell * _bulge(widths / widths.max(), across).reshape(-1, 1)
    vertices = np.concatenate([points + lift * normals, points[ring]])
    low = count + np.arange(len(ring))
    quads = np.stack([grid[:-1, :-1], grid[:-1, 1:], grid[1:, 1:], grid[1:, :-1]], axis=-1).reshape(-1, 4)
    walls = np.stack([ring, low, np.roll(low, -1), np.roll(ring, -1)], axis=-1)
    quads = quads if patch.swell else np.concatenate([quads, walls])
    border = np.stack([ring, np.roll(ring, -1)], axis=1) if patch.look == "cloth" else np.zeros((0, 2), int)
    if patch.swell:  # only where it ends below, and not in the middle, where both halves meet
        border = np.stack([grid[-1, :-1], grid[-1, 1:]], axis=1)
    faces = np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])
    faces = _outward(vertices, faces, normals, points)
    a, b, c = (vertices[faces[:, k]] for k in range(3))
    across = np.linalg.norm(np.cross(b - a, c - a), axis=1)
    faces = faces[across > _NO_AREA]  # of what lies in a dart, some is sewn to one point
    at = None
    if patch.look == "cloth":
        lie = np.einsum("nk,nkc->nc", on.weights, places[on.corners])
        at = np.concatenate([lie, lie[ring]])[faces]
    flats = np.concatenate([flat, flat[ring]])
    return TrimMesh(patch.trim, patch.look, vertices, faces, border, at, flats, patch.panel)


def _bulge(widths: Array, across: int) -> Array:
    """How far the points (across + 1, n) of a fold stand off, 0 to 1: it hangs, and is fullest low down.

    Args:
        widths: (n,) of the fold along it, over the greatest.
        across: How many meshes it is wide.
    """
    share = np.linspace(0.0, 1.0, across + 1)[:, None]
    return np.sin(np.pi * share**_HANGING) * widths


def _button(garment: Garment, button: Button) -> TrimMesh:
    """A flat dome."""
    on = _on_cloth(garment, button.panel, np.array([button.at]))
    at, normal = on.points[0], on.normals[0]
    u, v = _beside(normal)
    angle = np.arange(AROUND) * (2 * np.pi / AROUND)
    circle = np.cos(angle)[:, None] * u + np.sin(angle)[:, None] * v
    middle = at + (_ON_BANDS if KNIT_BANDS in garment.pattern.trims else _BUTTON_LIFT) * normal
    low, high = (
        middle + button.radius * circle,
        middle + 0.8 * button.radius * circle + _BUTTON_HEIGHT * normal,
    )
    vertices = np.concatenate([low, high, [middle + 0.7 * _BUTTON_HEIGHT * normal]])
    k, after = np.arange(AROUND), np.roll(np.arange(AROUND), -1)
    top = np.full(AROUND, 2 * AROUND)
    faces = np.concatenate(
        [
            np.stack([k, after, after + AROUND], axis=1),
            np.stack([k, after + AROUND, k + AROUND], axis=1),
            np.stack([k + AROUND, after + AROUND, top], axis=1),
        ]
    )
    return TrimMesh(
        button.trim,
        "button",
        vertices,
        faces.astype(np.int32),
        np.stack([k, after], axis=1).astype(np.int32),
        panel=button.panel,
    )


def _on_cloth(garment: Garment, panel: str, flat: Array) -> _OnCloth:
    """Where panel-local points (n, 2) lie on the sewn cloth.

    Where the cloth does not reach, the nearest that there is.
    """
    mesh = garment.mesh
    of_panel = np.flatnonzero(mesh.face_panel == mesh.pattern.panel_index(panel))
    corners = mesh.flat_vertices[mesh.flat_faces[of_panel]]
    near = min(_NEAR, len(of_panel))
    _, faces = KDTree(corners.mean(axis=1)).query(flat, near)
    face, weights = _best_of(corners, faces.reshape(-1, near), flat)
    # Most points lie in one of the faces around them; the others look at all.
    outside = np.flatnonzero(weights.min(axis=1) < -_INSIDE)
    at_once = max(_MOST_AT_ONCE // max(len(of_panel), 1), 1)
    for first in range(0, len(outside), at_once):
        part = outside[first : first + at_once]
        every = np.broadcast_to(np.arange(len(of_panel)), (len(part), len(of_panel)))
        face[part], weights[part] = _best_of(corners, every, flat[part])
    weights = np.maximum(weights, 0.0)
    weights /= weights.sum(axis=1, keepdims=True)
    face = of_panel[face]
    welded = mesh.faces[face]
    points = np.einsum("nk,nkc->nc", weights, garment.vertices[welded])
    normals = np.einsum("nk,nkc->nc", weights, garment.vertex_normals[welded])
    normals = normals / np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-9)
    return _OnCloth(points, normals, mesh.flat_faces[face], weights)


def _best_of(corners: Array, faces: Array, flat: Array) -> tuple[Ints, Floats]:
    """The face that each point lies in, or is least outside of, and its weights there.

    Args:
        corners: (f, 3, 2) of all faces, panel-local cm.
        faces: (n, k) those to look at for each point.
        flat: (n, 2) points, panel-local cm.

    Returns:
        (n,) faces; (n, 3) barycentric weights, the least of them below 0 of points outside.
    """
    origin = corners[:, 0]
    one, other = corners[:, 1] - origin, corners[:, 2] - origin
    area = one[:, 0] * other[:, 1] - one[:, 1] * other[:, 0]
    away = flat[:, None] - origin[faces]
    b = (away[..., 0] * other[faces, 1] - away[..., 1] * other[faces, 0]) / area[faces]
    c = (one[faces, 0] * away[..., 1] - one[faces, 1] * away[..., 0]) / area[faces]
    best = np.minimum(np.minimum(b, c), 1 - b - c).argmax(axis=1)
    rows = np.arange(len(flat))
    b, c = b[rows, best], c[rows, best]
    return faces[rows, best], np.stack([1 - b - c, b, c], axis=1)


def _at(line: Array, along: Array) -> Array:
    """Points (m, 2) of a polyline (n, 2) at positions counted in its points."""
    places = np.arange(len(line))
    return np.stack([np.interp(along, places, line[:, k]) for k in range(2)], axis=1)


def _beside(normal: Array) -> tuple[Array, Array]:
    """Two unit vectors at right angles to a normal and to each other, so that the three are right-handed."""
    helper = np.array([0.0, 1.0, 0.0]) if abs(normal[1]) < 0.9 else np.array([1.0, 0.0, 0.0])
    u = np.cross(helper, normal)
    u /= np.linalg.norm(u)
    return u, np.cross(normal, u)


def _outward(vertices: Array, faces: Array, normals: Array, points: Array) -> Ints:
    """The faces wound so that the patch faces away from the cloth."""
    a, b, c = (vertices[faces[:, k]] for k in range(3))
    across = np.cross(b - a, c - a)
    inner = faces.max(axis=1) < len(points)
    facing = np.einsum("nc,nc->n", across[inner], normals[faces[inner, 0]]).sum()
    return (faces if facing >= 0 else faces[:, ::-1]).astype(np.int32)
