"""Draws docs/images/rooms.svg: the rooms of the package by floor, and the way of a text through them.

python scripts/draw_rooms.py
"""

from __future__ import annotations

import tomllib
from html import escape
from pathlib import Path
from typing import Any

DOCS = Path(__file__).parents[1] / "docs"
TABLE, PICTURE = DOCS / "rooms.toml", DOCS / "images" / "rooms.svg"
WIDTH, FLOOR, GAP, MARGIN = 860, 38, 8, 20
LEFT = 560
"""Width of the house; the walk stands to the right of it."""
WALL, INK, PALE, STEP = "#c9b79c", "#3a332b", "#f6f1e8", "#b4513a"


def draw(table: dict[str, Any]) -> str:
    """The picture as SVG text, the same every time."""
    floors, walk = table["floor"][::-1], table["walk"]
    height = 2 * MARGIN + len(floors) * (FLOOR + GAP)
    steps = {}
    for number, step in enumerate(walk, 1):
        steps.setdefault(step["room"], []).append(number)
    lines = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {height}" font-family="sans-serif">',
        f'<rect width="{WIDTH}" height="{height}" fill="white"/>',
    ]
    for k, floor in enumerate(floors):
        top = MARGIN + k * (FLOOR + GAP)
        shown = floor.get("names", floor["rooms"])
        width = (LEFT - GAP * (len(shown) - 1)) / len(shown)
        for place, room in enumerate(shown):
            left = MARGIN + place * (width + GAP)
            lines += _room(room, floor.get("about", {}).get(room, ""), left, top, width, steps.get(room, []))
    lines += _walk(walk, MARGIN + LEFT + 40, MARGIN + 20)
    return "\n".join([*lines, "</svg>", ""])


def _room(name: str, about: str, left: float, top: float, width: float, steps: list[int]) -> list[str]:
    middle = top + FLOOR / 2 + 5
    place = f'x="{left:g}" y="{top}" width="{width:g}" height="{FLOOR}" rx="4"'
    box = f'<rect {place} fill="{PALE}" stroke="{WALL}"/>'
    words = f'<tspan font-weight="bold">{escape(name)}</tspan>'
    if about:
        words += f'<tspan dx="8" font-size="11">{escape(about)}</tspan>'
    text = f'<text x="{left + 10:g}" y="{middle:g}" font-size="14" fill="{INK}">{words}</text>'
    marks = []
    for k, number in enumerate(steps):
        x = left + width - 16 - 24 * (len(steps) - 1 - k)
        marks.append(f'<circle cx="{x:g}" cy="{top + FLOOR / 2:g}" r="10" fill="{STEP}"/>')
        marks.append(
            f'<text x="{x:g}" y="{top + FLOOR / 2 + 4:g}" font-size="12" fill="white" text-anchor="middle">'
            f"{number}</text>"
        )
    return [box, text, *marks]


def _walk(walk: list[dict[str, str]], left: float, top: float) -> list[str]:
    title = "The way of a text"
    lines = [f'<text x="{left}" y="{top}" font-size="14" font-weight="bold" fill="{INK}">{title}</text>']
    for k, step in enumerate(walk):
        y = top + 34 + 30 * k
        lines.append(f'<circle cx="{left + 10}" cy="{y - 4}" r="10" fill="{STEP}"/>')
        lines.append(
            f'<text x="{left + 10}" y="{y}" font-size="12" fill="white" text-anchor="middle">{k + 1}</text>'
        )
        lines.append(
            f'<text x="{left + 28}" y="{y}" font-size="12" fill="{INK}">{escape(step["does"])}</text>'
        )
    lines.append(
        f'<text x="{left}" y="{top + 50 + 30 * len(walk)}" font-size="11" fill="{INK}">'
        "A room imports only from floors below.</text>"
    )
    return lines


def main() -> None:
    PICTURE.write_text(draw(tomllib.loads(TABLE.read_text())))
    print(f"Wrote {PICTURE}")


if __name__ == "__main__":
    main()
