"""Sewing patterns as SVG drawings, true to scale."""

from __future__ import annotations

from swifttailor.pattern.svg.drawing import pattern_to_svg, write_svg

__all__ = ["pattern_to_svg", "write_svg"]
