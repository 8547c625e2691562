"""The mechanical model of a garment: masses, springs and hinges, their rest state from the flat pattern."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from swifttailor.arrays import Floats, Ints
from swifttailor.draping.fabric import Fabric
from swifttailor.panel_mesh.pattern_mesh import PatternMesh
from swifttailor.panel_mesh.topology import edge_keys, edges_of_keys

_SPRING_FACTOR = (
    1.5  # an equilateral spring lattice of this stiffness has the membrane stiffness of the cloth
)
_MIN_MASS_SHARE = 0.05
_MIN_SPACING_CM = 0.5


class ClothArrays(NamedTuple):
    """What the solver reads in its inner loops; lengths in cm, masses in kg."""

    faces: Ints
    """(f, 3)"""
    edges: Ints
    """(e, 2)"""
    rest: Floats
    """(e,) rest lengths; the sewing stage lends its own."""
    compliance: Floats
    """(e,) inverse spring stiffness, s^2/kg."""
    hinges: Ints
    """(h, 4) the shared edge's two vertices, then the two opposite ones."""
    hinge_weights: Floats
    """(h, 4) isometric bending weights, 1/cm."""
    hinge_compliance: Floats
    """(h,)"""
    inverse_mass: Floats
    """(v,) 1/kg"""
    neighbor_start: Ints
    """(v + 1,) row starts of `neighbors`."""
    neighbors: Ints
    """One-ring vertices, row by row."""
    neighbor_edge: Ints
    """The edge to each of them."""
    edge_faces: Ints
    """(e, 2) faces at each edge, -1 where there is none."""
    radius: Floats
    """(v,) distance kept between layers at each vertex, cm (see `layer_distance`)."""
    spacing: float
    """Typical distance between vertices, cm: what reaches and margins of self-collision go by."""


@dataclass(frozen=True, eq=False)
class ClothModel:
    """A garment ready to be simulated."""

    arrays: ClothArrays
    gathered: NDArray[np.bool_]
    """(e,) edges on seams whose two sides differ in length, where strain means nothing."""
    mass: Floats
    """(v,) kg"""

    def strain(self, positions: Floats) -> Floats:
        """Length over rest length, less 1, of the edges that are not gathered; a single 0 without any."""
        a, b = self.arrays.edges.T
        lengths = np.linalg.norm(positions[a] - positions[b], axis=1)
        strain = (lengths / self.arrays.rest - 1)[~self.gathered]
        return strain if len(strain) else np.zeros(1)


def build_cloth(mesh: PatternMesh, fabric: Fabric, *, press: bool = True) -> ClothModel:
    """Takes rest lengths, masses and bending weights from the flat panels.

    With `press`, folds along ``right_wrong`` seams, as collars have them, do not spring up.

    On a seam the two panels may disagree about an edge's length (a gather); the shorter one holds, as in
    GarmentCode. Bending is isometric and quadratic: Bergou et al., "A quadratic bending model for
    inextensible surfaces", 2006.
    """
    faces = mesh.faces
    corners = mesh.flat_vertices[mesh.flat_faces]  # (f, 3, 2)
    sides = np.roll(corners, -1, axis=1) - corners
    lengths = np.linalg.norm(sides, axis=2)  # (f, 3), side k joins corner k to k + 1
    area = np.abs(sides[:, 0, 0] * sides[:, 2, 1] - sides[:, 0, 1] * sides[:, 2, 0]) / 2

    mass = np.zeros(mesh.vertex_count)
    for k in range(3):
        np.add.at(mass, faces[:, k], fabric.density * 1e-4 * area / 3)
    # Slivers would have next to no mass, which makes the solver stiff there and helps nobody.
    mass = np.maximum(mass, _MIN_MASS_SHARE * np.median(mass))

    halves = np.concatenate([faces[:, [k, (k + 1) % 3]] for k in range(3)])
    half_face = np.tile(np.arange(len(faces)), 3)
    half_side = np.repeat(np.arange(3), len(faces))
    keys, edge_of = np.unique(edge_keys(halves), return_inverse=True)
    edges = edges_of_keys(keys)
    # Swept in the order of the mesh, the solver pumps energy along it and long skirts never rest.
    shuffled = np.random.default_rng(0).permutation(len(edges))
    edges = edges[shuffled]
    edge_of = np.argsort(shuffled)[edge_of.ravel()]
    half_length = lengths[half_face, half_side]
    shortest = np.full(len(edges), np.inf)
    longest = np.zeros(len(edges))
    np.minimum.at(shortest, edge_of, half_length)
    np.maximum.at(longest, edge_of, half_length)
    shortest = np.maximum(shortest, 1e-4)
    share = np.zeros(len(edges))
    np.add.at(share, edge_of, area[half_face] / 3)
    membrane = fabric.membrane(mesh.pattern.cloth_stretch)
    stiffness = membrane * _SPRING_FACTOR * np.maximum(share, 1e-6) / np.maximum(shortest, 0.01) ** 2

    order = np.argsort(edge_of, kind="stable")
    count = np.bincount(edge_of, minlength=len(edges))
    first = np.concatenate([[0], np.cumsum(count)])[:-1]
    edge_faces = np.full((len(edges), 2), -1, dtype=np.int32)
    edge_faces[:, 0] = half_face[order[first]]
    two = count == 2
    edge_faces[two, 1] = half_face[order[first[two] + 1]]
    bent = two & ~_pressed(mesh, edges) if press else two
    hinges, weights = _hinges(
        faces, corners, area, edges[bent], order[first[bent]], order[first[bent] + 1], half_face, half_side
    )

    start, neighbors, neighbor_edge = _neighbors(edges, mesh.vertex_count)
    mean_length = np.zeros(mesh.vertex_count)
    degree = np.bincount(edges.ravel(), minlength=mesh.vertex_count)
    np.add.at(mean_length, edges.ravel(), np.repeat(shortest, 2))
    radius = layer_distance(mean_length / np.maximum(degree, 1), fabric.thickness)
    arrays = ClothArrays(
        faces=np.ascontiguousarray(faces, dtype=np.int32),
        edges=np.ascontiguousarray(edges, dtype=np.int32),
        rest=shortest,
        compliance=1.0 / stiffness,
        hinges=hinges,
        hinge_weights=weights,
        hinge_compliance=np.full(len(hinges), 1.0 / max(fabric.bending * 1e4, 1e-12)),
        inverse_mass=1.0 / mass,
        neighbor_start=start,
        neighbors=neighbors,
        neighbor_edge=neighbor_edge,
        edge_faces=edge_faces,
        radius=radius,
        spacing=max(float(np.median(shortest)), _MIN_SPACING_CM),
    )
    return ClothModel(arrays, longest / shortest > 1.05, mass)


