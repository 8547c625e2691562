"""GarmentSewer (paper, Sec. 4.3): the network that turns a pattern's images into its geometry image.

May import ggi, draping (its coarse drape), networks and what lies below them.
"""

from __future__ import annotations
