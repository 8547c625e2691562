"""Cloths drawn by lot, as shops show them."""

from __future__ import annotations

import colorsys
from dataclasses import dataclass

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.render import Checks, Dots, Plain, Stripes, to_linear
from swifttailor.render.cloths import BLOCKS, Block, Cloth, Fade, Folds, Graphic, Mark, Wear, Weave
from swifttailor.render.motifs import GRAPHICS, MOTIFS
from swifttailor.render.prints import KnownPrint, Motif, Plaid

Rgb = tuple[float, float, float]

_BASICS = (
    ("#f5f4f0", 3.0),  # white
    ("#16161a", 4.0),  # black
    ("#232a40", 2.5),  # navy
    ("#8b8c8f", 1.5),  # grey
    ("#c9c8c5", 1.0),
    ("#45464b", 1.2),
    ("#ece3d2", 1.5),  # cream
    ("#cdb89a", 1.5),  # beige
    ("#8a6f54", 1.0),  # camel, brown
    ("#4a372c", 0.8),
    ("#6a6a4c", 1.0),  # olive
    ("#2f4237", 0.7),  # bottle green
    ("#6b1f2c", 0.9),  # burgundy
    ("#b3202c", 1.0),  # red
    ("#c65a3a", 0.7),  # rust
    ("#d99aa5", 1.0),  # pink
    ("#c9b3d6", 0.5),  # lilac
    ("#8fb1d6", 0.9),  # light blue
    ("#2f58a8", 0.9),  # royal blue
    ("#2e7d7a", 0.5),  # teal
    ("#a8b79a", 0.6),  # sage
    ("#dbb84b", 0.6),  # mustard
    ("#e8c9b8", 0.6),  # blush
)
_DENIMS = ("#1f2b44", "#33507e", "#5f81ab", "#9db6d0", "#222327", "#4b4f57", "#d9d6cb")
_LEATHERS = ("#151415", "#2c211c", "#5a3a28", "#7b2d2a", "#c9b195")
_KINDS = (
    ("plain", 0.30),
    ("knit", 0.13),
    ("denim", 0.09),
    ("stripes", 0.10),
    ("checks", 0.07),
    ("dots", 0.04),
    ("motif", 0.13),
    ("satin", 0.05),
    ("leather", 0.02),
    ("quilt", 0.02),
    ("lace", 0.03),
    ("cord", 0.02),
)
_SKIN: Rgb = (0.45, 0.28, 0.20)


@dataclass(frozen=True)
class DrawnCloth:
    """A cloth and how it shines."""

    cloth: Cloth
    inside: Rgb
    """The wrong side."""
    gloss: float = 0.0
    sheen: float = 0.08


@dataclass(frozen=True)
class Place:
    """Where on the standing body a garment is, for what is put on a part of it."""

    low: tuple[float, float, float]
    """Least x, y, z, cm."""
    high: tuple[float, float, float]
    """Most x, y, z, cm."""

    @classmethod
    def of(cls, vertices: Floats) -> Place:
        """Of vertices (n, 3) on the standing body, cm."""
        low, high = vertices.min(axis=0), vertices.max(axis=0)
        return cls(_rgb(low), _rgb(high))


WHOLE = Place((-30.0, 60.0, -15.0), (30.0, 145.0, 20.0))


def random_cloth(chance: np.random.Generator, place: Place = WHOLE, *, behind: Rgb = _SKIN) -> DrawnCloth:
    """A cloth drawn by lot.

    Args:
        chance: Where the lots come from; the same state gives the same cloth.
        place: Where the garment is, for graphics, blocks, pockets and buttons.
        behind: Colour that is seen through holes.
    """
    kind = str(chance.choice([k for k, _ in _KINDS], p=[p for _, p in _KINDS]))
    base, weave, wear, gloss, sheen = _fabric(chance, kind, behind)
    first = np.asarray(base.table()[11:14], np.float64)
    folds = None
    if chance.random() < 0.85:
        strong = 0.5 if kind in ("leather", "quilt") else 1.0
        folds = Folds(
            slope=float(strong * chance.gamma(2.0, 0.07)),
            size=float(chance.uniform(12, 45)),
            along=float(chance.uniform(0.7, 2.0)),
            at=(float(chance.uniform(0, 256)), float(chance.uniform(0, 256))),
        )
    plain = kind in ("plain", "knit", "satin", "denim", "cord")
    graphic = _graphic(chance, place, first) if plain and chance.random() < 0.22 else None
    block = _block(chance, place, first) if graphic is None and chance.random() < 0.10 else None
    fade = None
    if plain and graphic is None and block is None and chance.random() < 0.06:
        ends = sorted(chance.uniform(place.low[1], place.high[1], 2))
        noise = float(chance.choice([0.03, 0.15, 0.6]))
        fade = Fade(_other(chance, first), float(ends[1]) + 5.0, float(ends[0]) - 5.0, noise)
    marks = _marks(chance, place, first) if chance.random() < 0.25 else ()
    cloth = Cloth(base, weave, folds, wear, graphic, block, fade, marks)
    grey = float(first @ (0.2126, 0.7152, 0.0722))
    return DrawnCloth(cloth, _rgb(0.75 * (0.7 * first + 0.3 * grey) + 0.02), gloss, sheen)


