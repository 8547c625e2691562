"""Where each panel goes on the sheet, and where its name fits."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from swifttailor.arrays import Floats
from swifttailor.pattern.panel import Panel

_TEXT_WIDTH = 0.58
"""Mean width of a letter as a share of the font size."""
_GRID = 17
"""Places tried along each side of a panel's box when looking for its middle."""


@dataclass(frozen=True)
class Caption:
    """A panel's name on the sheet."""

    x: float
    y: float
    """Middle of the text, panel-local mm, y up."""
    size: float
    """Font size, mm."""


@dataclass(frozen=True)
class PlacedPanel:
    """A panel as drawn: seen from the right side of the cloth."""

    index: int
    """Position in the pattern."""
    panel: Panel
    """The panel, mirrored when its loop runs clockwise."""
    mirrored: bool
    low: Floats
    """(2,) lower left corner of what it takes up with its caption, panel-local mm, y up."""
    size: Floats
    """(2,) width and height of that, mm."""
    caption: Caption


def place_panel(index: int, panel: Panel, font: float) -> PlacedPanel:
    """Turns a panel right side up and finds room for its name: inside, or else beneath it.

    Args:
        index: Position in the pattern.
        panel: The panel.
        font: Font size wished for, mm.
    """
    mirrored = panel.signed_area() < 0
    shown = panel.mirrored() if mirrored else panel
    box = shown.bounding_box() * 10.0
    center, room = _middle(shown.outline(0.2) * 10.0)
    width = _TEXT_WIDTH * len(shown.name)
    inside = min(font, 1.6 * room / np.hypot(width, 1.0))
    if inside >= 0.55 * font:
        return PlacedPanel(index, shown, mirrored, box[0], box[1] - box[0], Caption(*center, inside))
    low, high = box.copy()
    size = 0.75 * font
    middle, half = (low[0] + high[0]) / 2, width * size / 2
    caption = Caption(middle, low[1] - 1.1 * size, size)
    low = np.array([min(low[0], middle - half), low[1] - 1.8 * size])
    high = np.array([max(high[0], middle + half), high[1]])
    return PlacedPanel(index, shown, mirrored, low, high - low, caption)


def shelves(sizes: Floats, gap: float) -> tuple[Floats, Floats]:
    """Puts boxes (n, 2) on shelves, `gap` apart, keeping their order, on a sheet a little wider than high.

    Returns:
        Upper left corners (n, 2), y down, and the width and height (2,) of the sheet without border.
    """
    total = float(((sizes + gap) ** np.array([1.0, 1.0])).prod(axis=1).sum())
    widest = float(sizes[:, 0].max(initial=0.0))
    best: tuple[float, Floats, Floats] | None = None
    for strip in np.geomspace(max(widest, 0.9 * np.sqrt(total)), max(widest, 2.2 * np.sqrt(total)), 24):
        corners = _fill(sizes, float(strip), gap)
        sheet = (corners + sizes).max(axis=0)
        # Little empty space, and a shape between a square and a screen.
        shape = max(sheet[0] / sheet[1] / 1.8, sheet[1] / sheet[0] / 0.8, 1.0)
        cost = float(sheet.prod() * shape)
        if best is None or cost < best[0] * (1 - 1e-9):
            best = cost, corners, sheet
    assert best is not None
    return best[1], best[2]


def _fill(sizes: Floats, strip: float, gap: float) -> Floats:
    order = np.lexsort((np.arange(len(sizes)), -np.round(sizes[:, 1] / 20.0)))
    corners = np.zeros((len(sizes), 2))
    x = y = shelf = 0.0
    for k in order:
        width, height = sizes[k]
        if x > 0 and x + width > strip * (1 + 1e-12):
            x, y, shelf = 0.0, y + shelf + gap, 0.0
        corners[k] = x, y
        x += width + gap
        shelf = max(shelf, height)
    return corners


def _middle(outline: Floats) -> tuple[tuple[float, float], float]:
    """The point of a grid that lies deepest inside a polygon (n, 2), and how deep."""
    low, high = outline.min(axis=0), outline.max(axis=0)
    steps = (np.arange(_GRID) + 0.5) / _GRID
    x, y = (
        a.ravel() for a in np.meshgrid(low[0] + steps * (high - low)[0], low[1] + steps * (high - low)[1])
    )
    start, end = outline, np.roll(outline, -1, axis=0)
    step = end - start
    rise = np.where(step[:, 1] == 0.0, 1.0, step[:, 1])
    crossed = (start[:, 1] > y[:, None]) != (end[:, 1] > y[:, None])
    at = start[:, 0] + (y[:, None] - start[:, 1]) / rise * step[:, 0]
    inside = (crossed & (x[:, None] < at)).sum(axis=1) % 2 == 1
    length = np.maximum((step**2).sum(axis=1), 1e-12)
    away_x, away_y = x[:, None] - start[:, 0], y[:, None] - start[:, 1]
    t = np.clip((away_x * step[:, 0] + away_y * step[:, 1]) / length, 0.0, 1.0)
    distance = np.hypot(away_x - t * step[:, 0], away_y - t * step[:, 1]).min(axis=1)
    depth = np.where(inside, distance, 0.0)
    best = int(depth.argmax())
    return (float(x[best]), float(y[best])), float(depth[best])
