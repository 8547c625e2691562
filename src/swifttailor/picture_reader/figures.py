"""How many people a picture shows, as far as a reader cares."""

from __future__ import annotations

from typing import Literal

Figures = Literal["none", "one", "several"]
FIGURES: tuple[Figures, ...] = ("none", "one", "several")
"""Nobody who wears a garment, and no garment by itself; one; more than one, side by side."""
