"""How numba compiles the loops that draw."""

from __future__ import annotations

from typing import Any

FAST: dict[str, Any] = {
    "cache": True,
    "fastmath": {"reassoc", "contract", "arcp", "nsz"},
    "error_model": "numpy",
}
"""Options of `numba.njit` where rounding may differ; what is not finite stays so."""
