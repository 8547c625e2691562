"""Draws the pictures of docs/ggi.md and prints the errors named there.

``docs/images/ggi-images.png``: the three images of the shirt-dress. ``docs/images/ggi-boundaries.png``: the
paper's figure on jagged boundaries (App. B), a hem decoded by Alg. 5 from barycentric values alone and from
the hybrid ones. Run from the repository root:

.venv/bin/python scripts/make_ggi_pictures.py
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import shapely
from PIL import Image, ImageDraw, ImageFont
from scipy.spatial import KDTree

import swifttailor
from swifttailor.ggi import Layout, encode
from swifttailor.ggi.geometry import geometry_raster
from swifttailor.ggi.panel_colors import color_types
from swifttailor.ggi.pictures import geometry_picture, stitching_picture
from swifttailor.ggi.remesh import PixelGrid, remesh
from swifttailor.panel_mesh.topology import edge_faces

FOLDER = Path("docs/images")
RESOLUTION = 256
CLOTH, WIRE, PAPER, TRUE_HEM, INK = "#9db8c9", "#4d6d82", "#ffffff", "#d01c1c", "#222222"
OVERSAMPLING = 4


def main() -> None:
    garment = swifttailor.drape(swifttailor.draft("shirt-dress"))
    images = encode(garment, RESOLUTION)
    draw_images(images)
    layout = images.layout
    decoded = {
        "barycentric only": decode_panels(centres_only(layout), garment),
        "hybrid": decode_panels(layout, garment),
    }
    print(f"{RESOLUTION} pixels, {layout.cm_per_pixel:.3f} cm per pixel, {len(garment.seams)} seams")
    for name, mesh in decoded.items():
        print(f"{name}: {errors(mesh, garment)}; seams {seam_gap(mesh, garment):.3f} cm apart on average")
    draw_boundaries(decoded, garment, layout)


def draw_images(images) -> None:
    pictures = [
        color_types(images.semantic),
        stitching_picture(images.stitching, images.occupancy),
        geometry_picture(images.geometry, images.occupancy),
    ]
    size, gap = 2 * images.resolution, 16
    sheet = Image.new("RGB", (3 * size + 2 * gap, size), PAPER)
    for k, picture in enumerate(pictures):
        upright = Image.fromarray(np.ascontiguousarray(picture[::-1]))
        sheet.paste(upright.resize((size, size), Image.Resampling.NEAREST), (k * (size + gap), 0))
    sheet.save(FOLDER / "ggi-images.png", optimize=True)


def centres_only(layout: Layout) -> Layout:
    """The layout as barycentric interpolation alone sees it: pixels whose centre lies inside, no contours."""
    raster, outlines = layout.raster, layout.outlines
    centres = np.stack([raster.pixels % raster.resolution, raster.pixels // raster.resolution], axis=1) + 0.5
    inside = np.zeros(len(centres), bool)
    for k in range(len(layout.pattern.panels)):
        polygon = shapely.Polygon(layout.to_pixels(k, outlines.points[outlines.panel == k]))
        inside |= (raster.pixel_panel == k) & shapely.contains_xy(polygon, *centres.T)
    kept = replace(
        raster,
        pixels=raster.pixels[inside],
        pixel_panel=raster.pixel_panel[inside],
        points=centres[inside],
        edge=np.full(inside.sum(), -1, np.int32),
        fraction=np.zeros(inside.sum()),
    )
    changed = replace(layout)
    changed.__dict__["raster"] = kept
    return changed


def decode_panels(layout: Layout, garment) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Positions (n, 3), faces (f, 3) and panels (n,) by Alg. 5, before any stitching."""
    grid = PixelGrid.of(layout.raster.panel)
    positions = geometry_raster(layout, garment.mesh).values(garment.vertices)
    return positions, remesh(grid, positions), grid.panel


def panel_border(garment, panel: int, *, darts: bool) -> np.ndarray:
    """The drape's border of a panel, closely sampled (n, 3), with or without its darts."""
    name = garment.pattern.panels[panel].name
    own = (s for s in garment.pattern.stitches if s.first.panel == s.second.panel == name)
    sewn_to_itself = {ref.edge for stitch in own for ref in stitch.sides}
    runs = [
        garment.flat_positions[run]
        for k, run in enumerate(garment.mesh.edge_vertices[panel])
        if darts or k not in sewn_to_itself
    ]
    return np.concatenate([close_samples(run[:-1], run[1:]) for run in runs])