def _pressed(mesh: PatternMesh, edges: Ints) -> NDArray[np.bool_]:
    """(e,) edges on seams along which cloth lies folded."""
    found = np.zeros(len(edges), dtype=bool)
    for seam in mesh.seams:
        if mesh.pattern.stitches[seam.stitch].right_wrong:
            found |= np.isin(edges, seam.vertices).all(axis=1)
    return found


def layer_distance(edge_length: Floats, thickness: float) -> Floats:
    """Distance that self-collision keeps between layers, cm.

    Only vertices are held off faces, so that edges of thin folds can slip past each other: layers nearer
    than about a third of the mesh's edges tangle. Never more than half an edge, where vertices are closer.

    Args:
        edge_length: (v,) mean length of the edges around each vertex, cm.
        thickness: The fabric's, cm.
    """
    return np.minimum(np.maximum(thickness, 0.3 * edge_length), 0.5 * edge_length)


def _hinges(
    faces: Ints,
    corners: Floats,
    area: Floats,
    edges: Ints,
    first: NDArray[np.int64],
    second: NDArray[np.int64],
    half_face: NDArray[np.int64],
    half_side: NDArray[np.int64],
) -> tuple[Ints, Floats]:
    """Hinge vertices (h, 4) and weights (h, 4) of the inner edges, from the flat triangles' cotangents."""

    def side(half: NDArray[np.int64]) -> tuple[Ints, Floats, Floats]:
        face, k = half_face[half], half_side[half]
        p, q, r = (corners[face, (k + s) % 3] for s in range(3))
        at_p, at_q = _cotangent(q - p, r - p), _cotangent(p - q, r - q)
        forward = faces[face, k] == edges[:, 0]
        return (
            faces[face, (k + 2) % 3],
            np.where(forward, at_p, at_q),
            np.where(forward, at_q, at_p),
        )

    opposite_1, a_1, b_1 = side(first)
    opposite_2, a_2, b_2 = side(second)
    total = area[half_face[first]] + area[half_face[second]]
    scale = np.sqrt(3.0 / np.maximum(total, 1e-6))
    # a_*: cotangent at the edge's first vertex in each triangle, b_*: at its second.
    weights = np.stack([b_1 + b_2, a_1 + a_2, -(a_1 + b_1), -(a_2 + b_2)], axis=1) * scale[:, None]
    hinges = np.stack([edges[:, 0], edges[:, 1], opposite_1, opposite_2], axis=1)
    sound = opposite_1 != opposite_2
    hinges, weights = hinges[sound], weights[sound]
    largest = np.abs(weights).max(axis=1, initial=0.0)
    if len(largest):  # slivers have huge cotangents, which would make them rigid
        cap = 2 * np.percentile(largest, 99)
        weights = weights * np.minimum(1.0, cap / np.maximum(largest, 1e-12))[:, None]
    return np.ascontiguousarray(hinges, dtype=np.int32), np.ascontiguousarray(weights)


def _cotangent(u: Floats, w: Floats) -> Floats:
    cross = np.abs(u[:, 0] * w[:, 1] - u[:, 1] * w[:, 0])
    return (u * w).sum(axis=1) / np.maximum(cross, 1e-8)


def _neighbors(edges: Ints, count: int) -> tuple[Ints, Ints, Ints]:
    """One-ring of every vertex as rows: row starts, neighbours, and the edges to them."""
    both = np.concatenate([edges, edges[:, ::-1]])
    order = np.argsort(both[:, 0], kind="stable")
    start = np.concatenate([[0], np.cumsum(np.bincount(both[:, 0], minlength=count))])
    return (
        start.astype(np.int32),
        np.ascontiguousarray(both[order, 1], dtype=np.int32),
        (order % len(edges)).astype(np.int32),
    )
