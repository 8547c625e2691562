"""Draws docs/images/ggi-decodes.png: a drape, both decodes of its images, whole and close up.

.venv/bin/python scripts/make_ggi_decode_pictures.py [FOLDER OUT.png]

Without arguments the shirt-dress is draped for it; FOLDER is any garment that ``swifttailor drape`` has left.
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
from PIL import Image, ImageDraw, ImageFont

import swifttailor
from swifttailor.garment.garment import Garment
from swifttailor.ggi import encode
from swifttailor.ggi.decode import decode
from swifttailor.panel_mesh.topology import edge_faces
from swifttailor.render import Camera, LineSet, Surface, render_view, to_linear

RESOLUTION = 256
CLOTH, PAPER, INK = "#7d9fb5", "#ffffff", "#222222"
WIDTH, HEIGHT, GAP, HEAD = 440, 330, 10, 26


def main() -> None:
    if len(sys.argv) == 3:
        garment, out = Garment.load(sys.argv[1]), Path(sys.argv[2])
    else:
        garment = swifttailor.drape(swifttailor.draft("shirt-dress"))
        out = Path("docs/images/ggi-decodes.png")
    images = encode(garment, RESOLUTION)
    columns = {
        "the drape": garment,
        f"outline decode, {RESOLUTION} pixels": decode(images, "outline"),
        f"grid decode, {RESOLUTION} pixels": decode(images, "grid"),
    }
    views = cameras(garment)
    sheet = Image.new("RGB", (3 * WIDTH + 2 * GAP, HEAD + len(views) * (HEIGHT + GAP) - GAP), PAPER)
    pen, font = ImageDraw.Draw(sheet), ImageFont.load_default(size=16)
    for column, (title, mesh) in enumerate(columns.items()):
        x = column * (WIDTH + GAP)
        pen.text((x + 2, 3), title, fill=INK, font=font)
        for row, camera in enumerate(views):
            picture = render_view([surface(mesh, wires=row > 0)], camera, (WIDTH, HEIGHT), floor=False)
            sheet.paste(Image.fromarray(picture), (x, HEAD + row * (HEIGHT + GAP)))
    sheet.quantize(200, dither=0).save(out, optimize=True)


def cameras(garment: Garment) -> list[Camera]:
    """The whole garment from the front, its lowest end of a seam at a hem, and its most gathered seam."""
    low, high = garment.vertices.min(axis=0), garment.vertices.max(axis=0)
    views = [Camera(target=tuple((low + high) / 2), height=float(high[1] - low[1]) * 1.08)]
    hem = border(garment)
    ends = [int(v) for s in garment.seams for v in (s.vertices[0], s.vertices[-1]) if int(v) in hem]
    lowest = min(ends, key=lambda v: garment.vertices[v, 1])

    def gather(stitch) -> float:
        one, other = (garment.pattern.edge_length(ref) for ref in stitch.sides)
        return max(one, other) / min(one, other)

    gathered = max(garment.seams, key=lambda s: gather(garment.pattern.stitches[s.stitch])).vertices
    for vertex in (lowest, int(gathered[len(gathered) // 3])):
        point, normal = garment.vertices[vertex], garment.vertex_normals[vertex]
        azimuth = float(np.degrees(np.arctan2(normal[0], normal[2])))
        views.append(Camera(target=tuple(point), height=12.0, azimuth=azimuth))
    return views


def border(mesh) -> set[int]:
    edges, count = edge_faces(mesh.faces.astype(np.int32))
    return set(edges[count == 1].ravel().tolist())


def surface(mesh, *, wires: bool) -> Surface:
    """A mesh with its seams, and its edges where they can be told apart."""
    color = to_linear(CLOTH)
    seams = [np.stack([v[:-1], v[1:]], axis=1) for v in seam_lines(mesh)]
    edges, count = edge_faces(mesh.faces.astype(np.int32))
    lines = [LineSet(np.concatenate(seams), strength=0.75 if wires else 0.4, width=2.0 if wires else 1.0)]
    lines.append(LineSet(edges[count == 1], strength=0.5, width=1.5))
    if wires:
        lines.append(LineSet(edges, strength=0.45, width=0.8))
    return Surface(mesh.vertices, mesh.faces, color, 0.6 * color + 0.03, lines=tuple(lines), sheen=0.1)


def seam_lines(mesh) -> list[np.ndarray]:
    return [s.vertices for s in mesh.seams] if isinstance(mesh, Garment) else list(mesh.seams)


if __name__ == "__main__":
    main()
