"""Physics: flat panels are sewn together on a body and hang to rest (the paper's ground truth, Sec. 5.1).

May import garment, panel_mesh, body and what lies below them.
"""

from __future__ import annotations

from swifttailor.draping.drape import ENGINES, drape
from swifttailor.draping.fabric import FABRICS, Fabric, get_fabric

__all__ = ["ENGINES", "FABRICS", "Fabric", "drape", "get_fabric"]
