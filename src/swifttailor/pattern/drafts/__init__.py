"""Parametric garments: body measurements and a few options in, a sewing pattern out. See docs/drafts.md.

The names below are loaded when they are first used: who only needs a body's landmarks or a sleeve's outline
does not load all garments.
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from swifttailor.pattern.drafts.measurements import DraftMeasurements, Measurements
    from swifttailor.pattern.drafts.options import Option, OptionField
    from swifttailor.pattern.drafts.registry import DraftInfo, draft, find_draft, list_drafts

__all__ = [
    "DraftInfo",
    "DraftMeasurements",
    "Measurements",
    "Option",
    "OptionField",
    "draft",
    "find_draft",
    "list_drafts",
]

_FILES = {
    "DraftMeasurements": "measurements",
    "Measurements": "measurements",
    "Option": "options",
    "OptionField": "options",
}


def __getattr__(name: str) -> Any:
    """Imports a public name when it is first used (PEP 562)."""
    if name in __all__:
        return getattr(importlib.import_module(f"{__name__}.{_FILES.get(name, 'registry')}"), name)
    raise AttributeError(f"module '{__name__}' has no attribute '{name}'")
