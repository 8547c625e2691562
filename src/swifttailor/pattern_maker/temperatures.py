"""How freely patterns are drawn."""

from __future__ import annotations

HIGHEST_TEMPERATURE = 10.0
USUAL_TEMPERATURE = 0.2
"""Between always the same and anything; `confidence` is measured at it."""
