"""Draws docs/images/landmarks.webp, where measures are taken, and sizes.webp, bodies of the charts.

``python scripts/draw_landmarks.py`` from the repository root; half a minute.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
from PIL import Image, ImageDraw, ImageFont

from swifttailor.body import Body, body_for
from swifttailor.body.landmarks import LEVELS, POINTS, RINGS, Landmarks, level_faces, ring_faces
from swifttailor.body.mannequin import mannequin
from swifttailor.body.measuring import slice_points
from swifttailor.pattern.drafts import draft
from swifttailor.refitting import refit
from swifttailor.refitting.first_body import sewn_on
from swifttailor.render.camera import Camera
from swifttailor.render.surface import Surface
from swifttailor.render.view import render_view

FOLDER = Path("docs/images")
SIZE = 640, 1100
PAPER, INK, RED, BLUE, GREEN = (250, 249, 247), (40, 40, 40), (176, 58, 46), (40, 90, 160), (30, 120, 70)
SHOWN = "women 36", "women 44", "women 52", "men 50", "men 58", "children 146", "children 116"
FONT = ImageFont.load_default(17)


def main() -> None:
    landmarks(FOLDER / "landmarks.webp")
    sizes(FOLDER / "sizes.webp")


def landmarks(path: Path) -> None:
    body = Body.default()
    marks = Landmarks(body.vertices)
    sheet = Image.new("RGB", (2 * SIZE[0] + 120, SIZE[1]), PAPER)
    for k, azimuth in enumerate((0.0, 90.0)):
        camera = Camera(target=(0.0, 88.0, 0.0), height=190.0, azimuth=azimuth)
        seen = render_view(
            [Surface(body.vertices, body.faces, np.array([0.62, 0.58, 0.54]))],
            camera,
            SIZE,
            background=PAPER_LIGHT,
        )
        picture = Image.fromarray(seen)
        pen = ImageDraw.Draw(picture)
        for name in LEVELS:
            level = marks.level(name)
            if name in level_faces():
                outline(
                    pen,
                    camera,
                    slice_points(body.vertices, level_faces()[name], np.array([0.0, 1.0, 0.0]), level),
                    RED,
                )
        for name in RINGS:
            center, axis = marks.ring(name)
            outline(
                pen,
                camera,
                slice_points(body.vertices, ring_faces()[name], axis, float(center @ axis)),
                GREEN,
            )
        for name in POINTS:
            for sign in (1, -1):
                x, y, _ = camera.project((marks.point(name) * [sign, 1, 1])[None], SIZE)[0]
                pen.ellipse([x - 5, y - 5, x + 5, y + 5], fill=BLUE)
        if k == 0:
            name_levels(pen, marks, camera)
        else:
            name_points(pen, marks, camera)
        sheet.paste(picture, (k * (SIZE[0] + 120), 0))
    sheet.save(path, quality=82, method=6)


PAPER_LIGHT = tuple(((np.array(PAPER) / 255) ** 2.2).tolist())


def outline(
    pen: ImageDraw.ImageDraw, camera: Camera, points: np.ndarray, color: tuple[int, int, int]
) -> None:
    """What the camera sees of a slice: its points, joined where they are next to each other."""
    if len(points) < 3:
        return
    middle = points.mean(axis=0)
    _, _, turned = np.linalg.svd(points - middle, full_matrices=False)
    flat = (points - middle) @ turned[:2].T
    ordered = points[np.argsort(np.arctan2(flat[:, 1], flat[:, 0]))]
    pixels = camera.project(np.concatenate([ordered, ordered[:1]]), SIZE)
    pen.line([tuple(p) for p in pixels[:, :2]], fill=color, width=3)


def name_levels(pen: ImageDraw.ImageDraw, marks: Landmarks, camera: Camera) -> None:
    for name in LEVELS:
        _, y, _ = camera.project(np.array([[0.0, marks.level(name), 0.0]]), SIZE)[0]
        shift = {"shoulder": 3, "thigh": 12, "crotch": -10, "neck": -4, "throat": -8}.get(name, 0)
        pen.text((8, y - 9 + shift), f"{name} {marks.level(name):.0f}", fill=RED, font=FONT)
    for name in RINGS:
        x, y, _ = camera.project(marks.ring(name)[0][None], SIZE)[0]
        pen.text((min(x + 22, SIZE[0] - 92), y - 24), name, fill=GREEN, font=FONT)


def name_points(pen: ImageDraw.ImageDraw, marks: Landmarks, camera: Camera) -> None:
    for name in POINTS:
        x, y, _ = camera.project(marks.point(name)[None], SIZE)[0]
        left = x < SIZE[0] / 2
        lower = {"waist side": 22, "hip side": 22}.get(name, 0)
        place = (x + 90, y - 10 + lower) if not left else (x - 200, y - 10 + lower)
        pen.line([(x, y), (place[0] + (-4 if not left else 105), y + lower)], fill=BLUE, width=1)
        pen.text(place, name, fill=BLUE, font=FONT)


def sizes(path: Path) -> None:
    """Bodies of the charts in one dress and trousers, each refitted to them."""
    sew = sewn_on(Body.default(), 2.0)
    wide, high = 250, 560
    sheet = Image.new("RGB", (wide * len(SHOWN), 2 * high), PAPER)
    for row, name in enumerate(("fitted-dress", "trousers")):
        first = sew(draft(name))
        for k, size in enumerate(SHOWN):
            body = body_for(size)
            pattern = refit(draft(name), body, sewn=first).pattern
            garment = sewn_on(body, 2.0)(pattern)
            vertices, faces = mannequin(body, garment.vertices)
            seen = render_view(
                [
                    Surface(vertices, faces, np.array([0.55, 0.52, 0.48])),
                    Surface(garment.vertices, garment.faces, np.array([0.05, 0.12, 0.3])),
                ],
                Camera(target=(0.0, 93.0, 0.0), height=210.0),
                (wide, high),
                background=PAPER_LIGHT,
            )
            picture = Image.fromarray(seen)
            ImageDraw.Draw(picture).text((8, 6), size, fill=INK, font=FONT)
            sheet.paste(picture, (k * wide, row * high))
    sheet.save(path, quality=82, method=6)


if __name__ == "__main__":
    main()
