"""Pictures of garments on a body, drawn on one CPU core.

May import pattern, body, panel_mesh and what lies below them; it knows surfaces, not garments.
"""

from __future__ import annotations

from pathlib import Path

from swifttailor.numba_cache import provide_numba_cache
from swifttailor.render.camera import Camera
from swifttailor.render.color import to_linear
from swifttailor.render.lighting import STUDIO, Light, Lighting
from swifttailor.render.prints import Checks, Dots, Plain, Stripes
from swifttailor.render.surface import LineSet, Print, Surface
from swifttailor.render.view import render_view

provide_numba_cache(Path(__file__).parent)  # before any kernel is imported

__all__ = [
    "STUDIO",
    "Camera",
    "Checks",
    "Dots",
    "Light",
    "Lighting",
    "LineSet",
    "Plain",
    "Print",
    "Stripes",
    "Surface",
    "render_view",
    "to_linear",
]
