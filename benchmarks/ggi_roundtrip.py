"""What is lost when a drape becomes images and a mesh again, by both decodes, and what it costs.

``python benchmarks/ggi_roundtrip.py FOLDER [--limit N] [--resolutions 128 256 512 1024] [--plot FILE.svg]
[--turned]``

FOLDER holds garments that `swifttailor drape --batch` has left. Each is drawn as images, stored in 16 bits as
in ggi.npz, and decoded to the outlines (at the drape's edge length) and by the grid. Measured are:

* distance: of 10,000 points, evenly over the decoded surface, to the drape, and of as many on the drape to
  the decoded surface; the mean of both;
* topology: whether pieces, boundary loops and Euler characteristic are those of the drape; non-manifold
  edges;
* seams: the largest distance between two stitched points, and for the grid the mesh edges along seams that
  stayed open;
* outward: the share of faces whose normal points to the same side as the drape's there, also without the
  garments whose pixels are coarser than the mesh: folds smaller than a pixel are not in the image; with
  ``--turned``, which garments hold the other faces, and on which panels;
* time: processor seconds of one core, the least of three runs, everything included but reading the file.
"""

from __future__ import annotations

import argparse
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from ggi_error_plot import plot_errors
from machine import describe
from swifttailor.body.surface_distance import SurfaceTree
from swifttailor.garment.garment import Garment
from swifttailor.ggi import encode
from swifttailor.ggi.decode import decode
from swifttailor.ggi.file import dequantize, quantize
from swifttailor.ggi.geometry import geometry_raster
from swifttailor.ggi.images import GarmentGeometryImage
from swifttailor.ggi.remesh import PixelGrid
from swifttailor.ggi.slits import seam_sides
from swifttailor.ggi.stitch import SewnGrid
from swifttailor.panel_mesh.topology import edge_faces, topology
from timing import least

POINTS = 10_000
METHODS = ("outline", "grid")


@dataclass(frozen=True)
class Measured:
    """One garment, resolution and method."""

    name: str
    resolution: int
    method: str
    cm_per_pixel: float
    distance: float
    farthest: float
    same_topology: bool
    counts: tuple[int, int, int]
    wanted: tuple[int, int, int]
    nonmanifold: int
    seam_gap: float
    open_seam_edges: int
    faces: int
    turned: dict[str, int]
    """Faces whose normals point the other way than the drape's, by panel."""
    edge_length: float
    seconds: float

    @property
    def outward(self) -> float:
        """Share of the faces that point to the same side as the drape there."""
        return 1.0 - sum(self.turned.values()) / self.faces


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("folder", type=Path)
    parser.add_argument("--limit", type=int, default=100)
    parser.add_argument("--resolutions", type=int, nargs="+", default=[128, 256, 512, 1024])
    parser.add_argument("--plot", type=Path)
    parser.add_argument("--turned", action="store_true")
    options = parser.parse_args()
    folders = sorted(p.parent for p in options.folder.glob("*/garment.obj"))[: options.limit]
    print(describe())
    print(f"{len(folders)} garments of {options.folder}")
    rows = [m for folder in folders for m in measure_garment(folder, options.resolutions)]
    for resolution in options.resolutions:
        for method in METHODS:
            chosen = [m for m in rows if (m.resolution, m.method) == (resolution, method)]
            report(chosen)
            if options.turned:
                list_turned(chosen)
    if options.plot:
        plot_errors(
            {
                method: {
                    r: [m.distance for m in rows if (m.resolution, m.method) == (r, method)]
                    for r in options.resolutions
                }
                for method in METHODS
            },
            options.plot,
        )


