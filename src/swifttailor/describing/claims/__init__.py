"""What can be said about garments: a documented set of statements, each recomputable from a pattern."""

from __future__ import annotations

from swifttailor.describing.claims.claim import CLAIM_TYPES, Claim, ClaimType, claims_of

__all__ = ["CLAIM_TYPES", "Claim", "ClaimType", "claims_of"]
