"""Prints and weaves, given by their colours at points of the cloth."""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass

import numpy as np

from swifttailor.arrays import Array
from swifttailor.errors import InputError
from swifttailor.render.cloth_table import (
    CHECKS,
    COLORS,
    COS,
    DOTS,
    FOLDS,
    GRAIN,
    KIND,
    MOTIF,
    PLAID,
    PLAIN,
    SEED,
    SIN,
    SIZES,
    STRIPES,
    WEAVE,
    layers,
    new_table,
)

LinearColor = tuple[float, float, float]
"""Linear-light RGB."""
MOST_COLORS = 6
"""Of one print."""
_WITHOUT_BANK = 0b1000011
"""Layers of colour for which `motifs.bank` is not looked into: the print, its lines, and the grain."""
_NO_BANK = np.zeros(1, np.int16)


class KnownPrint(ABC):
    """What all prints here have in common: a row of numbers for the compiled loop."""

    @abstractmethod
    def table(self) -> Array:
        """See `cloth_table`."""

    def colors(self, at: Array, rest: Array | None = None) -> Array:
        """See `Print`.

        Args:
            at: (n, 2) points of the cloth, cm.
            rest: (n, 3) where they lie on a standing body, cm; the origin when None.
        """
        from swifttailor.render.print_kernels import color_points

        points = np.zeros((len(at), 5))
        points[:, :2] = at
        if rest is not None:
            points[:, 2:] = rest
        colors = np.zeros((len(at), 3), np.float32)
        table = self.table()
        color_points(points, table, layers(table), bank_of(table), colors)
        return colors


def bank_of(table: Array) -> Array:
    """What the compiled loop looks up for a row: `motifs.bank`, a named picture, or both in one.

    The bank takes seconds to make; bands, dots and named pictures have nothing of it.

    Args:
        table: See `cloth_table`.
    """
    from swifttailor.render.motifs import BANDS, bank

    named = table[KIND] == MOTIF and table[SIZES] > BANDS
    lots = (table[KIND] == MOTIF and not named) or table[WEAVE] > 0.0 or table[FOLDS] > 0.0
    lots = lots or bool(layers(table) & ~_WITHOUT_BANK)
    if not named:
        return bank() if lots else _NO_BANK
    from swifttailor.render.named_pictures import named_picture

    own = named_picture(int(table[SIZES]))
    return np.concatenate([bank(), own]) if lots else own


@dataclass(frozen=True)
class Plain(KnownPrint):
    """One colour with the unevenness of yarn."""

    color: LinearColor
    grain: float = 0.08
    """Relative unevenness."""
    seed: int = 0

    def table(self) -> Array:
        """See `cloth_table`."""
        return _table(PLAIN, self.grain, self.seed, 0.0, (), (self.color,))


@dataclass(frozen=True)
class Stripes(KnownPrint):
    """Bands of two colours."""

    first: LinearColor
    second: LinearColor
    width: float
    """Of a band of the first colour, cm."""
    gap: float
    """Of a band of the second colour, cm."""
    angle: float = 0.0
    """Degrees: 0 runs across the panel, 90 along it."""
    grain: float = 0.05
    seed: int = 0

    def table(self) -> Array:
        """See `cloth_table`."""
        sizes, colors = (self.width, self.gap), (self.first, self.second)
        return _table(STRIPES, self.grain, self.seed, self.angle, sizes, colors)


@dataclass(frozen=True)
class Checks(KnownPrint):
    """Bands that cross, darkest where both are: gingham."""

    first: LinearColor
    second: LinearColor
    width: float
    """Of a band, cm; gaps are as wide."""
    angle: float = 0.0
    """Degrees."""
    grain: float = 0.05
    seed: int = 0

    def table(self) -> Array:
        """See `cloth_table`."""
        colors = self.first, self.second
        return _table(CHECKS, self.grain, self.seed, self.angle, (self.width,), colors)


@dataclass(frozen=True)
class Dots(KnownPrint):
    """Dots of one colour on another, every second row shifted."""

    ground: LinearColor
    dot: LinearColor
    spacing: float
    """Between neighbours, cm."""
    radius: float
    """Of a dot, cm."""
    angle: float = 0.0
    """Degrees."""
    grain: float = 0.05
    seed: int = 0

    def table(self) -> Array:
        """See `cloth_table`."""
        sizes, colors = (self.spacing, self.radius), (self.ground, self.dot)
        return _table(DOTS, self.grain, self.seed, self.angle, sizes, colors)


@dataclass(frozen=True)
class Plaid(KnownPrint):
    """Wide bands that cross, with thin lines between: tartan."""

    ground: LinearColor
    band: LinearColor
    line: LinearColor
    spacing: float
    """From one band to the next, cm."""
    width: float = 0.4
    """Share of that which the band takes."""
    thin: float = 0.06
    """Share of that which a line takes."""
    angle: float = 0.0
    """Degrees."""
    grain: float = 0.05
    seed: int = 0

    def table(self) -> Array:
        """See `cloth_table`."""
        sizes, colors = (self.spacing, self.width, self.thin), (self.ground, self.band, self.line)
        return _table(PLAID, self.grain, self.seed, self.angle, sizes, colors)


@dataclass(frozen=True)
class Motif(KnownPrint):
    """A pattern that repeats: flowers, camouflage of four colours (`motifs`), or `named_pictures` of six."""

    colors_of: tuple[LinearColor, ...]
    motif: int
    """Which; counted on from the last one without a name it begins anew."""
    repeat: float = 20.0
    """Centimetres after which it repeats."""
    angle: float = 0.0
    """Degrees."""
    grain: float = 0.05
    seed: int = 0

    def table(self) -> Array:
        """See `cloth_table`."""
        colors = [self.colors_of[k % len(self.colors_of)] for k in range(MOST_COLORS)]
        return _table(MOTIF, self.grain, self.seed, self.angle, (self.motif, self.repeat), colors)


def _table(kind, grain, seed, angle, sizes, colors) -> Array:
    if len(colors) > MOST_COLORS:
        raise InputError(f"A print has at most {MOST_COLORS} colours, got {len(colors)}.")
    table = new_table(kind)
    turn = np.deg2rad(angle)
    table[GRAIN], table[SEED], table[COS], table[SIN] = grain, seed, np.cos(turn), np.sin(turn)
    table[SIZES : SIZES + len(sizes)] = sizes
    for k, color in enumerate(colors):
        table[COLORS + 3 * k : COLORS + 3 * k + 3] = color
    return table
