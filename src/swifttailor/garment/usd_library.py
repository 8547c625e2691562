"""The optional package usd-core."""

from __future__ import annotations

import importlib
from types import SimpleNamespace
from typing import Any

from swifttailor.errors import MissingExtraError

_MODULES = ("Gf", "Sdf", "Tf", "Usd", "UsdGeom", "UsdShade", "UsdUtils", "Vt")


def load_usd(purpose: str) -> Any:
    """The modules of ``pxr`` that are used here, as attributes; loaded on first use.

    Raises:
        MissingExtraError: usd-core is not installed; the message starts with `purpose`.
    """
    try:
        return SimpleNamespace(**{name: importlib.import_module(f"pxr.{name}") for name in _MODULES})
    except ImportError:
        raise MissingExtraError("usd-core", "usd", purpose) from None