def random_color(chance: np.random.Generator) -> Rgb:
    """A colour that shops have: mostly basics, a little off, else any hue."""
    if chance.random() < 0.75:
        weights = np.array([w for _, w in _BASICS])
        base = to_linear(_BASICS[int(chance.choice(len(_BASICS), p=weights / weights.sum()))][0])
        return _rgb(np.clip(base * chance.uniform(0.8, 1.2) * chance.uniform(0.92, 1.08, 3), 0.006, 0.9))
    hue, saturation, value = chance.random(), chance.beta(2.5, 2), chance.uniform(0.3, 0.95)
    return _rgb(np.clip(to_linear(colorsys.hsv_to_rgb(hue, saturation, value)), 0.006, 0.9))


def _other(chance: np.random.Generator, color: Floats) -> Rgb:
    """A colour that can be told from another."""
    for _ in range(8):
        other = random_color(chance)
        if np.abs(np.sqrt(other) - np.sqrt(color)).max() > 0.18:
            return other
    return (0.85, 0.84, 0.8) if color.max() < 0.4 else (0.015, 0.015, 0.02)


def _fabric(
    chance: np.random.Generator, kind: str, behind: Rgb
) -> tuple[KnownPrint, Weave | None, Wear | None, float, float]:
    """Print, weave, wear, gloss and sheen of a kind of cloth."""
    color, seed = random_color(chance), int(chance.integers(1 << 20))
    other = _other(chance, np.asarray(color))
    grain = float(chance.choice([0.0, chance.uniform(0.0, 0.10)]))
    angle = float(chance.choice([0.0, 90.0, 45.0], p=[0.55, 0.35, 0.10]))
    sheen = float(chance.uniform(0.02, 0.14))
    if kind == "knit":
        sort = str(chance.choice(["rib", "jersey", "cable"], p=[0.5, 0.25, 0.25]))
        period = float({"rib": 0.9, "jersey": 0.8, "cable": 7.0}[sort] * chance.uniform(0.6, 2.2))
        weave = Weave(sort, period, float(chance.uniform(0.1, 0.4)), float(chance.uniform(0.0, 0.35)))
        striped = chance.random() < 0.15
        width = float(chance.uniform(1, 5))
        knit = Stripes(color, other, width, width, 0.0, 0.05, seed) if striped else Plain(color, 0.08, seed)
        return knit, weave, None, 0.0, 0.16
    if kind == "denim":
        base = to_linear(_DENIMS[int(chance.integers(len(_DENIMS)))]) * chance.uniform(0.8, 1.2)
        weave = Weave("twill", float(chance.uniform(0.25, 0.6)), float(chance.uniform(0.05, 0.25)), 0.0)
        paler = _rgb(np.clip(base * 2.2 + 0.12, 0, 0.8))
        wear = Wear(paler, float(chance.uniform(0.1, 0.6)), float(chance.uniform(15, 50)))
        return Plain(_rgb(base), 0.16, seed), weave, wear if chance.random() < 0.7 else None, 0.0, 0.03
    if kind == "stripes":
        width = float(chance.choice([chance.uniform(0.3, 1.2), chance.uniform(1.0, 6.0)]))
        gap = width * float(chance.choice([1.0, chance.uniform(0.5, 6.0)]))
        return Stripes(color, other, width, gap, angle, grain, seed), None, None, 0.0, sheen
    if kind == "checks":
        turned = 45.0 if chance.random() < 0.15 else 0.0
        if chance.random() < 0.35:
            return (
                Checks(color, other, float(chance.uniform(0.5, 4)), turned, grain, seed),
                None,
                None,
                0,
                sheen,
            )
        third = _other(chance, np.asarray(color))
        sizes = (
            float(chance.uniform(4, 16)),
            float(chance.uniform(0.25, 0.5)),
            float(chance.uniform(0.03, 0.12)),
        )
        return Plaid(color, other, third, *sizes, turned, grain, seed), None, None, 0.0, sheen
    if kind == "dots":
        spacing = float(chance.uniform(1.5, 8))
        dots = Dots(color, other, spacing, spacing * float(chance.uniform(0.12, 0.36)), angle, grain, seed)
        return dots, None, None, 0.0, sheen
    if kind == "motif":
        colors = (color, other, random_color(chance), random_color(chance))
        if chance.random() < 0.35:  # tone in tone
            colors = tuple(_rgb(np.asarray(color) * f) for f in (1.0, *chance.uniform(0.4, 1.6, 3)))
        repeat = float(chance.choice([chance.uniform(8, 20), chance.uniform(20, 60)]))
        motif = Motif(colors, int(chance.integers(MOTIFS)), repeat, angle, grain, seed)
        return motif, None, None, 0.0, sheen
    if kind == "satin":
        return Plain(color, 0.0, seed), None, None, float(chance.uniform(0.15, 0.5)), 0.25
    if kind == "leather":
        base = to_linear(_LEATHERS[int(chance.integers(len(_LEATHERS)))])
        return Plain(_rgb(base), 0.0, seed), None, None, float(chance.uniform(0.25, 0.6)), 0.05
    if kind == "quilt":
        weave = Weave("quilt", float(chance.uniform(5, 14)), 0.3, float(chance.uniform(0.2, 0.5)))
        return Plain(color, 0.0, seed), weave, None, float(chance.uniform(0.0, 0.3)), 0.05
    if kind == "lace":
        sort = "lace" if chance.random() < 0.65 else "mesh"
        period = float(chance.uniform(0.5, 1.6))
        weave = Weave(sort, period, 0.0, 0.0, float(chance.uniform(0.2, 0.55)), behind)
        return Plain(color, 0.05, seed), weave, None, 0.0, sheen
    if kind == "cord":
        weave = Weave("cord", float(chance.uniform(0.3, 1.0)), float(chance.uniform(0.15, 0.4)), 0.15)
        return Plain(color, 0.06, seed), weave, None, 0.0, 0.25
    return Plain(color, grain, seed), None, None, 0.0, sheen


