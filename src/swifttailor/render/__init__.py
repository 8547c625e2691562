"""Pictures of garments on a body, drawn on one CPU core in plain numpy."""

from __future__ import annotations

from swifttailor.render.camera import Camera
from swifttailor.render.color import to_linear
from swifttailor.render.lighting import STUDIO, Light, Lighting
from swifttailor.render.preview import body_surface, cloth_surface, render_preview
from swifttailor.render.prints import Checks, Dots, Plain, Stripes
from swifttailor.render.surface import LineSet, Print, Surface
from swifttailor.render.view import render_view

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
    "body_surface",
    "cloth_surface",
    "render_preview",
    "render_view",
    "to_linear",
]