def measure_garment(folder: Path, resolutions: list[int]) -> list[Measured]:
    garment = Garment.load(folder)
    wanted = counts(garment)
    tree = SurfaceTree.build(garment.vertices, garment.faces)
    edge_length = float(garment.report["edge_length_cm"])
    found = []
    for resolution in resolutions:
        images = stored(encode(garment, resolution))
        for method in METHODS:
            seconds, decoded = least(lambda i=images, m=method: decode(i, m, edge_length))
            there, back = distances(decoded, garment, tree)
            reached = counts(decoded)
            gap, left_open = seams(decoded, images)
            found.append(
                Measured(
                    folder.name,
                    resolution,
                    method,
                    images.layout.cm_per_pixel,
                    (there.mean() + back.mean()) / 2,
                    max(there.max(), back.max()),
                    reached[:3] == wanted[:3],
                    reached[:3],
                    wanted[:3],
                    reached[3],
                    gap,
                    left_open,
                    len(decoded.faces),
                    turned(decoded, garment, images),
                    edge_length,
                    seconds,
                )
            )
    return found


def stored(images: GarmentGeometryImage) -> GarmentGeometryImage:
    """The images as a file would give them back."""
    geometry = dequantize(*quantize(images.geometry, images.occupancy), images.occupancy)
    return GarmentGeometryImage(
        images.layout, images.occupancy, images.panel, images.semantic, images.stitching, geometry
    )


def counts(mesh: Garment | SewnGrid) -> tuple[int, int, int, int]:
    found = topology(mesh.faces.astype(np.int32), len(mesh.vertices))
    return found.components, found.boundary_loops, found.euler_characteristic, found.nonmanifold_edges


def distances(decoded: Garment | SewnGrid, garment: Garment, tree: SurfaceTree):
    """Distances (n,) in cm of points on the decoded surface to the drape, and the other way round."""
    there = tree.signed_distance(on_surface(decoded.vertices, decoded.faces))[0]
    other = SurfaceTree.build(decoded.vertices, decoded.faces)
    back = other.signed_distance(on_surface(garment.vertices, garment.faces))[0]
    return np.abs(there), np.abs(back)


def on_surface(vertices: np.ndarray, faces: np.ndarray) -> np.ndarray:
    """`POINTS` points (n, 3), evenly over the area."""
    rng = np.random.default_rng(0)
    corners = vertices[faces]
    area = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
    face = rng.choice(len(faces), POINTS, p=area / area.sum())
    s, t = np.sqrt(rng.random(POINTS)), rng.random(POINTS)
    share = np.stack([1 - s, s * (1 - t), s * t], axis=1)
    return np.einsum("nk,nkd->nd", share, corners[face])


def seams(decoded: Garment | SewnGrid, images: GarmentGeometryImage) -> tuple[float, int]:
    """Largest distance in cm between two stitched points, and the number of seam edges that stayed open."""
    edges, faces_at = edge_faces(decoded.faces.astype(np.int32))
    size = len(decoded.vertices)
    border = np.sort(edges[faces_at == 1].astype(np.int64) @ [size, 1])
    if isinstance(decoded, SewnGrid):
        # Stitched pixels that are in the mesh are one vertex; what is left to ask is whether all are.
        grid = PixelGrid.of(images.panel)
        square = images.resolution**2
        links = np.unique(grid.pixels[seam_sides(grid, images.stitching).links] @ [square, 1])
        start, end = decoded.flat_faces.ravel(), decoded.flat_faces[:, [1, 2, 0]].ravel()
        on_seam = np.isin(
            decoded.flat_pixels[start].astype(np.int64) * square + decoded.flat_pixels[end], links
        )
        welded = np.sort(decoded.weld[np.stack([start, end], axis=1)[on_seam]], axis=1)
        return 0.0, int(np.isin(welded @ [size, 1], border).sum())
    gap, left_open = 0.0, 0
    for stitch in decoded.pattern.stitches:
        one, other = (
            decoded.mesh.edge_vertices[decoded.pattern.panel_index(r.panel)][r.edge] for r in stitch.sides
        )
        other = other if stitch.right_wrong else other[::-1]
        away = decoded.flat_positions[one] - decoded.flat_positions[other]
        gap = max(gap, float(np.linalg.norm(away, axis=1).max()))
        welded = np.sort(decoded.mesh.weld[np.stack([one[:-1], one[1:]], axis=1)].astype(np.int64), axis=1)
        left_open += int(np.isin(welded @ [size, 1], border).sum())
    return gap, left_open


