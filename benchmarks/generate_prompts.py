"""Makes garments of prompts as people write them, and sheets to look through: does it understand?

``python benchmarks/generate_prompts.py --out DIR [--maker-weights FILE] [--sewer-weights FILE]``

Prompts come from benchmarks/prompts.txt unless others are given. A row of a sheet (prompts-01.png, ...) has
the prompt, the pattern and the garment. results.jsonl has a line for each prompt: style, prompt, whether and
why not it was made, panels, what a check finds, what was noted, seconds by stage. Printed: how many prompts
of each style gave a garment, and how many of these need a look. How well a garment fits its prompt is for
people to judge; ``swifttailor evaluate pattern-maker`` counts what can be counted.
"""

from __future__ import annotations

import argparse
import json
import statistics
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from PIL import Image, ImageDraw, ImageFont

import swifttailor
from machine import describe
from swifttailor.atomic_files import write_atomically, write_text
from swifttailor.body import Body
from swifttailor.data.stats.sheets import wrapped
from swifttailor.garment.preview import render_preview
from swifttailor.pattern_maker.temperatures import USUAL_TEMPERATURE
from swifttailor.render.pattern_picture import pattern_picture

PROMPTS = Path(__file__).with_name("prompts.txt")
ROWS, COLUMNS = 5, 2
TEXT_WIDTH, PATTERN, GARMENT = 260, (380, 300), (500, 300)
MARGIN = 10
INK, GREY, RED, PAPER = (40, 40, 40), (120, 118, 114), (176, 58, 46), (250, 249, 247)


@dataclass(frozen=True)
class Prompt:
    """One line of the file."""

    style: str
    text: str


@dataclass(frozen=True, eq=False)
class Made:
    """What came of a prompt."""

    prompt: Prompt
    tailored: Any
    """None where there is no garment."""
    error: str = ""

    def to_json(self) -> dict[str, Any]:
        """A line of results.jsonl."""
        about: dict[str, Any] = {"style": self.prompt.style, "prompt": self.prompt.text}
        if self.tailored is None:
            return about | {"error": self.error}
        report = self.tailored.report
        return about | {
            "panels": report["panels"],
            "needs_a_look": self.tailored.needs_a_look,
            "attempt": report["writing"]["attempt"],
            **{name: report[name] for name in ("findings", "notes", "warnings", "seconds")},
        }


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--out", type=Path, required=True)
    parser.add_argument("--maker-weights", type=Path)
    parser.add_argument("--sewer-weights", type=Path)
    parser.add_argument("--prompts", type=Path, default=PROMPTS)
    parser.add_argument("--limit", type=int, help="only so many, evenly from all styles")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--temperature", type=float, default=USUAL_TEMPERATURE)
    parser.add_argument("--save", action="store_true", help="also write a folder for each garment")
    options = parser.parse_args()
    prompts = read_prompts(options.prompts)
    if options.limit:
        prompts = prompts[:: -(-len(prompts) // options.limit)]
    tailor = swifttailor.Tailor(options.maker_weights, options.sewer_weights)
    made = []
    for number, prompt in enumerate(prompts, 1):
        made.append(make(tailor, prompt, options.seed, options.temperature))
        print(f"{number}/{len(prompts)} {made[-1].error or 'made'}: {prompt.text}", flush=True)
        if options.save and made[-1].tailored is not None:
            made[-1].tailored.save(options.out / f"{number:02d}")
    lines = [json.dumps(one.to_json(), ensure_ascii=False) for one in made]
    write_text(options.out / "results.jsonl", "".join(line + "\n" for line in lines), overwrite=True)
    for number, start in enumerate(range(0, len(made), ROWS * COLUMNS), 1):
        sheet = draw_sheet(made[start : start + ROWS * COLUMNS])
        write_atomically(
            options.out / f"prompts-{number:02d}.png",
            lambda path, sheet=sheet: sheet.save(path, "PNG"),
            overwrite=True,
        )
    print(describe())
    report(made)


def read_prompts(path: Path) -> list[Prompt]:
    """One a line; a comment just before prompts names their style."""
    found, style = [], ""
    for line in path.read_text(encoding="utf-8").splitlines():
        if line.startswith("#"):
            style = line.lstrip("# ").strip()
        elif line.strip():
            found.append(Prompt(style, line.strip()))
    return found


def make(tailor: Any, prompt: Prompt, seed: int, temperature: float) -> Made:
    try:
        return Made(prompt, tailor.generate(prompt.text, seed=seed, temperature=temperature))
    except swifttailor.SwiftTailorError as error:
        return Made(prompt, None, str(error))


def report(made: list[Made]) -> None:
    """Counts by style, and the seconds."""
    print(f"{'style':<48}{'prompts':>8}{'made':>6}{'to look at':>12}")
    for style in dict.fromkeys(one.prompt.style for one in made):
        of_style = [one for one in made if one.prompt.style == style]
        garments = [one.tailored for one in of_style if one.tailored is not None]
        look = sum(t.needs_a_look for t in garments)
        print(f"{style[:46]:<48}{len(of_style):>8}{len(garments):>6}{look:>12}")
    # What opens the networks is left out with the first.
    seconds = [sum(one.tailored.seconds.values()) for one in made[1:] if one.tailored is not None]
    if seconds:
        print(f"seconds a garment: median {statistics.median(seconds):.2f}, most {max(seconds):.2f}")


def draw_sheet(made: list[Made]) -> Image.Image:
    width = TEXT_WIDTH + PATTERN[0] + GARMENT[0] + 3 * MARGIN
    height = PATTERN[1] + MARGIN
    rows = -(-len(made) // COLUMNS)
    sheet = Image.new("RGB", (COLUMNS * width + MARGIN, rows * height + MARGIN), PAPER)
    draw = ImageDraw.Draw(sheet)
    for place, one in enumerate(made):
        left, top = MARGIN + place % COLUMNS * width, MARGIN + place // COLUMNS * height
        write_lines(draw, left, top, texts_of(one))
        if one.tailored is not None:
            x = left + TEXT_WIDTH + MARGIN
            sheet.paste(pattern_picture(one.tailored.pattern, PATTERN), (x, top))
            picture = render_preview(one.tailored.garment, Body.default(), size=GARMENT)
            sheet.paste(picture, (x + PATTERN[0] + MARGIN, top))
    return sheet


def texts_of(one: Made) -> Iterator[tuple[str, int, tuple[int, int, int]]]:
    """Text, size and colour of what stands beside a garment."""
    yield one.prompt.style, 13, GREY
    yield one.prompt.text, 17, INK
    if one.tailored is None:
        yield one.error, 14, RED
        return
    findings = [f"{f['severity']}: {f['code']}" for f in one.tailored.report["findings"]]
    worth_saying = [f for f in dict.fromkeys(findings) if not f.startswith("info")]
    for text in (*one.tailored.warnings, *worth_saying):
        yield text, 13, RED


def write_lines(draw: ImageDraw.ImageDraw, left: int, top: int, texts: Iterator) -> None:
    for text, size, color in texts:
        font = ImageFont.load_default(size)
        for line in wrapped(text, TEXT_WIDTH, font.getlength)[:9]:
            draw.text((left, top), line, fill=color, font=font)
            top += size + 4
        top += 6


if __name__ == "__main__":
    main()
