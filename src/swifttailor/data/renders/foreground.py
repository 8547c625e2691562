"""Things before the figure: limbs, bags, edges of furniture."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from swifttailor.arrays import Array
from swifttailor.data.renders.backdrop_colors import Chance, Rgb, mixed_color, random_tint


@dataclass(frozen=True)
class Before:
    """A rod with round ends before the figure: a limb, a bag, the edge of a table."""

    start: tuple[float, float]
    """Of its middle line: across and down, as shares of the picture."""
    end: tuple[float, float]
    radius: float
    """As a share of the picture."""
    color: Rgb
    soft: float = 0.01
    """Over which share of the picture its border is out of focus."""

    def put(self, picture: Array, cover: Array) -> None:
        """Puts it over linear light (h, w, 3) float32, and lowers what it leaves to see, `cover` (h, w)."""
        height, width = cover.shape
        reach = self.radius + self.soft
        columns, rows = (
            slice(
                max(int((min(self.start[k], self.end[k]) - reach) * n), 0),
                max(int((max(self.start[k], self.end[k]) + reach) * n) + 1, 0),
            )
            for k, n in ((0, width), (1, height))
        )
        if rows.start >= height or columns.start >= width:
            return
        x = ((np.arange(width, dtype=np.float32)[columns] + 0.5) / width)[None]
        y = ((np.arange(height, dtype=np.float32)[rows] + 0.5) / height)[:, None]
        (x0, y0), (x1, y1) = self.start, self.end
        length = max((x1 - x0) ** 2 + (y1 - y0) ** 2, 1e-9)
        along = np.clip(((x - x0) * (x1 - x0) + (y - y0) * (y1 - y0)) / length, 0, 1)
        dx, dy = x - x0 - along * (x1 - x0), y - y0 - along * (y1 - y0)
        away = np.sqrt(dx * dx + dy * dy)
        alpha = np.clip((self.radius - away) / max(self.soft, 2e-3) + 0.5, 0, 1)
        round_ = 0.55 + 0.45 * np.sqrt(np.clip(1 - (away / self.radius) ** 2, 0, 1))
        round_ *= 1 + 0.25 * np.clip(-(dx + dy) / self.radius, -1, 1)
        for k in range(3):
            part = picture[rows, columns, k]
            part += alpha * (np.float32(self.color[k]) * round_ - part)
        cover[rows, columns] *= 1 - alpha


def random_before(chance: Chance) -> tuple[Before, ...]:
    """Things before the figure, drawn by lot: most often none, and then near the picture's borders."""
    if chance.random() > 0.2:
        return ()
    things = []
    for _ in range(1 + int(chance.random() < 0.3)):
        kind, side = chance.random(), float(chance.choice([-1, 1]))
        skin = mixed_color((0.55, 0.36, 0.27), (0.10, 0.06, 0.04), chance.random())
        any_color = random_tint(chance)
        if kind < 0.35:  # somebody beside
            x = 0.5 + side * chance.uniform(0.38, 0.52)
            wide = chance.uniform(0.06, 0.12)
            things.append(Before((x, chance.uniform(0.25, 0.4)), (x, 1.2), wide, any_color, _soft(chance)))
            arm = x - side * wide * 0.9
            things.append(Before((arm, 0.38), (arm, 0.65), wide * 0.3, skin, _soft(chance)))
        elif kind < 0.6:  # an arm that reaches in
            y = chance.uniform(0.3, 0.9)
            end = 0.5 + side * chance.uniform(0.12, 0.35)
            radius = float(chance.uniform(0.012, 0.03))
            start = (0.5 + side * 0.6, y + chance.uniform(-0.2, 0.2))
            things.append(Before(start, (end, y), radius, skin, _soft(chance)))
        elif kind < 0.85:  # an edge of furniture
            y = chance.uniform(0.82, 1.0)
            slant, radius = chance.uniform(-0.08, 0.08), float(chance.uniform(0.05, 0.14))
            things.append(Before((-0.2, y + 0.1), (1.2, y + 0.1 + slant), radius, any_color, _soft(chance)))
        else:  # a bag
            x, y = 0.5 + side * chance.uniform(0.12, 0.2), chance.uniform(0.5, 0.62)
            wide = float(chance.uniform(0.02, 0.05))
            things.append(Before((x - wide, y), (x + wide, y), wide * 1.3, any_color, 0.006))
            things.append(Before((x, y - wide), (0.5 + 0.03 * side, 0.22), 0.005, any_color, 0.005))
    return tuple(
        Before(
            (float(b.start[0]), float(b.start[1])),
            (float(b.end[0]), float(b.end[1])),
            float(b.radius),
            b.color,
            b.soft,
        )
        for b in things
    )


def _soft(chance: Chance) -> float:
    return float(chance.choice([0.005, 0.02, 0.06]))
