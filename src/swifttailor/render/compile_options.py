"""How numba compiles the loops that draw."""

from __future__ import annotations

from typing import Any

EXACT: dict[str, Any] = {"cache": True, "error_model": "numpy", "no_cfunc_wrapper": True}
"""Options of `numba.njit` where rounding stays as written. A wrapper for C takes a seventh of the compiler's
time, and nothing calls it."""
FAST: dict[str, Any] = EXACT | {"fastmath": {"reassoc", "contract", "arcp", "nsz"}}
"""Options of `numba.njit` where rounding may differ; what is not finite stays so."""
HELPER: dict[str, Any] = FAST | {"no_cpython_wrapper": True}
"""The same for functions that only compiled loops call: Python cannot."""
