"""The stitched garment, its files (GLB, OBJ, PLY, STL, USD), its folder and its preview.

May import render, panel_mesh, body and what lies below them.
"""

from __future__ import annotations

from swifttailor.garment.garment import Garment

__all__ = ["Garment"]
