"""Patterns for other bodies: drafted for one and refitted to another, or drafted for each (docs/sizes.md).

May import what sews, and what lies below it.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from swifttailor.first_use import loaded_on_first_use

if TYPE_CHECKING:
    from swifttailor.refitting.designs import draft_design
    from swifttailor.refitting.refitted import Refitted, fit, refit

_PUBLIC = {"Refitted": "refitted", "draft_design": "designs", "fit": "refitted", "refit": "refitted"}

__all__ = ["Refitted", "draft_design", "fit", "refit"]

__getattr__ = loaded_on_first_use(__name__, _PUBLIC)


def __dir__() -> list[str]:
    return __all__
