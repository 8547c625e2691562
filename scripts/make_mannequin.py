"""Makes src/swifttailor/body/mannequin.npz: the default body as a shop mannequin, for pictures only.

Where the body has ears, a nose and a chin its signed distances are opened; where it has fingers, toes, a
navel and a cleft they are closed; everywhere they are smoothed. The result lies a hair inside the body,
except in the filled hollows. The file also says how far each vertex stands above the body, so that a hollow
can be emptied where cloth reaches into it. Run from the repository root (a minute or two):

.venv/bin/python scripts/make_mannequin.py
"""

from __future__ import annotations

import io
from pathlib import Path

import numpy as np
from scipy import ndimage, sparse

from swifttailor.arrays import Array
from swifttailor.atomic_files import write_atomically
from swifttailor.body import Body, BodyPart
from swifttailor.body.distance_field import DistanceField
from swifttailor.body.mannequin import UNIT_CM

OUT = Path("src/swifttailor/body/mannequin.npz")
SPACING, MARGIN = 0.5, 6.0
"""Lattice of the distances, cm."""
CELL = 1.65
"""Edge length of the mesh, about, cm."""
INSIDE = 0.10
"""How far under the body's surface it lies, but for filled hollows, cm."""


def main() -> None:
    body = Body.default()
    field = body.distance_field(SPACING, MARGIN)
    values = shape(field, body)
    vertices, faces = surface(DistanceField(values, field.origin, field.spacing))
    over = np.maximum(body.signed_distance(vertices)[0], 0.0)
    buffer = io.BytesIO()
    np.savez_compressed(
        buffer,
        vertices=np.round(vertices / UNIT_CM).astype(np.int16),
        faces=faces.astype(np.uint16),
        over=np.round(over / UNIT_CM).astype(np.uint16),
    )
    write_atomically(OUT, lambda path: path.write_bytes(buffer.getvalue()), overwrite=True)
    print(f"{len(vertices)} vertices, {len(faces)} faces, {len(buffer.getvalue())} bytes")


def shape(field: DistanceField, body: Body) -> Array:
    """Distances to the mannequin on the lattice of the body's."""
    own = 0.5 * (field.values + field.values[::-1]).astype(np.float32)
    x, y = (field.origin[k] + SPACING * np.arange(own.shape[k]) for k in range(2))
    part = {p: body.vertices[body.vertex_part == p] for p in BodyPart}
    crotch = part[BodyPart.TORSO][:, 1].min()
    neck = part[BodyPart.HEAD][:, 1].min()
    wrist = wrist_distance(body)

    torso = soften(fill_slices(own, x, y, crotch), 1.6)
    head = soften(opened(own, 3.2), 2.2)
    hand = soften(closed(own, 4.0), 1.3) - 0.75
    sole = np.searchsorted(y, 1.0)
    standing = closed(own, 1.0)
    standing[:, :sole] = standing[:, sole, None]
    foot = soften(standing, 1.1)

    blended = mix(torso, head, ramp(y, neck + 6.0, neck + 12.0)[None, :, None])
    blended = mix(foot, blended, ramp(y, 8.0, 18.0)[None, :, None])
    along = np.abs(x)[:, None, None] + 0 * y[None, :, None]
    blended = mix(blended, hand, ramp(along, wrist - 6.0, wrist))
    may = 2.5 * ramp(y, crotch + 1.0, crotch + 6.0) * (1 - ramp(y, crotch + 40.0, crotch + 46.0))
    may = may[None, :, None] * (1 - ramp(along, 13.0, 16.0))
    may = np.maximum(may, 2.5 * ramp(along, wrist - 3.0, wrist + 3.0))
    may = np.maximum(may, 1.0 - ramp(y, 8.0, 14.0)[None, :, None])
    kept = np.maximum(blended, soften(own, 0.5) - may) + INSIDE
    return np.maximum(kept, -y[None, :, None]).astype(np.float32)


def wrist_distance(body: Body) -> float:
    """How far to the side of the middle the hands begin, cm."""
    arm = body.vertices[body.vertex_part == BodyPart.LEFT_ARM]
    return float(arm[:, 0].max() - 14.0)


def fill_slices(own: Array, x: Array, y: Array, crotch: float) -> Array:
    """Closes every level slice of the trunk, which fills its clefts and hollows."""
    radius, room = 8.0, 24
    trunk = np.abs(x) < 17.0
    filled = own.copy()
    for k in np.flatnonzero((y > crotch + 1.0) & (y < crotch + 48.0)):
        cut = own[trunk, k]
        grown = distance(np.pad(cut < 0, room)) < radius
        filled[trunk, k] = np.minimum(cut, (distance(grown) + radius)[room:-room, room:-room])
    return filled


