"""Cloths as they are worn: a print with what weaving, wearing, folding and sewing add to it."""

from __future__ import annotations

from dataclasses import dataclass

from swifttailor.arrays import Array
from swifttailor.errors import InputError
from swifttailor.render import cloth_table as place
from swifttailor.render.prints import KnownPrint, LinearColor

WEAVES = ("none", "rib", "jersey", "cable", "twill", "mesh", "quilt", "lace", "cord")
MARKS = ("line", "buttons", "pocket", "stitching")
BLOCKS = ("none", "below", "above", "left", "middle", "outside", "band")


@dataclass(frozen=True)
class Weave:
    """How yarn or stitching shows."""

    kind: str
    """One of `WEAVES`."""
    period: float
    """Centimetres after which it repeats."""
    dark: float = 0.2
    """Share of light that its grooves take."""
    bump: float = 0.2
    """Slope of its flanks."""
    hole: float = 0.0
    """Share of cloth that is open, for ``mesh`` and ``lace``."""
    behind: LinearColor = (0.3, 0.2, 0.15)
    """Colour that is seen through the holes."""


@dataclass(frozen=True)
class Folds:
    """Wrinkles that only light shows."""

    slope: float
    """Of their flanks."""
    size: float
    """Centimetres from one to the next."""
    along: float = 1.0
    """How much longer than wide."""
    at: tuple[float, float] = (0.0, 0.0)
    """Where the noise begins; other places give other folds."""


@dataclass(frozen=True)
class Wear:
    """Zones that have become lighter, on thighs and in blotches."""

    color: LinearColor
    strength: float
    size: float = 25.0
    """Of the blotches, cm."""


@dataclass(frozen=True)
class Graphic:
    """A picture or lettering on the front or the back."""

    graphic: int
    """Which (`motifs`)."""
    at: tuple[float, float]
    """Middle on the standing body: x and height, cm."""
    size: tuple[float, float]
    """Width and height, cm."""
    colors: tuple[LinearColor, LinearColor]
    front: bool = True
    middle: float = 0.0
    """Depth of the garment's middle, z in cm, which tells front and back apart."""


@dataclass(frozen=True)
class Block:
    """A part of the garment in another colour."""

    kind: str
    """One of `BLOCKS`."""
    color: LinearColor
    at: float
    """Height or x where it begins, cm."""
    to: float = 0.0
    """Where a ``band`` ends, cm."""


@dataclass(frozen=True)
class Fade:
    """One colour going over into another from one height to a lower one: ombré, dip dye, tie dye."""

    color: LinearColor
    start: float
    """Height, cm."""
    end: float
    noise: float = 0.1
    """How uneven; towards 1 it becomes blotches."""


@dataclass(frozen=True)
class Mark:
    """Something small that is sewn on, on the front of the standing body."""

    kind: str
    """One of `MARKS`."""
    at: tuple[float, float]
    """Middle: x and height, cm."""
    size: tuple[float, float]
    """Width and height, cm."""
    color: LinearColor
    step: float = 8.0
    """From one button to the next, cm."""
    front: bool = True
    middle: float = 0.0
    """See `Graphic.middle`."""


@dataclass(frozen=True)
class Cloth(KnownPrint):
    """A print and all that lies over it; takes the place of a `Print`."""

    base: KnownPrint
    weave: Weave | None = None
    folds: Folds | None = None
    wear: Wear | None = None
    graphic: Graphic | None = None
    block: Block | None = None
    fade: Fade | None = None
    marks: tuple[Mark, ...] = ()

    def table(self) -> Array:
        """See `cloth_table`."""
        if len(self.marks) > place.MOST_MARKS:
            raise InputError(f"A cloth has at most {place.MOST_MARKS} marks, got {len(self.marks)}.")
        table = self.base.table()
        if (w := self.weave) is not None:
            numbers = WEAVES.index(w.kind), w.period, w.dark, w.bump, w.hole, *w.behind
            table[place.WEAVE : place.WEAVE + 8] = numbers
        if (f := self.folds) is not None:
            table[place.FOLDS : place.FOLDS + 5] = f.slope, f.size, f.along, *f.at
        if self.wear is not None:
            table[place.WEAR : place.WEAR + 5] = self.wear.strength, self.wear.size, *self.wear.color
        if (g := self.graphic) is not None:
            numbers = g.graphic, *g.at, *g.size, 1 if g.front else -1, g.middle, *g.colors[0], *g.colors[1]
            table[place.GRAPHIC : place.GRAPHIC + 13] = numbers
        if (b := self.block) is not None:
            table[place.BLOCK : place.BLOCK + 6] = BLOCKS.index(b.kind), b.at, b.to, *b.color
        if (d := self.fade) is not None:
            table[place.FADE : place.FADE + 7] = 1, d.start, d.end, d.noise, *d.color
        table[place.MARKS] = len(self.marks)
        for k, m in enumerate(self.marks):
            first = place.MARKS + 1 + place.MARK * k
            side = 1 if m.front else -1
            numbers = MARKS.index(m.kind), *m.at, *m.size, m.step, side, *m.color
            table[first : first + place.MARK] = numbers
            table[place.GRAPHIC_MIDDLE] = m.middle
        return table
