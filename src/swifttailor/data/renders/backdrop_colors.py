"""Colours of things in a picture that are not the garment."""

from __future__ import annotations

import numpy as np

from swifttailor.arrays import Array

Rgb = tuple[float, float, float]
Chance = np.random.Generator


def random_tint(chance: Chance, low: float = 0.05, high: float = 0.8, vivid: float = 0.25) -> Rgb:
    """Grey from low to high, coloured as paint is: warm or cool far more often than green or purple."""
    grey, warm, green = (
        chance.uniform(low, high),
        vivid * chance.normal(0.35, 1),
        0.3 * vivid * chance.normal(),
    )
    return as_rgb(np.clip(grey * (1 + np.array([warm, 0.15 * warm + green, -warm])), 0.0, 1.0))


def mixed_color(a: Rgb, b: Rgb, share: float) -> Rgb:
    """Between two colours: the first at share 0, the second at 1."""
    return as_rgb(np.asarray(a) + share * (np.asarray(b) - np.asarray(a)))


def as_rgb(values: Array) -> Rgb:
    """Three numbers as a colour."""
    r, g, b = (float(v) for v in values)
    return r, g, b