def close_samples(starts: np.ndarray, ends: np.ndarray, count: int = 40) -> np.ndarray:
    t = (np.arange(count) / count)[None, :, None]
    return (starts[:, None] * (1 - t) + ends[:, None] * t).reshape(-1, 3)


def decoded_border(mesh, panel: int) -> np.ndarray:
    positions, faces, panels = mesh
    edges, count = edge_faces(faces[panels[faces[:, 0]] == panel].astype(np.int32))
    edges = edges[count == 1]
    return close_samples(positions[edges[:, 0]], positions[edges[:, 1]])


def errors(mesh, garment) -> str:
    """How far the decoded border strays from the drape's, and the drape's from the decoded one.

    The latter leaves out darts: near the tip their sides are less than a pixel apart, and Alg. 5 alone joins
    them.
    """
    away, missed = [], []
    for panel in range(len(garment.pattern.panels)):
        found = decoded_border(mesh, panel)
        away.append(KDTree(panel_border(garment, panel, darts=True)).query(found)[0])
        missed.append(KDTree(found).query(panel_border(garment, panel, darts=False))[0])
    away, missed = np.concatenate(away), np.concatenate(missed)
    return (
        f"decoded border from the drape's: mean {away.mean():.3f} cm, max {away.max():.3f}; "
        f"the drape's from the decoded one: mean {missed.mean():.3f} cm, max {missed.max():.3f}"
    )


def seam_gap(mesh, garment) -> float:
    """Mean distance in cm of a decoded seam border from that of the panel it is sewn to."""
    found = [decoded_border(mesh, k) for k in range(len(garment.pattern.panels))]
    gaps = []
    for stitch in garment.pattern.stitches:
        first, second = (garment.pattern.panel_index(ref.panel) for ref in stitch.sides)
        if first == second:
            continue
        run = garment.mesh.edge_vertices[first][stitch.first.edge]
        seam = close_samples(garment.flat_positions[run[:-1]], garment.flat_positions[run[1:]], 10)
        one = found[first][KDTree(found[first]).query(seam)[1]]
        other = found[second][KDTree(found[second]).query(seam)[1]]
        gaps.append(np.linalg.norm(one - other, axis=1))
    return float(np.concatenate(gaps).mean())


def draw_boundaries(decoded, garment, layout: Layout) -> None:
    """The front skirt's hem where its side seam begins, from the front, both ways side by side."""
    panel = garment.pattern.panel_index("skirt_front")
    corners = garment.flat_positions[[run[0] for run in garment.mesh.edge_vertices[panel]]]
    corner = corners[np.argmin(corners[:, 1] - 0.3 * corners[:, 0])]
    low = corner[:2] - (14.6, 1.8)
    width, height, scale = 560, 400, 560 / 17.5 * OVERSAMPLING
    sheet = Image.new("RGB", (2 * width + 16, height + 30), PAPER)
    for k, (name, mesh) in enumerate(decoded.items()):
        picture = Image.new("RGB", (width * OVERSAMPLING, height * OVERSAMPLING), PAPER)
        draw = ImageDraw.Draw(picture)
        positions, faces, panels = mesh
        at = (positions[:, :2] - low) * scale
        at[:, 1] = height * OVERSAMPLING - at[:, 1]
        for face in faces[panels[faces[:, 0]] == panel]:
            draw.polygon([tuple(p) for p in at[face]], fill=CLOTH, outline=WIRE, width=OVERSAMPLING)
        for run in garment.mesh.edge_vertices[panel]:
            line = (garment.flat_positions[run][:, :2] - low) * scale
            line[:, 1] = height * OVERSAMPLING - line[:, 1]
            draw.line([tuple(p) for p in line], fill=TRUE_HEM, width=2 * OVERSAMPLING)
        sheet.paste(picture.resize((width, height), Image.Resampling.LANCZOS), (k * (width + 16), 30))
        label = f"{name} (red: the drape's border)"
        ImageDraw.Draw(sheet).text(
            (k * (width + 16) + 4, 6), label, fill=INK, font=ImageFont.load_default(size=16)
        )
    sheet.quantize(128, dither=0).save(FOLDER / "ggi-boundaries.png", optimize=True)


if __name__ == "__main__":
    main()