def turned(decoded: Garment | SewnGrid, garment: Garment, images: GarmentGeometryImage) -> dict[str, int]:
    """Number of faces that point to the other side than the drape there, by panel."""
    there = face_normals(garment.vertices, garment.faces)
    if isinstance(decoded, SewnGrid):  # another mesh: what the drape's normals are at its pixels
        at_vertex = np.zeros_like(garment.flat_positions)
        for k in range(3):
            np.add.at(at_vertex, garment.mesh.flat_faces[:, k], there)
        raster = geometry_raster(images.layout, garment.mesh)
        image = np.zeros((images.resolution**2, 3))
        image[images.layout.raster.pixels] = np.einsum(
            "nk,nkd->nd", raster.weights, at_vertex[raster.vertices]
        )
        there = image[decoded.flat_pixels[decoded.flat_faces]].sum(axis=1)
    panel = decoded.face_panel if isinstance(decoded, SewnGrid) else decoded.mesh.face_panel
    away = (face_normals(decoded.vertices, decoded.faces) * there).sum(axis=1) <= 0
    numbers, counts = np.unique(panel[away], return_counts=True)
    names = [p.name for p in images.layout.pattern.panels]
    return {names[k]: int(count) for k, count in zip(numbers, counts, strict=True)}


def face_normals(vertices: np.ndarray, faces: np.ndarray) -> np.ndarray:
    """(f, 3) as long as twice the faces are large."""
    a, b, c = (vertices[faces[:, k]] for k in range(3))
    return np.cross(b - a, c - a)


def report(rows: list[Measured]) -> None:
    first = rows[0]
    distance = np.array([m.distance for m in rows])
    seconds = np.array([m.seconds for m in rows]) * 1e3
    share = np.array([m.outward for m in rows])
    fine = np.array([m.cm_per_pixel <= m.edge_length for m in rows])
    print(
        f"\n{first.resolution} px, {first.method} "
        f"(median {np.median([m.cm_per_pixel for m in rows]):.3f} cm per pixel)\n"
        f"  distance: mean {distance.mean():.4f} cm, worst garment {distance.max():.4f}, "
        f"farthest point {max(m.farthest for m in rows):.2f}\n"
        f"  topology equal: {sum(m.same_topology for m in rows)} of {len(rows)}; "
        f"non-manifold edges {sum(m.nonmanifold for m in rows)}\n"
        f"  seams: gap {max(m.seam_gap for m in rows):g} cm, "
        f"{sum(m.open_seam_edges for m in rows)} seam edges open in "
        f"{sum(m.open_seam_edges > 0 for m in rows)} garments\n"
        f"  outward: mean {share.mean():.4%}, worst garment {share.min():.3%}; "
        f"of the {fine.sum()} with pixels no coarser than the mesh {share[fine].mean():.4%}, "
        f"{share[fine].min():.3%}\n"
        f"  time: median {np.median(seconds):.1f} ms, 95 % {np.percentile(seconds, 95):.1f}, "
        f"max {seconds.max():.1f}"
    )
    for m in rows:
        if not m.same_topology:
            print(f"    {m.name} at {m.cm_per_pixel:.2f} cm per pixel: {m.counts} instead of {m.wanted}")


def list_turned(rows: list[Measured]) -> None:
    """Prints the garments with turned faces, most of them first."""
    found = sorted((m for m in rows if m.turned), key=lambda m: -sum(m.turned.values()))
    every = sum(sum(m.turned.values()) for m in found)
    print(f"  turned: {every} faces in {len(found)} garments")
    for m in found:
        panels = ", ".join(f"{name} {n}" for name, n in sorted(m.turned.items(), key=lambda p: -p[1]))
        many = sum(m.turned.values())
        print(f"    {m.name}: {many} of {m.faces}, {m.cm_per_pixel:.2f} cm per pixel: {panels}")


if __name__ == "__main__":
    main()
