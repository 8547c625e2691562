"""SwiftTailor: sewing patterns to stitched 3D garments.

The public names below are loaded on first use, so that ``import swifttailor`` and ``swifttailor --help``
stay fast.
"""

from __future__ import annotations

import importlib
from typing import Any

__version__ = "0.1.0"

_PUBLIC = {
    "Body": "swifttailor.body",
    "Garment": "swifttailor.garment",
    "Pattern": "swifttailor.pattern",
    "SwiftTailorError": "swifttailor.errors",
    "Tailor": "swifttailor.tailor",
    "check_pattern": "swifttailor.pattern",
    "drape": "swifttailor.draping",
    "draft": "swifttailor.pattern.drafts",
    "load_pattern": "swifttailor.pattern",
}

__all__ = ["__version__", *sorted(_PUBLIC)]


def __getattr__(name: str) -> Any:
    """Imports a public name when it is first used (PEP 562)."""
    if name in _PUBLIC:
        return getattr(importlib.import_module(_PUBLIC[name]), name)
    raise AttributeError(f"module 'swifttailor' has no attribute '{name}'")


def __dir__() -> list[str]:
    return __all__
