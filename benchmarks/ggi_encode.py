"""What it costs to draw patterns and drapes as images, and how much of the images is cloth.

``python benchmarks/ggi_encode.py [PATTERNS.jsonl.gz] [--limit N] [--resolutions 128 256 512 1024]``

Per pattern: its semantic and stitching image; the further channels that a network is conditioned on (placed
and panel-local position, normal, partner pixel); the weights of the geometry image; a drape drawn with them.
Processor time of one core, the least of three runs each; median over the patterns, and the slowest.
"""

from __future__ import annotations

import argparse
import gzip
import json
from pathlib import Path

import numpy as np

from machine import describe
from swifttailor.ggi import GarmentGeometryImage, encode, lay_out
from swifttailor.ggi.geometry import geometry_raster
from swifttailor.panel_mesh import mesh_pattern
from swifttailor.pattern import read_specification
from timing import least

PATTERNS = Path("../shared/garmentcode/validation.jsonl.gz")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("patterns", nargs="?", type=Path, default=PATTERNS)
    parser.add_argument("--limit", type=int, default=60)
    parser.add_argument("--resolutions", type=int, nargs="+", default=[128, 256, 512, 1024])
    options = parser.parse_args()
    with gzip.open(options.patterns, "rt") as lines:
        records = [json.loads(line)["pattern"] for _, line in zip(range(options.limit), lines, strict=False)]
    patterns = [read_specification(r).pattern.canonical() for r in records]
    meshes = [mesh_pattern(p, 2.0) for p in patterns]
    print(describe())
    vertices = np.median([m.vertex_count for m in meshes])
    print(f"{len(patterns)} patterns, meshes of 2 cm edges, {vertices:.0f} vertices in the median")
    heads = ("pattern images", "conditioning", "geometry weights", "one drape")
    print("pixels  " + "  ".join(f"{head + ', ms':>22}" for head in heads))
    for resolution in options.resolutions:
        seconds = np.array([measure(p, m, resolution) for p, m in zip(patterns, meshes, strict=True)]) * 1e3
        cells = [f"{np.median(s):.1f} (max {s.max():.1f})" for s in seconds.T]
        print(f"{resolution:>6}  " + "  ".join(f"{cell:>22}" for cell in cells))
    for packing in ("rows", "skyline"):
        layouts = [lay_out(p, 256, packing=packing) for p in patterns]
        cloth = [np.abs(la.outlines.signed_area).sum() / (256 * la.cm_per_pixel) ** 2 for la in layouts]
        print(
            f"packing {packing}: cloth {np.mean(cloth):.3f} of the square, "
            f"{np.median([la.cm_per_pixel for la in layouts]):.3f} cm per pixel in the median"
        )


def measure(pattern, mesh, resolution: int) -> tuple[float, ...]:
    """Seconds for the pattern's images, the conditioning beside them, the weights, and one drape."""
    vertices = np.random.default_rng(0).normal(size=(mesh.vertex_count, 3))
    images = encode(pattern, resolution)
    weights = geometry_raster(images.layout, mesh)
    return (
        least(lambda: encode(pattern, resolution))[0],
        least(lambda: conditioning(images))[0],
        least(lambda: geometry_raster(images.layout, mesh))[0],
        least(lambda: weights.image(vertices))[0],
    )


def conditioning(images: GarmentGeometryImage) -> np.ndarray:
    """(N, N, 12): placed position, panel-local position, normal, sewn or not, steps to the partner pixel."""
    layout = images.layout
    raster, size = layout.raster, layout.resolution
    placements = [p.placement for p in layout.pattern.panels]
    turn = np.array([p.matrix() for p in placements])
    shift = np.array([p.translation for p in placements])
    side = np.where(layout.mirrored, -1.0, 1.0)
    panel = raster.pixel_panel
    local = layout.local_points()
    placed = np.einsum("nij,nj->ni", turn[panel][:, :, :2], local) + shift[panel]
    normal = (turn[:, :, 2] * side[:, None])[panel]
    channels = raster.spread(np.concatenate([placed, local, normal], axis=1).astype(np.float32), 0.0)
    sewn = np.zeros((size * size, 3), np.float32)
    pixels, partner = images.stitching.pixels, images.stitching.partners()
    sewn[pixels, 0] = 1.0
    sewn[pixels, 1] = partner % size - pixels % size
    sewn[pixels, 2] = partner // size - pixels // size
    return np.concatenate([channels, sewn.reshape(size, size, 3)], axis=2)


if __name__ == "__main__":
    main()
