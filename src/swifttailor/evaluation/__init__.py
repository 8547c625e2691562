"""How good a prediction is: distances to the drape, gaps, penetration.

May import data, tailor and everything below them.
"""

from __future__ import annotations
