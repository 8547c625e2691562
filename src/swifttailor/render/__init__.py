"""Pictures of garments on a body, drawn on one CPU core in plain numpy."""

from __future__ import annotations

from swifttailor.render.camera import Camera
from swifttailor.render.color import to_linear
from swifttailor.render.preview import body_surface, cloth_surface, render_preview
from swifttailor.render.surface import LineSet, Surface
from swifttailor.render.view import render_view

__all__ = [
    "Camera",
    "LineSet",
    "Surface",
    "body_surface",
    "cloth_surface",
    "render_preview",
    "render_view",
    "to_linear",
]