def distance(inside: Array) -> Array:
    """Signed distance in cm to the border of a set of nodes."""
    out = ndimage.distance_transform_edt(~inside) - 0.5
    into = ndimage.distance_transform_edt(inside) - 0.5
    return (SPACING * np.where(inside, -into, out)).astype(np.float32)


def opened(own: Array, radius: float) -> Array:
    """Without what a ball of `radius` cm does not fit into."""
    return np.maximum(own, distance(own + radius < 0) - radius)


def closed(own: Array, radius: float) -> Array:
    """With every gap filled that a ball of `radius` cm does not fit into."""
    return np.minimum(own, distance(own - radius < 0) + radius)


def soften(values: Array, sigma: float) -> Array:
    return ndimage.gaussian_filter(np.clip(values, -8.0, 6.0), sigma / SPACING, mode="nearest")


def ramp(at: Array, low: float, high: float) -> Array:
    t = np.clip((at - low) / (high - low), 0.0, 1.0)
    return t * t * (3 - 2 * t)


def mix(one: Array, other: Array, share: Array) -> Array:
    return one + share * (other - one)


def surface(field: DistanceField) -> tuple[Array, Array]:
    """The zero level as a mesh of even triangles: vertices (n, 3) cm, faces (m, 3)."""
    low = field.origin
    counts = (np.array(field.values.shape) * field.spacing / CELL).astype(int)
    # Symmetric about x = 0: nodes at whole multiples and a half of the cell.
    axes = [low[k] + CELL * np.arange(counts[k]) for k in range(3)]
    half = int(-low[0] / CELL)
    axes[0] = CELL * (np.arange(2 * half) - half + 0.5)
    points = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1)
    # Hands are thin: a little outside, so that they are not lost between the nodes. The rounds below mend it.
    outside = np.where(np.abs(points[..., 0]) > 45.0, 0.4, 0.0)
    inside = field.sample(points.reshape(-1, 3))[0].reshape(outside.shape) < outside
    vertices, faces = surface_net(inside)
    vertices = np.array([a[0] for a in axes]) + CELL * vertices
    vertices, faces = largest_part(vertices, faces)
    neighbours = adjacency(faces, len(vertices))
    for _ in range(40):
        vertices = 0.4 * vertices + 0.6 * (neighbours @ vertices)
        for _ in range(2):
            away, direction = field.sample(vertices)
            vertices = vertices - away[:, None] * direction
    vertices[:, 1] = np.maximum(vertices[:, 1], 0.0)
    return vertices, faces


def surface_net(inside: Array) -> tuple[Array, Array]:
    """Naive surface nets: one vertex in each cell that the border passes, in units of cells."""
    corners = sum(
        inside[i : inside.shape[0] - 1 + i, j : inside.shape[1] - 1 + j, k : inside.shape[2] - 1 + k].astype(
            int
        )
        for i in (0, 1)
        for j in (0, 1)
        for k in (0, 1)
    )
    mixed = (corners > 0) & (corners < 8)
    number = np.full(mixed.shape, -1)
    number[mixed] = np.arange(mixed.sum())
    faces = []
    for axis in range(3):
        here = np.take(inside, range(inside.shape[axis] - 1), axis)
        there = np.take(inside, range(1, inside.shape[axis]), axis)
        at = np.argwhere(here != there)
        second, third = (axis + 1) % 3, (axis + 2) % 3
        at = at[(at[:, second] > 0) & (at[:, third] > 0)]
        steps = np.zeros((4, 3), int)
        steps[1, second] = steps[2, second] = steps[2, third] = steps[3, third] = -1
        quad = np.stack([number[tuple((at + s).T)] for s in steps], axis=1)
        outward = here[tuple(at.T)]
        quad[~outward] = quad[~outward][:, ::-1]
        faces += [quad[:, [0, 1, 2]], quad[:, [0, 2, 3]]]
    return np.argwhere(mixed) + 0.5, np.concatenate(faces)


def largest_part(vertices: Array, faces: Array) -> tuple[Array, Array]:
    n = len(vertices)
    ring = adjacency(faces, n)
    _, label = sparse.csgraph.connected_components(ring)
    kept = label == np.bincount(label).argmax()
    number = np.cumsum(kept) - 1
    return vertices[kept], number[faces[kept[faces[:, 0]]]]


def adjacency(faces: Array, count: int) -> sparse.csr_matrix:
    """(n, n) rows average a vertex's neighbours."""
    edges = faces[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2)
    links = sparse.coo_matrix((np.ones(len(edges)), edges.T), (count, count)).tocsr()
    links = ((links + links.T) > 0).astype(float)
    return sparse.diags(1.0 / np.asarray(links.sum(axis=1)).ravel()) @ links


if __name__ == "__main__":
    main()
