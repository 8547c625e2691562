"""How a print is told to the compiled loop: one row of numbers, and which of them means what."""

from __future__ import annotations

from typing import Protocol, runtime_checkable

import numpy as np

from swifttailor.arrays import Array

COORDINATES, PLAIN, STRIPES, CHECKS, DOTS, PLAID, MOTIF = range(7)
"""Kinds of prints, number 0 of a row. The first only says where on the cloth a sample lies."""

KIND, GRAIN, SEED, COS, SIN = range(5)
SIZES = 5
"""Six numbers that a kind of print needs: widths, spacings, which motif."""
BLUR = 10
"""The last of them, of kinds with bands: over how much cloth they are averaged, cm; 0: as they are."""
COLORS = 11
"""Six colours."""
WEAVE, WEAVE_PERIOD, WEAVE_DARK, WEAVE_BUMP, WEAVE_HOLE = range(29, 34)
HOLE_COLOR = 34
FOLDS, FOLDS_SIZE, FOLDS_ALONG, FOLDS_U, FOLDS_V = range(37, 42)
WEAR, WEAR_SIZE = 42, 43
WEAR_COLOR = 44
GRAPHIC, GRAPHIC_X, GRAPHIC_Y, GRAPHIC_WIDTH, GRAPHIC_HEIGHT, GRAPHIC_SIDE, GRAPHIC_MIDDLE = range(47, 54)
GRAPHIC_COLORS = 54
BLOCK, BLOCK_AT, BLOCK_TO = 60, 61, 62
BLOCK_COLOR = 63
FADE, FADE_FROM, FADE_TO, FADE_NOISE = 66, 67, 68, 69
FADE_COLOR = 70
MARKS = 73
"""How many marks follow, then ten numbers of each."""
MARK = 10
MOST_MARKS = 6
LENGTH = MARKS + 1 + MARK * MOST_MARKS
LAYERS = 8
"""What `layers` tells apart, before the marks."""


@runtime_checkable
class TableOfPrint(Protocol):
    """A print that the compiled loop knows."""

    def table(self) -> Array:
        """(LENGTH,) float32."""
        ...


def new_table(kind: int) -> Array:
    """A row (LENGTH,) float32 that has a kind of print and nothing else."""
    table = np.zeros(LENGTH, np.float32)
    table[KIND], table[COS], table[GRAPHIC] = kind, 1.0, -1.0
    return table


def layers(table: Array) -> int:
    """Bits of the layers of colour that a row has, so that the loop need not look at the others."""
    kind, woven = int(table[KIND]), table[WEAVE] > 0
    has = (
        kind > PLAIN,
        kind == PLAID,
        table[FADE] > 0,
        table[BLOCK] > 0,
        table[WEAR] > 0,
        table[GRAPHIC] >= 0,
        table[GRAIN] > 0 or (woven and table[WEAVE_DARK] > 0),
        woven and table[WEAVE_HOLE] > 0,
        *[True] * int(table[MARKS]),
    )
    return sum(1 << k for k, there in enumerate(has) if there)
