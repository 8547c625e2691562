"""Draws how well a picture reader read validation pictures while it was trained.

``python scripts/draw_learning_curve.py RUN... --out curve.svg``

RUN are the folders of the stages of a training (`swifttailor train picture-reader`) in their order.
"""

from __future__ import annotations

import argparse
import json
from pathlib import Path

WIDTH, HEIGHT, LEFT, RIGHT, TOP, BOTTOM = 700, 400, 60, 150, 24, 50
COLORS = ("#3b6ea5", "#b4513a", "#4f8a52", "#8a6bb0", "#b58a2a", "#555555", "#008695")
SHOWN = {
    "plain, front": ("by_look", "plain front"),
    "people, front": ("by_look", "people front"),
    "held out, front": ("by_look", "held out front"),
    "hem of skirts": ("claims", "skirt_hem"),
    "sleeves": ("claims", "sleeves"),
    "necklines": ("claims", "neckline"),
    "waistbands": ("claims", "waistband"),
}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("runs", type=Path, nargs="+")
    parser.add_argument("--out", type=Path, required=True)
    options = parser.parse_args()
    hours, stages, values = curves(options.runs)
    options.out.write_text(drawing(hours, stages, values), encoding="utf-8")


def curves(runs: list[Path]) -> tuple[list[float], list[tuple[float, str]], dict[str, list[float]]]:
    """Core-hours of each validation, where each stage begins and what it is, and the shares by name."""
    begun, hours, stages = 0.0, [], []
    values: dict[str, list[float]] = {name: [] for name in SHOWN}
    for run in runs:
        card = json.loads((run / "card.json").read_text())
        cores = card["training"]["processes"] * card["training"]["threads"]
        name = f"{card['config']['network']['image_size']} pixels"
        if all(name != other for _, other in stages):
            stages.append((begun, name))
        last = 0.0
        for line in (run / "metrics.jsonl").read_text().splitlines():
            record = json.loads(line)
            last = record["seconds"] * cores / 3600
            if "validation" in record:
                hours.append(begun + last)
                for name, (group, key) in SHOWN.items():
                    values[name].append(record["validation"][group][key])
        begun += last
    return hours, stages, values


def drawing(hours: list[float], stages: list[tuple[float, str]], values: dict[str, list[float]]) -> str:
    """The picture as SVG text."""
    most = max(hours)
    low = min(min(v) for v in values.values()) // 0.1 * 0.1

    def at(hour: float, share: float) -> tuple[float, float]:
        x = LEFT + (WIDTH - LEFT - RIGHT) * hour / most
        return round(x, 1), round(HEIGHT - BOTTOM - (HEIGHT - TOP - BOTTOM) * (share - low) / (1 - low), 1)

    lines = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" font-family="sans-serif" '
        'font-size="12">',
        f'<rect width="{WIDTH}" height="{HEIGHT}" fill="#ffffff"/>',
    ]
    for k in range(round((1 - low) * 10) + 1):
        x, y = at(0, low + k / 10)
        lines.append(f'<line x1="{x}" x2="{WIDTH - RIGHT}" y1="{y}" y2="{y}" stroke="#dddddd"/>')
        lines.append(f'<text x="{x - 8}" y="{y + 4}" text-anchor="end">{100 * (low + k / 10):.0f} %</text>')
    for hour, name in stages:
        x, y = at(hour, 1)
        lines.append(f'<line x1="{x}" x2="{x}" y1="{y}" y2="{HEIGHT - BOTTOM}" stroke="#999999"/>')
        lines.append(f'<text x="{x + 4}" y="{y - 8}">{name}</text>')
    step = 1 if most > 2 else 0.25
    for k in range(int(most / step) + 1):
        x, _ = at(k * step, low)
        lines.append(f'<text x="{x}" y="{HEIGHT - BOTTOM + 18}" text-anchor="middle">{k * step:g}</text>')
    lines.append(
        f'<text x="{(LEFT + WIDTH - RIGHT) / 2}" y="{HEIGHT - 10}" text-anchor="middle">core-hours</text>'
    )
    ends = sorted((values[name][-1], name) for name in values)
    place = HEIGHT
    for share, name in ends:
        color = COLORS[list(values).index(name)]
        points = " ".join("{},{}".format(*at(h, v)) for h, v in zip(hours, values[name], strict=True))
        lines.append(f'<polyline points="{points}" fill="none" stroke="{color}" stroke-width="2"/>')
        place = min(at(most, share)[1], place - 15)
        lines.append(
            f'<text x="{WIDTH - RIGHT + 8}" y="{place + 4}" fill="{color}">{name} {share:.0%}</text>'
        )
    return "\n".join([*lines, "</svg>", ""])


if __name__ == "__main__":
    main()