def _graphic(chance: np.random.Generator, place: Place, color: Floats) -> Graphic:
    high = chance.random() < 0.75
    wide = float(chance.choice([chance.uniform(6, 12), chance.uniform(14, 30)]))
    top = place.high[1]
    y = top - float(chance.uniform(14, 30)) if high else float(chance.uniform(place.low[1], top))
    x = float(chance.choice([0.0, chance.uniform(-10, 10)], p=[0.7, 0.3]))
    inks = _other(chance, color), random_color(chance)
    size = wide, wide * float(chance.uniform(0.3, 1.3))
    return Graphic(
        int(chance.integers(GRAPHICS)), (x, y), size, inks, bool(chance.random() < 0.8), _middle(place)
    )


def _block(chance: np.random.Generator, place: Place, color: Floats) -> Block:
    kind = str(chance.choice(BLOCKS[1:]))
    low, high = place.low[1], place.high[1]
    at = {
        "below": low + (high - low) * chance.uniform(0.1, 0.6),
        "above": high - (high - low) * chance.uniform(0.1, 0.5),
        "left": 0.0,
        "middle": chance.uniform(5, 12),
        "outside": chance.uniform(14, 24),
        "band": low + (high - low) * chance.uniform(0.3, 0.9),
    }[kind]
    return Block(kind, _other(chance, color), float(at), float(at) - float(chance.uniform(3, 15)))


def _marks(chance: np.random.Generator, place: Place, color: Floats) -> tuple[Mark, ...]:
    """Buttons on a placket, a zip, pockets: thin and not much darker or lighter than the cloth."""
    z, low, high = _middle(place), place.low[1], place.high[1]
    near = _rgb(np.clip(color * chance.choice([0.45, 1.9]) + 0.01, 0, 0.85))
    half = max((high - low) / 2 - 5.0, 5.0), (high + low) / 2
    kind = chance.random()
    if kind < 0.35:
        button = near if chance.random() < 0.6 else _other(chance, color)
        placket = Mark("pocket", (0.0, half[1]), (3.2, 2 * half[0]), near, middle=z)
        row = Mark(
            "buttons", (0.0, half[1]), (1.3, 2 * half[0]), button, float(chance.uniform(6, 11)), middle=z
        )
        return (placket, row) if chance.random() < 0.6 else (row,)
    if kind < 0.5:
        return (Mark("line", (0.0, half[1]), (0.9, 2 * half[0]), near, middle=z),)
    sort = "stitching" if chance.random() < 0.4 else "pocket"
    if high < 115:  # below the waist
        y, front = high - float(chance.uniform(14, 20)), bool(chance.random() < 0.5)
    else:
        y, front = high - float(chance.uniform(22, 32)), True
    size = float(chance.uniform(9, 13)), float(chance.uniform(9, 14))
    x = float(chance.uniform(7, 11))
    pair = [Mark(sort, (s * x, y), size, near, front=front, middle=z) for s in (-1, 1)]
    return tuple(pair[: 1 + int(chance.random() < 0.6)])


def _middle(place: Place) -> float:
    return (place.low[2] + place.high[2]) / 2


def _rgb(values) -> Rgb:
    r, g, b = (float(v) for v in values)
    return r, g, b
