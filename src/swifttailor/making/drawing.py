"""Lines and texts at true size, before they become PDF, SVG or pixels."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field, replace
from typing import NamedTuple

import numpy as np

from swifttailor.arrays import Floats


class Style(NamedTuple):
    """How a line is drawn; also its meaning."""

    name: str
    color: str
    """``#rrggbb``."""
    width: float
    """mm."""
    dash: tuple[float, ...] = ()
    """Lengths of dashes and gaps, mm."""


CUT = Style("cut", "#000000", 0.45)
SEW = Style("sew", "#6b6b6b", 0.25, (3.0, 1.6))
NOTCH = Style("notch", "#000000", 0.45)
GRAIN = Style("grain", "#1f4e8c", 0.35)
FOLD = Style("fold", "#1f4e8c", 0.6, (6.0, 1.5, 1.0, 1.5))
DART = Style("dart", "#8a2b2b", 0.3, (1.6, 1.2))
GATHER = Style("gather", "#8a2b2b", 0.3, (0.8, 1.2))
NUMBER = Style("number", "#8a2b2b", 0.2)
FRAME = Style("frame", "#9a9a9a", 0.2)
GUIDE = Style("guide", "#c8c8c8", 0.2)
TRIM = Style("trim", "#5b3f8f", 0.2, (1.4, 1.0))
BUTTON = Style("button", "#5b3f8f", 0.25)
CLOTH = Style("cloth", "#b0b0b0", 0.4)
STYLES = (CUT, SEW, NOTCH, GRAIN, FOLD, DART, GATHER, NUMBER, FRAME, GUIDE, TRIM, BUTTON, CLOTH)


@dataclass(frozen=True, eq=False)
class Stroke:
    """A polyline."""

    points: Floats
    """(n, 2) cm, y up."""
    style: Style
    closed: bool = False


@dataclass(frozen=True, eq=False)
class Text:
    """A line of text around a point."""

    text: str
    x: float
    """cm."""
    y: float
    """cm; of the base line."""
    size: float
    """Font size, cm."""
    angle: float = 0.0
    """Degrees, anticlockwise."""
    anchor: str = "middle"
    """``start``, ``middle`` or ``end``."""
    bold: bool = False
    color: str = "#000000"
    halo: bool = False
    """Whether what lies under it is kept clear of its letters."""


@dataclass(frozen=True, eq=False)
class Drawing:
    """Strokes and texts in one plane."""

    strokes: tuple[Stroke, ...] = ()
    texts: tuple[Text, ...] = ()
    layer: str = field(default="", kw_only=True)
    """Name of a layer that can be shown or hidden: the size, where a file holds several."""

    def moved(self, turn: Floats, shift: Floats) -> Drawing:
        """The drawing turned by a matrix (2, 2), then shifted by (2,) cm; no text stands on its head."""
        angle = float(np.degrees(np.arctan2(turn[1, 0], turn[0, 0])))
        texts = []
        for text in self.texts:
            x, y = turn @ np.array([text.x, text.y]) + shift
            turned = (text.angle + angle + 180.0) % 360.0 - 180.0
            if not -91.0 < turned <= 91.0 and text.anchor == "middle":
                up = np.radians(turned + 90.0)
                x, y = x + 0.7 * text.size * np.cos(up), y + 0.7 * text.size * np.sin(up)
                turned += 180.0
            texts.append(replace(text, x=float(x), y=float(y), angle=turned))
        strokes = tuple(replace(s, points=s.points @ turn.T + shift) for s in self.strokes)
        return replace(self, strokes=strokes, texts=tuple(texts))

    @staticmethod
    def joined(drawings: Iterable[Drawing]) -> Drawing:
        """Several drawings as one."""
        drawings = list(drawings)
        return Drawing(
            tuple(s for d in drawings for s in d.strokes), tuple(t for d in drawings for t in d.texts)
        )


def arrow_head(tip: Floats, along: Floats, size: float) -> Floats:
    """Polyline (3, 2) of an open arrow head at a tip, for a line that comes along a unit vector."""
    across = np.array([-along[1], along[0]])
    return np.array([tip - size * along + 0.4 * size * across, tip, tip - size * along - 0.4 * size * across])


def circle(center: Floats, radius: float) -> Floats:
    """Closed polyline (24, 2)."""
    angle = np.linspace(0.0, 2 * np.pi, 24, endpoint=False)
    return center + radius * np.stack([np.cos(angle), np.sin(angle)], axis=1)
