"""Draws the pictures of the README and of docs/commands.md.

``words-to-garment.jpg``: what the three commands of the README make. Its input ``woman-with-dog.jpg`` is a
photograph (see THIRD_PARTY.md). ``shirt-dress.png``: a draft, draped. ``sewn-drafts.jpg``: nine drafts, sewn
by the network. Run from the repository root:

.venv/bin/python scripts/make_readme_pictures.py
"""

from __future__ import annotations

import textwrap
from pathlib import Path

from PIL import Image, ImageDraw, ImageFont

import swifttailor
from swifttailor.garment.cloth_surfaces import cloth_surface
from swifttailor.garment.preview import body_surface, render_preview
from swifttailor.pattern.svg import write_svg
from swifttailor.render import Camera, render_view
from swifttailor.render.color import BACKGROUND
from swifttailor.render.pattern_picture import pattern_picture

FOLDER = Path("docs/images")
WORDS = "a knee-length sleeveless dress with a V neck"
INSTRUCTION = "give it long sleeves and lengthen the dress by 20 cm"
PHOTOGRAPH = FOLDER / "woman-with-dog.jpg"
BESIDE_IT = "a hip-length jumper with a round neck, no hood"
SIZE = 1280, 768
SEWN = (
    ("shirt", "sweatshirt", "pleated-skirt"),
    ("hoodie", "dungarees", "shirt-dress"),
    ("cape", "fitted-dress", "trousers"),
)
TILE = 450, 270
ROW, GAP = 440, 24
LEFT, MIDDLE, VIEW = 380, 560, 330
INK, QUIET, PAPER = "#2b2b2b", "#8a8780", "#ffffff"


def draw_words_to_garment() -> None:
    tailor = swifttailor.Tailor.load()
    dress = tailor.generate(WORDS)
    rows = (
        (words(WORDS, "words"), dress),
        (words(INSTRUCTION, "and an instruction"), tailor.edit(dress.pattern, INSTRUCTION)),
        (photograph(PHOTOGRAPH, BESIDE_IT), tailor.generate(BESIDE_IT, image=PHOTOGRAPH, part="upper")),
    )
    width = LEFT + MIDDLE + 2 * VIEW + 4 * GAP
    sheet = Image.new("RGB", (width, len(rows) * (ROW + GAP) + GAP), PAPER)
    for k, (left, made) in enumerate(rows):
        x, y = GAP, GAP + k * (ROW + GAP)
        sheet.paste(left, (x, y))
        arrow(sheet, x + LEFT + GAP // 2, y + ROW // 2)
        x += LEFT + GAP
        sheet.paste(pattern_picture(made.pattern, (MIDDLE, ROW)), (x, y))
        arrow(sheet, x + MIDDLE + GAP // 2, y + ROW // 2)
        sheet.paste(views(made.garment), (x + MIDDLE + GAP, y))
    # More colours than a palette holds without bands.
    sheet.save(FOLDER / "words-to-garment.jpg", quality=88, optimize=True, subsampling=0)


def words(text: str, title: str) -> Image.Image:
    card = Image.new("RGB", (LEFT, ROW), PAPER)
    pen = ImageDraw.Draw(card)
    pen.rounded_rectangle((0, 60, LEFT - 16, ROW - 60), 18, fill=BACKGROUND)
    pen.text((28, 84), title, fill=QUIET, font=ImageFont.load_default(size=20))
    lines = "\n".join(textwrap.wrap(f"\u201c{text}\u201d", 19))
    middle = (28, (60 + ROW - 60) // 2 + 14)
    pen.multiline_text(middle, lines, fill=INK, font=ImageFont.load_default(size=32), anchor="lm", spacing=12)
    return card


def photograph(path: Path, text: str) -> Image.Image:
    card = Image.new("RGB", (LEFT, ROW), PAPER)
    pen = ImageDraw.Draw(card)
    pen.rounded_rectangle((0, 20, LEFT - 16, ROW - 20), 18, fill=BACKGROUND)
    pen.text((28, 38), "or words and a photograph", fill=QUIET, font=ImageFont.load_default(size=20))
    with Image.open(path) as shown:
        height = ROW - 40 - 52 - 24
        card.paste(shown.convert("RGB").resize((shown.width * height // shown.height, height)), (28, 80))
        beside = 28 + shown.width * height // shown.height + 20
    lines = "\n".join(textwrap.wrap(f"\u201c{text}\u201d", 13))
    font = ImageFont.load_default(size=22)
    pen.multiline_text((beside, 80 + height // 2), lines, fill=INK, font=font, anchor="lm", spacing=8)
    return card


def views(garment) -> Image.Image:
    body = swifttailor.Body.default()
    surfaces = [body_surface(body, cloth=garment.vertices), cloth_surface(garment)]
    shown = Image.new("RGB", (2 * VIEW, ROW))
    for k, azimuth in enumerate((-20.0, 160.0)):
        camera = Camera((0.0, 86.0, 0.0), 182.0, azimuth, 5.0, 14.0)
        drawn = render_view(surfaces, camera, (VIEW, ROW), samples=3)
        shown.paste(Image.fromarray(drawn), (k * VIEW, 0))
    return shown


def arrow(sheet: Image.Image, x: int, y: int) -> None:
    ImageDraw.Draw(sheet).polygon([(x - 7, y - 12), (x + 9, y), (x - 7, y + 12)], fill=QUIET)


def draw_sewn() -> None:
    body, tailor = swifttailor.Body.default(), swifttailor.Tailor.load()
    sheet = Image.new("RGB", (TILE[0] * len(SEWN[0]), TILE[1] * len(SEWN)))
    for row, names in enumerate(SEWN):
        for column, name in enumerate(names):
            garment = tailor.sew(swifttailor.draft(name)).garment
            picture = render_preview(garment, body, size=(2 * TILE[0], 2 * TILE[1])).resize(TILE)
            sheet.paste(picture, (column * TILE[0], row * TILE[1]))
    sheet.save(FOLDER / "sewn-drafts.jpg", quality=88, optimize=True, subsampling=0)


def main() -> None:
    draw_words_to_garment()
    draw_sewn()
    pattern = swifttailor.draft("shirt-dress")
    write_svg(pattern, FOLDER / "shirt-dress-pattern.svg", overwrite=True)
    garment = swifttailor.drape(pattern)
    picture = render_preview(garment, swifttailor.Body.default(), size=SIZE)
    # 256 colours without dithering: a third of the size, no visible loss on a plain backdrop.
    picture.quantize(256, dither=0).save(FOLDER / "shirt-dress.png", optimize=True)
    print(
        f"accepted: {garment.report['quality']['accepted']}; {sum(garment.report['seconds'].values()):.1f} s"
    )


if __name__ == "__main__":
    main()
