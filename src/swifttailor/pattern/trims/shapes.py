"""What a trim is made of: pieces that lie on panels, buttons, and a belt around the body."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from swifttailor.arrays import Floats
from swifttailor.pattern.pattern import EdgeRef

StripKind = Literal["gathered", "threads", "flat"]
Look = Literal["cloth", "dark", "metal", "hole", "thread"]


@dataclass(frozen=True, eq=False)
class Patch:
    """A piece that lies on a panel, between two lines with as many points each."""

    trim: str
    panel: str
    first: Floats
    """(n, 2) panel-local cm."""
    second: Floats
    """(n, 2) panel-local cm; what lies between corresponding points is covered."""
    look: Look = "cloth"
    is_cut: bool = True
    """Whether it is cut of cloth and sewn on; otherwise it is a line of stitches, an opening or a fold."""
    swell: float = 0.0
    """How far it stands off the cloth where it is widest, cm: a fold that hangs from `first` to `second`."""

    @property
    def outline(self) -> Floats:
        """(2 n, 2) its corners in order, panel-local cm."""
        import numpy as np

        return np.concatenate([self.first, self.second[::-1]])


@dataclass(frozen=True)
class Button:
    """A button on a panel."""

    trim: str
    panel: str
    at: tuple[float, float]
    """Its middle, panel-local cm."""
    radius: float
    """cm."""


@dataclass(frozen=True)
class Belt:
    """A band around the body."""

    trim: str
    height: float
    """Of its middle above the floor, cm."""
    width: float
    """cm."""
    reach: float = 0.0
    """How far up or down it slips to where the cloth is narrowest, cm."""


@dataclass(frozen=True)
class Frill:
    """A strip that is sewn to edges: gathered, cut into threads, or flat. Stripes lie beside seams."""

    trim: str
    edges: tuple[EdgeRef, ...]
    """Edges of panels, free ones but for stripes and frills down the front, in any order."""
    depth: float
    """How far it goes beyond them, cm; of a flat one, how wide it is."""
    length: float
    """Of all of its edges together, cm."""
    kind: StripKind = "gathered"
    """Flat ones lie on the cloth."""


@dataclass(frozen=True)
class Bow:
    """A bow with two loops and two ends that hang."""

    trim: str
    panel: str
    at: tuple[float, float]
    """Its knot, panel-local cm."""
    width: float
    """Of both loops together, cm."""
    tail: float
    """Length of the ends, cm."""


@dataclass(frozen=True)
class Stirrup:
    """A strap from the end of a leg under the foot."""

    trim: str
    edges: tuple[EdgeRef, ...]
    """Free edges of panels at the end of one leg, in any order."""
    width: float
    """cm."""


@dataclass(frozen=True)
class Layer:
    """Cloth that hangs over a skirt all around, or over a part of it."""

    trim: str
    panel: str
    """A panel of the skirt that it hangs over, whose colour it has."""
    height: float
    """Of its upper edge above the floor, cm."""
    low: float
    """The same of its hem, cm."""
    flare: float = 0.0
    """How far its hem stands off that of the skirt, cm."""
    reach: float = 180.0
    """How far it goes to both sides of the middle of the back, degrees."""
    behind: float = 0.0
    """How far it lies on the floor behind, cm."""
    opacity: float = 1.0
    """Share of what lies beneath that it hides."""
    puffs: int = 0
    """How many puffs it is gathered up into, one below the other, each as far out as `puff` at most."""
    puff: float = 0.0
    """cm."""
    hoops: int = 0
    """How many hoops hold it out, so that it has no folds."""


Trim = Patch | Button | Belt | Frill | Bow | Stirrup | Layer
