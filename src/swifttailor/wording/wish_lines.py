"""Wishes in words, for people."""

from __future__ import annotations

from swifttailor.describing.claims import CLAIM_TYPES, Claim
from swifttailor.describing.differences import QUANTITIES, Change, Step


def wish_line(change: Change) -> str:
    """A wish on one line: ``where the hem of a dress or skirt ends: knee``."""
    if isinstance(change, Step):
        more = "more" if change.direction > 0 else "less"
        quantity = QUANTITIES[change.quantity]
        by = "" if change.amount is None else f" by {change.amount:g}{' cm' if quantity.in_cm else ''}"
        return f"{quantity.about}: {more}{by}"
    return claim_line(change.claim)


def claim_line(claim: Claim) -> str:
    """A claim on one line."""
    about = CLAIM_TYPES[claim.name].about
    if isinstance(claim.value, str):
        return f"{about}: {claim.value}"
    return f"{about}: {claim.value:g}{' cm' if claim.name.endswith('_cm') else ''}"
