"""Patterns for other bodies: a pattern that was drafted for one body is refitted to another (docs/sizes.md).

May import what sews, and what lies below it.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from swifttailor.first_use import loaded_on_first_use

if TYPE_CHECKING:
    from swifttailor.refitting.refitted import Refitted, fit, refit

_PUBLIC = {"Refitted": "refitted", "fit": "refitted", "refit": "refitted"}

__all__ = ["Refitted", "fit", "refit"]

__getattr__ = loaded_on_first_use(__name__, _PUBLIC)


def __dir__() -> list[str]:
    return __all__
