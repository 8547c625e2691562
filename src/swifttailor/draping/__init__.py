"""Physics: flat panels are sewn together on a body and hang to rest (the paper's ground truth, Sec. 5.1).

May import garment, panel_mesh, body and what lies below them.
"""

from __future__ import annotations

from swifttailor.draping.drape import drape
from swifttailor.draping.engine import Engine, Settled, SewnGarment
from swifttailor.draping.engines import register_engine
from swifttailor.draping.fabric import Fabric
from swifttailor.draping.known_fabrics import FABRICS, get_fabric

__all__ = ["FABRICS", "Engine", "Fabric", "Settled", "SewnGarment", "drape", "get_fabric", "register_engine"]
