"""Flat triangle meshes of a pattern's panels, with seam edges sampled in matching pairs and welded.

May import pattern and what lies below it.
"""

from __future__ import annotations

from swifttailor.panel_mesh.assemble import mesh_pattern
from swifttailor.panel_mesh.triangulate import triangulate_polygon

__all__ = ["mesh_pattern", "triangulate_polygon"]
