"""GarmentSewer (paper, Sec. 4.3): the network that turns a pattern's images into its geometry image."""

from __future__ import annotations
