"""The Garment Geometry Image (paper, Sec. 4.2 and Appendix B): patterns and drapes as images, and back.

May import garment, panel_mesh, pattern and what lies below them.
"""

from __future__ import annotations

from swifttailor.ggi.images import GarmentGeometryImage, encode
from swifttailor.ggi.layout import Layout, lay_out

__all__ = ["GarmentGeometryImage", "Layout", "encode", "lay_out"]
