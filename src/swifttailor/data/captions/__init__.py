"""Captions written from the pattern itself: measured facts, claims about them, and words for the claims."""

from __future__ import annotations

from swifttailor.data.captions.claims import CLAIM_TYPES, Claim, claims_of
from swifttailor.data.captions.facts import GarmentFacts
from swifttailor.data.captions.measure import measure_facts
from swifttailor.data.captions.writing import STYLES, Caption, write_caption, write_captions

__all__ = [
    "CLAIM_TYPES",
    "STYLES",
    "Caption",
    "Claim",
    "GarmentFacts",
    "claims_of",
    "measure_facts",
    "write_caption",
    "write_captions",
]
