"""Parametric garments: body measurements and a few options in, a sewing pattern out. See docs/drafts.md."""

from __future__ import annotations

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
