"""How good a prediction is: distances to the drape, gaps, penetration."""

from __future__ import annotations
