"""Garments of prompts in people's own words, drawn by lot and put on sheets, to be judged by eye.

python benchmarks/people_sheet.py building|final --out DIR [--count 60] [--seed 1]

Whoever looks at the sheets of the final half has read these prompts: nothing is tuned to them afterwards.
"""

from __future__ import annotations

import argparse
import random
import textwrap
from pathlib import Path

from PIL import Image, ImageDraw

import swifttailor
from answer_doubts import doubts, left_out
from people_prompts import WORDS, read_people_prompts
from swifttailor.errors import SwiftTailorError
from swifttailor.garment.preview import draw_preview

_SIZE, _TEXT, _COLUMNS, _ROWS = (460, 250), 62, 3, 5


def main() -> None:
    """Draws, makes and arranges."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("half", choices=("building", "final"))
    parser.add_argument("--out", type=Path, required=True)
    parser.add_argument("--count", type=int, default=60)
    parser.add_argument("--seed", type=int, default=1)
    args = parser.parse_args()
    args.out.mkdir(parents=True, exist_ok=True)
    prompts = [p for p in read_people_prompts(WORDS / args.half / "prompts.jsonl") if p.garment]
    drawn = random.Random(args.seed).sample(prompts, min(args.count, len(prompts)))
    tailor = swifttailor.Tailor.load()
    each = _COLUMNS * _ROWS
    for first in range(0, len(drawn), each):
        sheet = Image.new("RGB", (_COLUMNS * _SIZE[0], _ROWS * (_SIZE[1] + _TEXT)), "white")
        pen = ImageDraw.Draw(sheet)
        for k, prompt in enumerate(drawn[first : first + each]):
            x, y = (k % _COLUMNS) * _SIZE[0], (k // _COLUMNS) * (_SIZE[1] + _TEXT)
            try:
                made = tailor.generate_all(prompt.text)
                size = _SIZE[0] // len(made), _SIZE[1]
                for n, one in enumerate(made.values()):  # two garments stand side by side
                    shown = draw_preview(one.garment, one.body or swifttailor.Body.default(), size=size)
                    sheet.paste(Image.fromarray(shown), (x + n * size[0], y + _TEXT))
                said = "; ".join(
                    line for one in made.values() for line in (*doubts(one.answer), *left_out(one.answer))
                )
            except SwiftTailorError as error:
                said = str(error)
            lines = (
                textwrap.wrap(f"{first + k + 1} {prompt.text}", 78)[:3]
                + textwrap.wrap(f"! {said}" if said else "", 78)[:2]
            )
            pen.multiline_text((x + 4, y + 2), "\n".join(lines), fill="black", spacing=1)
        sheet.save(args.out / f"sheet-{first // each + 1}.png")
        print(args.out / f"sheet-{first // each + 1}.png", flush=True)


if __name__ == "__main__":
    main()
