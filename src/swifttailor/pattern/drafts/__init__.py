"""Parametric garments: body measurements and a few options in, a sewing pattern out. See docs/drafts.md.

The names below are loaded when they are first used: who only needs a body's landmarks or a sleeve's outline
does not load all garments.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from swifttailor.first_use import loaded_on_first_use

if TYPE_CHECKING:
    from swifttailor.pattern.drafts.measurements import DraftMeasurements, Measurements
    from swifttailor.pattern.drafts.options import Option, OptionField
    from swifttailor.pattern.drafts.registry import DraftInfo, draft, find_draft, list_drafts

_PUBLIC = {
    "DraftInfo": "registry",
    "DraftMeasurements": "measurements",
    "Measurements": "measurements",
    "Option": "options",
    "OptionField": "options",
    "draft": "registry",
    "find_draft": "registry",
    "list_drafts": "registry",
}

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

__getattr__ = loaded_on_first_use(__name__, _PUBLIC)
