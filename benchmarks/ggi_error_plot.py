"""The error of both decodes against the resolution, as a small SVG without further packages."""

from __future__ import annotations

from pathlib import Path

import numpy as np

WIDTH, HEIGHT = 640, 400
LEFT, RIGHT, TOP, BOTTOM = 70, 24, 24, 56
COLORS = {"outline": "#1f6fb2", "grid": "#d9822b"}
LABELS = {"outline": "outline decode", "grid": "grid decode"}
TICKS = (0.001, 0.003, 0.01, 0.03, 0.1, 0.3)


def plot_errors(errors: dict[str, dict[int, list[float]]], path: Path) -> None:
    """Draws the mean over garments, and the middle 90 % as a band, on logarithmic axes.

    Args:
        errors: For each method and resolution the mean distances of all garments, cm.
        path: SVG file to write.
    """
    resolutions = sorted({r for by in errors.values() for r in by})
    low, high = TICKS[0], TICKS[-1]

    def x(resolution: float) -> float:
        span = np.log(resolutions[-1] / resolutions[0]) or 1.0
        return LEFT + (WIDTH - LEFT - RIGHT) * float(np.log(resolution / resolutions[0]) / span)

    def y(error: float) -> float:
        error = min(max(error, low), high)
        return HEIGHT - BOTTOM - (HEIGHT - TOP - BOTTOM) * float(np.log(error / low) / np.log(high / low))

    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{HEIGHT}" '
        f'viewBox="0 0 {WIDTH} {HEIGHT}" font-family="sans-serif" font-size="13">',
        f'<rect width="{WIDTH}" height="{HEIGHT}" fill="#ffffff"/>',
    ]
    for tick in TICKS:
        at = f"{y(tick):.1f}"
        parts += [
            f'<line x1="{LEFT}" x2="{WIDTH - RIGHT}" y1="{at}" y2="{at}" stroke="#dddddd"/>',
            f'<text x="{LEFT - 8}" y="{y(tick) + 4:.1f}" text-anchor="end">{tick:g}</text>',
        ]
    for r in resolutions:
        parts.append(f'<text x="{x(r):.1f}" y="{HEIGHT - BOTTOM + 20}" text-anchor="middle">{r}</text>')
    middle = f"{(LEFT + WIDTH - RIGHT) / 2:.0f}"
    parts += [
        f'<text x="{middle}" y="{HEIGHT - 12}" text-anchor="middle">pixels a side</text>',
        f'<text transform="translate(18 {(TOP + HEIGHT - BOTTOM) / 2:.0f}) rotate(-90)" '
        'text-anchor="middle">mean distance to the drape, cm</text>',
    ]
    for number, (method, by) in enumerate(errors.items()):
        color = COLORS[method]
        upper = [(x(r), y(np.percentile(by[r], 95))) for r in resolutions]
        lower = [(x(r), y(np.percentile(by[r], 5))) for r in reversed(resolutions)]
        band = " ".join(f"{a:.1f},{b:.1f}" for a, b in upper + lower)
        line = " ".join(f"{x(r):.1f},{y(float(np.mean(by[r]))):.1f}" for r in resolutions)
        parts.append(f'<polygon points="{band}" fill="{color}" opacity="0.15"/>')
        parts.append(f'<polyline points="{line}" fill="none" stroke="{color}" stroke-width="2.5"/>')
        for point in line.split():
            a, b = point.split(",")
            parts.append(f'<circle cx="{a}" cy="{b}" r="4" fill="{color}"/>')
        top = TOP + 8 + 20 * number
        parts.append(f'<rect x="{WIDTH - 190}" y="{top}" width="14" height="14" fill="{color}"/>')
        parts.append(f'<text x="{WIDTH - 170}" y="{top + 12}">{LABELS[method]}</text>')
    path.write_text("\n".join([*parts, "</svg>\n"]))
