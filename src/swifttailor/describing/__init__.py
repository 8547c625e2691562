"""What a pattern shows: facts measured on it, claims about it, and what tells two garments apart.

May import pattern, body and what lies below them.
"""

from __future__ import annotations

from swifttailor.describing.claims import CLAIM_TYPES, Claim, claims_of
from swifttailor.describing.facts import GarmentFacts
from swifttailor.describing.measuring import measure_facts

__all__ = ["CLAIM_TYPES", "Claim", "GarmentFacts", "claims_of", "measure_facts"]
