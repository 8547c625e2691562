"""The pattern window as a test sees it: where panels, edges and points are on the screen."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

_EDGE = """([panel, edge, share]) => {
  const path = document.querySelector(`.panel[data-panel="${panel}"] .edge[data-edge="${edge}"]`);
  const place = path.getPointAtLength(share * path.getTotalLength()).matrixTransform(path.getScreenCTM());
  return [place.x, place.y];
}"""
_EDGES = """(panel) => [...document.querySelectorAll(`.panel[data-panel="${panel}"] .edge`)].map((path) => ({
  edge: Number(path.dataset.edge), seam: path.dataset.seam === undefined ? null : Number(path.dataset.seam),
  length: path.getTotalLength(), path: path.getAttribute("d") }))"""


class PatternDrawing:
    """Of a page that shows the studio."""

    def __init__(self, page: Any) -> None:
        self.page = page

    def open(self, path: Path) -> None:
        """Opens a pattern file as a user does, and waits for its garment."""
        # Told on the page that the window shows before: it is of the same origin.
        self.page.evaluate("localStorage.setItem('swifttailor.toured', 'true')")
        self.page.goto("/")
        self.page.wait_for_selector(".pattern-window .panel")
        self.page.set_input_files("#file-input", str(path))
        self.page.wait_for_function(
            "(names) => names.every((n) => document.querySelector(`.panel[data-panel='${n}']`))"
            " && document.querySelectorAll('.panel').length === names.length",
            arg=list(json.loads(path.read_text())["pattern"]["panels"]),
        )
        self.wait_until_sewn()

    def wait_until_sewn(self) -> None:
        """Waits until findings and garment are those of what is drawn."""
        self.page.wait_for_function(
            "() => document.querySelector('.stage-note')?.dataset.state !== 'sewing'"
            " && !document.querySelector('.findings-badge').textContent.includes('Checking')"
        )

    def edges(self, panel: str) -> list[dict[str, Any]]:
        """Edges of a panel: number, seam, length in cm, path in the panel's frame."""
        return self.page.evaluate(_EDGES, panel)

    def vertices(self, panel: str) -> list[tuple[float, float]]:
        """Points of a panel in its own frame, cm."""
        starts = [re.match(r"M(\S+?),(\S+?)[A-Z]", e["path"]) for e in self.edges(panel)]
        return [(float(m[1]), float(m[2])) for m in starts if m is not None]

    def on_edge(self, panel: str, edge: int, share: float = 0.5) -> tuple[float, float]:
        """Where a share of an edge's length is on the screen, px."""
        x, y = self.page.evaluate(_EDGE, [panel, edge, share])
        return x, y

    def lowest_free_edge(self, panel: str) -> int:
        """The hem, mostly."""
        free = [e["edge"] for e in self.edges(panel) if e["seam"] is None]
        return max(free, key=lambda edge: self.on_edge(panel, edge)[1])

    def scale(self) -> float:
        """Pixels per cm."""
        return self.page.evaluate("() => document.querySelector('.panel').parentElement.getScreenCTM().a")

    def drag(self, start: tuple[float, float], by_cm: tuple[float, float], *, steps: int = 8) -> str:
        """Drags by so many cm to the right and down; returns what the window read off before letting go."""
        scale = self.scale()
        mouse = self.page.mouse
        mouse.move(*start)
        mouse.down()
        for k in range(1, steps + 1):
            share = k / steps * scale
            mouse.move(start[0] + share * by_cm[0], start[1] + share * by_cm[1])
        reading = self.page.locator(".reading").inner_text()
        mouse.up()
        return reading

    def picture_of_garment(self) -> bytes:
        """The garment alone as PNG: nothing selected or pointed at, no notes over it."""
        self.wait_until_sewn()
        self.page.mouse.move(5, 5)
        self.page.locator(".pattern-sheet").press("Escape")
        self.page.wait_for_timeout(600)
        hide = ".garment-window .stage-note, .notices { visibility: hidden }"
        return self.page.locator(".garment-window canvas").screenshot(style=hide)
